// Locals numbered anew: in the order of their first use. What is left to say of a use is then how long ago the last one
// was.

import { leb, numberOf, putTogether, takenApart } from "./wasm-functions.mjs";

/** The types of a function's locals one by one, its parameters among them. */
export const typesOf = ({ parameters, locals }) => [...parameters, ...locals.flatMap(([count, type]) => Array(count).fill(type))];

const isLocal = ([kind]) => kind === "local";

/** Types as how often each comes, one after the other. */
function runsOf(types) {
  const runs = [];
  for (const type of types) {
    const last = runs.at(-1);
    if (last?.[1] === type) last[0] += 1;
    else runs.push([1, type]);
  }
  return runs;
}

function numbered(f) {
  const types = typesOf(f);
  const first = f.parameters.length;
  const used = new Set(f.operations.flatMap(({ operands }) => operands.filter(isLocal).map(([, bytes]) => numberOf(bytes))));
  const order = [...used].filter((local) => local >= first);
  const numbers = new Map(order.map((local, place) => [local, leb(first + place)]));
  const renamed = (operand) => (isLocal(operand) ? ["local", numbers.get(numberOf(operand[1])) ?? operand[1]] : operand);
  const operations = f.operations.map(({ code, operands }) => ({ code, operands: operands.map(renamed) }));
  const locals = runsOf(order.map((local) => types[local]));
  return { parameters: f.parameters, locals, operations };
}

/** The same wasm with its locals in that order. */
export function withNumberedLocals(wasm) {
  const { before, functions, after } = takenApart(wasm);
  return putTogether({ before, functions: functions.map(numbered), after });
}
