import { baseCount, pointAt, type ControlPoint, type Kind, type PointRef, type Side } from "../../document/document.ts";
import type { EditorState } from "../../editor/editor.ts";
import { nudge, setHandlePolar, setKind, setPoint } from "../../editor/curve/edits.ts";
import { late } from "../../editor/loading.ts";
import { h, setText } from "../controls/dom.ts";
import { choiceField, numberField, type Field } from "../controls/fields.ts";
import { glyph, icon, type IconName } from "../controls/icons.ts";
import type { Section } from "../mode/panel-parts.ts";
import type { Shell } from "../shell.ts";

const limit = 1e6;

/** Degrees counter-clockwise from 3 o'clock, as people draw angles; the screen's y points down. */
function angleOf(point: ControlPoint, side: Side): number {
  const { dx, dy } = point[side];
  return dx === 0 && dy === 0 ? 0 : (-Math.atan2(dy, dx) * 180) / Math.PI + 0;
}

/** The chosen point in numbers: typed values are exact. Several points: what they share, and the nudge pad. */
export function inspectorSection(shell: Shell): Section {
  const { editor } = shell;
  const only = (): PointRef | undefined => {
    const { points } = editor.state.value.selection;
    return points.length === 1 ? points[0] : undefined;
  };
  const place = (axis: "x" | "y") => (value: number | null): void => {
    const ref = only();
    if (ref !== undefined && value !== null) setPoint(editor, ref, { [axis]: value }, `type-${axis}`);
  };
  const polar = (side: Side, part: "length" | "angle") => (value: number | null): void => {
    const ref = only();
    if (ref !== undefined && value !== null) setHandlePolar(editor, ref, side, { [part]: value }, `type-${side}-${part}`);
  };
  const common = { least: -limit, most: limit, step: 1 };
  const x = numberField({ ...common, label: "X", testid: "pt-x", about: "Across, in document units; a typed value is exact.", write: place("x") });
  const y = numberField({ ...common, label: "Y", testid: "pt-y", about: "Down, in document units; a typed value is exact.", write: place("y") });
  const kind = choiceField<Kind>({
    label: "Kind",
    testid: "pt-kind",
    about: "How the two handles hang together.",
    options: [
      { value: "symmetric", label: "Symmetric", about: "Handles opposite and equally long (S)." },
      { value: "smooth", label: "Smooth", about: "Handles opposite, each with its own length." },
      { value: "cusp", label: "Cusp", about: "Each handle goes its own way (C).", mark: glyph("cusp") },
    ],
    write: (value) => setKind(editor, value),
  });
  const lengths = { least: 0, most: limit, step: 1 };
  const angles = { least: -360, most: 360, step: 1, unit: "°" };
  const handle = (side: Side, name: string): { length: Field<number>; angle: Field<number>; element: HTMLElement } => {
    const length = numberField({
      ...lengths,
      label: "Length",
      testid: `${side}-len`,
      about: `Length of the ${name} handle: a third of the tangent vector.`,
      write: polar(side, "length"),
    });
    const angle = numberField({
      ...angles,
      label: "Angle",
      testid: `${side}-ang`,
      about: `Direction of the ${name} handle, counter-clockwise from 3 o'clock.`,
      write: polar(side, "angle"),
    });
    return { length, angle, element: h("div", { class: "handle-row", role: "group", "aria-label": `${name} handle` },
      h("span", { class: "handle-name" }, glyph("handle"), name),
      length.element,
      angle.element,
    ) };
  };
  const arriving = handle("in", "In");
  const leaving = handle("out", "Out");
  const title = h("h3", { class: "section-title" }, "Selected");
  const which = h("span", { class: "section-note num" });
  const single = h("div", { class: "inspector" }, h("div", { class: "pair" }, x.element, y.element), kind.element, arriving.element, leaving.element);
  const pad = nudgePad(shell);
  const several = ({ selection }: EditorState): boolean => selection.points.length > 1;
  const rows = h("div", { class: "inspector" });
  late(editor, several, () => import("./align-rows.ts"), ({ alignRows }) => rows.append(...alignRows(editor)));
  const none = h("p", { class: "quiet" }, "Nothing. Click a point on the stage, or press ] to step through them.");
  const element = h("section", { class: "section", "aria-label": "Selected" }, h("div", { class: "section-head" }, title, which), none, single, pad, rows);

  return {
    element,
    update(state: EditorState) {
      const { points } = state.selection;
      const ref = points.length === 1 ? points[0] : undefined;
      const point = ref === undefined ? undefined : pointAt(state.curve, ref);
      none.hidden = points.length > 0;
      single.hidden = points.length === 0;
      pad.hidden = points.length === 0;
      rows.hidden = !several(state);
      setText(which, describeSelection(state));
      x.show(point?.x ?? null);
      y.show(point?.y ?? null);
      const first = points[0];
      const plain = first !== undefined && state.curve.contours[first.contour]?.family === "interpolating";
      for (const part of [kind.element, arriving.element, leaving.element]) part.hidden = plain;
      kind.show(point?.kind ?? (points.length > 1 ? sharedKind(state) : null));
      for (const [side, fields] of [["in", arriving], ["out", leaving]] as const) {
        const used = point !== undefined && ref !== undefined && hasHandle(state, ref, side);
        fields.length.show(used ? Math.hypot(point[side].dx, point[side].dy) : null);
        fields.angle.show(used ? angleOf(point, side) : null);
      }
    },
  };
}

/** The free side of an open contour's end has no segment for its handle. */
function hasHandle(state: EditorState, ref: PointRef, side: Side): boolean {
  const contour = state.curve.contours[ref.contour];
  if (contour === undefined) return false;
  return contour.closed || (side === "in" ? ref.index > 0 : ref.index < contour.points.length - 1);
}

/** The kind that all chosen points have; cusp stands for a mixture only if all are cusps, so a mixture shows the first's. */
function sharedKind(state: EditorState): Kind | null {
  const first = state.selection.points[0];
  return first === undefined ? null : (pointAt(state.curve, first)?.kind ?? null);
}

function describeSelection({ selection, curve }: EditorState): string {
  const { points } = selection;
  const first = points[0];
  if (first === undefined) return "";
  if (points.length > 1) return `${points.length} points`;
  const contour = curve.contours[first.contour];
  const of = contour === undefined ? 0 : baseCount(contour);
  if (contour !== undefined && first.index >= of) return `finer point ${first.index - of + 1} of ${contour.points.length - of}`;
  const where = curve.contours.length > 1 ? `, contour ${first.contour + 1}` : "";
  return `point ${first.index + 1} of ${of}${where}`;
}

/** Moving without dragging: four buttons, Shift for ten, Alt for a tenth. */
function nudgePad({ editor }: Shell): HTMLElement {
  const directions: readonly (readonly [string, IconName, number, number])[] = [
    ["left", "left", -1, 0],
    ["up", "up", 0, -1],
    ["down", "down", 0, 1],
    ["right", "right", 1, 0],
  ];
  const buttons = directions.map(([name, shape, dx, dy]) =>
    h("button", {
      class: "icon-button",
      type: "button",
      testid: `nudge-${name}`,
      "aria-label": `Nudge ${name}`,
      title: `Move ${name} by 1; with Shift by 10, with Alt by 0.1`,
      click: (event: MouseEvent) => {
        const by = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
        nudge(editor, dx * by, dy * by);
      },
    }, icon(shape)),
  );
  return h("div", { class: "field nudge", role: "group", "aria-label": "Nudge" },
    h("span", { class: "field-label" }, "Nudge"),
    h("span", { class: "nudge-pad" }, ...buttons),
  );
}
