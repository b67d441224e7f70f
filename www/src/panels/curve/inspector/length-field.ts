import type { Editor } from "../../../editor/editor.ts";
import { boxOfAll } from "../../../editor/actions/standard-actions.ts";
import { decimalsIn } from "../../../document/unit.ts";
import { unitOf } from "../../../kernel/unit.ts";
import { numberField, type NumberOptions } from "../../controls/fields.ts";
import { formatCoordinate } from "../../controls/format.ts";

/** What may be typed, but for drawings that are themselves as large. */
const usualLimit = 1e6;
const farthest = 1e9;

type LengthOptions = Omit<NumberOptions, "least" | "most" | "step" | "format"> & {
  /** In the drawing's units; absent: as far below 0 as above. */
  readonly least?: number;
};

/** A place or length of the drawing, in digits and steps that suit its size. */
export function lengthField(editor: Editor, { least, ...options }: LengthOptions): ReturnType<typeof numberField> {
  const unit = (): number => unitOf(editor.state.value.curve);
  const limit = (): number => {
    const { minX = 0, minY = 0, maxX = 0, maxY = 0 } = boxOfAll(editor) ?? {};
    return Math.max(-minX, -minY, maxX, maxY) > usualLimit / 10 ? farthest : usualLimit;
  };
  return numberField({
    ...options,
    get least() {
      return least === undefined ? -limit() : least * unit();
    },
    get most() {
      return limit();
    },
    get step() {
      return unit();
    },
    format: (value) => formatCoordinate(value, decimalsIn(unit(), 2)),
  });
}
