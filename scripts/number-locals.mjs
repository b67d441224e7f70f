// Locals numbered anew: by type, and in the order of their first use. What is left to say of a use is then how long ago the last one was.

import { leb, numberOf, putTogether, takenApart } from "./wasm-functions.mjs";

/** i32, f64, v128, i64, f32: what most functions have comes first. */
const TYPES = [0x7f, 0x7c, 0x7b, 0x7e, 0x7d];

/** The types of a function's locals one by one, its parameters among them. */
export const typesOf = ({ parameters, locals }) => [...parameters, ...locals.flatMap(([count, type]) => Array(count).fill(type))];

const isLocal = ([kind]) => kind === "local";

function numbered(f) {
  const types = typesOf(f);
  const first = f.parameters.length;
  const used = new Set(f.operations.flatMap(({ operands }) => operands.filter(isLocal).map(([, bytes]) => numberOf(bytes))));
  const order = TYPES.flatMap((type) => [...used].filter((local) => local >= first && types[local] === type));
  const numbers = new Map(order.map((local, place) => [local, leb(first + place)]));
  const renamed = (operand) => (isLocal(operand) ? ["local", numbers.get(numberOf(operand[1])) ?? operand[1]] : operand);
  const operations = f.operations.map(({ code, operands }) => ({ code, operands: operands.map(renamed) }));
  const locals = TYPES.map((type) => [order.filter((local) => types[local] === type).length, type]).filter(([count]) => count > 0);
  return { parameters: f.parameters, locals, operations };
}

/** The same wasm with its locals in that order. */
export function withNumberedLocals(wasm) {
  const { before, functions, after } = takenApart(wasm);
  return putTogether({ before, functions: functions.map(numbered), after });
}
