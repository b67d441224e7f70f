import { pointAt, type Kind, type Offset, type PointRef, type Side } from "../../../document/document.ts";
import "../../../styles/inspector.css";
import type { Editor, EditorState } from "../../../editor/editor.ts";
import { degreesOf, nudge, setHandlePolar, setKind, setPoint } from "../../../editor/curve/edits.ts";
import { unitOf } from "../../../kernel/unit.ts";
import { h, setAttribute } from "../../controls/dom.ts";
import { choiceField, numberField, type Field } from "../../controls/fields.ts";
import { glyph, icon, type IconName } from "../../controls/icons.ts";
import type { Section } from "../../mode/panel-parts.ts";
import { cornerRow } from "./corner-row.ts";
import { lengthField } from "./length-field.ts";

/** The numbers of a chosen point, the kind of all, and the nudge pad. Loaded when a point is chosen first. */

export function pointNumbers(editor: Editor): Section {
  const rows = [placeRow(editor), kindRow(editor), handleRow(editor, "in", "In"), handleRow(editor, "out", "Out"), cornerRow(editor), nudgePad(editor)];
  return {
    element: h("div", { class: "inspector" }, ...rows.map(({ element }) => element)),
    update(state) {
      for (const row of rows) row.update(state);
    },
  };
}

/** The point whose numbers are shown and typed: several have those of their box (`size-rows`). */
function onlyPoint({ selection }: EditorState): PointRef | undefined {
  return selection.points.length === 1 ? selection.points[0] : undefined;
}

function placeRow(editor: Editor): Section {
  const coordinate = (axis: "x" | "y", label: string, direction: string): Field<number> => lengthField(editor, {
    label,
    testid: `pt-${axis}`,
    about: `${direction}, in document units; a typed value is exact.`,
    write(value) {
      const ref = onlyPoint(editor.state.value);
      if (ref !== undefined && value !== null) setPoint(editor, ref, { [axis]: value }, `type-${axis}`);
    },
  });
  const [x, y] = [coordinate("x", "X", "Across"), coordinate("y", "Y", "Down")];
  const element = h("div", { class: "pair" }, x.element, y.element);
  return {
    element,
    update(state) {
      const ref = onlyPoint(state);
      element.hidden = ref === undefined;
      const point = ref === undefined ? undefined : pointAt(state.curve, ref);
      x.show(point?.x ?? null);
      y.show(point?.y ?? null);
    },
  };
}

function kindRow(editor: Editor): Section {
  const kind = choiceField<Kind>({
    label: "Kind",
    testid: "pt-kind",
    about: "How the two handles relate.",
    options: [
      { value: "symmetric", label: "Symmetric", about: "Opposite handles of equal length (S)." },
      { value: "smooth", label: "Smooth", about: "Opposite handles, each with its own length." },
      { value: "cusp", label: "Cusp", about: "Independent handles (C).", mark: glyph("cusp") },
    ],
    write: (value) => setKind(editor, value),
  });
  return {
    element: kind.element,
    update(state) {
      kind.element.hidden = isWithoutHandles(state);
      kind.show(kindOf(state));
    },
  };
}

function handleRow(editor: Editor, side: Side, name: string): Section {
  const write = (part: "length" | "angle") => (value: number | null): void => {
    const ref = onlyPoint(editor.state.value);
    if (ref !== undefined && value !== null) setHandlePolar(editor, ref, side, { [part]: value }, `type-${side}-${part}`);
  };
  const length = lengthField(editor, {
    label: "Length",
    testid: `${side}-len`,
    about: `Length of the ${name} handle: a third of the tangent vector.`,
    least: 0,
    write: write("length"),
  });
  const angle = numberField({
    label: "Angle",
    testid: `${side}-ang`,
    about: `Direction of the ${name} handle, counter-clockwise from 3 o'clock.`,
    least: -360,
    most: 360,
    step: 1,
    unit: "°",
    write: write("angle"),
  });
  const label = h("span", { class: "handle-name" }, glyph("handle"), name);
  const element = h("div", { class: "handle-row", role: "group", "aria-label": `${name} handle` }, label, length.element, angle.element);
  return {
    element,
    update(state) {
      const handle = handleOf(state, side);
      element.hidden = isWithoutHandles(state) || onlyPoint(state) === undefined;
      length.show(handle === null ? null : Math.hypot(handle.dx, handle.dy));
      angle.show(handle === null ? null : degreesOf(handle));
    },
  };
}

/** Points of an interpolating contour have no tangents. */
function isWithoutHandles({ selection, curve }: EditorState): boolean {
  const first = selection.points[0];
  return first !== undefined && curve.contours[first.contour]?.family === "interpolating";
}

/** A handle of the only point that is chosen; null where there is none to be shown. */
function handleOf(state: EditorState, side: Side): Offset | null {
  const ref = onlyPoint(state);
  if (ref === undefined || !hasHandle(state, ref, side)) return null;
  return pointAt(state.curve, ref)?.[side] ?? null;
}

/** The free side of an open contour's end has no segment for its handle. */
function hasHandle(state: EditorState, ref: PointRef, side: Side): boolean {
  const contour = state.curve.contours[ref.contour];
  if (contour === undefined) return false;
  return contour.closed || (side === "in" ? ref.index > 0 : ref.index < contour.points.length - 1);
}

/** Null where there is no point; undefined of points of several kinds, any of which all of them may become. */
function kindOf({ selection, curve }: EditorState): Kind | null | undefined {
  const [first, ...others] = selection.points;
  const kind = first === undefined ? undefined : pointAt(curve, first)?.kind;
  if (kind === undefined) return null;
  return others.every((ref) => pointAt(curve, ref)?.kind === kind) ? kind : undefined;
}

/** Moving without dragging: four buttons, Shift for ten units of the drawing, Alt for a tenth. */
function nudgePad(editor: Editor): Section {
  const directions: readonly (readonly [string, IconName, number, number])[] = [
    ["left", "left", -1, 0],
    ["up", "up", 0, -1],
    ["down", "down", 0, 1],
    ["right", "right", 1, 0],
  ];
  const buttons = directions.map(([name, shape, dx, dy]) => {
    const button = h("button", {
      class: "icon-button",
      type: "button",
      testid: `nudge-${name}`,
      "aria-label": `Nudge ${name}`,
      click: (event: MouseEvent) => {
        const by = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
        nudge(editor, dx * by, dy * by);
      },
    }, icon(shape));
    return { name, button };
  });
  return {
    element: h("div", { class: "field nudge", role: "group", "aria-label": "Nudge" },
      h("span", { class: "field-label" }, "Nudge"),
      h("span", { class: "nudge-pad" }, ...buttons.map(({ button }) => button)),
    ),
    update({ curve }) {
      const unit = unitOf(curve);
      const by = (times: number): string => String(Number((times * unit).toPrecision(1)));
      for (const { name, button } of buttons) setAttribute(button, "title", `Move ${name} by ${by(1)}; with Shift by ${by(10)}, with Alt by ${by(0.1)}`);
    },
  };
}
