import { noNetPoints, sameNetPoint, type NetRef } from "../../document/surface/surface.ts";
import type { Editor } from "../../editor/editor.ts";
import { netHit } from "../../editor/surface/net-hit.ts";
import type { DragAxis } from "../../editor/surface/solid.ts";
import { chooseNet, patchSolid, toggleChosen } from "../../editor/surface/surface-edits.ts";
import type { PointerSample, Tool } from "../../editor/tool.ts";
import { pressOrDrag } from "../press-or-drag.ts";
import { dragNet, type NetDrag } from "./dragging-net.ts";
import { look } from "./looking.ts";

/** Surface mode's pointer: control points are dragged, everything else turns the view. */

export interface SurfaceTool extends Tool {
  /**
   * X, Y, Z in the middle of a drag: holds it to an axis, and pressed again lets it go. False while nothing is dragged.
   */
  hold(axis: DragAxis): boolean;
}

export function createSurfaceTool(editor: Editor): SurfaceTool {
  let lastMove: NetDrag | null = null;

  const gestures = pressOrDrag<NetRef | null>({
    hit: (sample) => netHit(editor.state.value, sample.screen, sample.kind),
    begin: (start, hit) => (hit === null ? look(editor, start) : (lastMove = dragNet(editor, start, hit))),
    click: (hit, sample) => choose(editor, hit, sample.modifiers.shift),
  });

  return {
    ...gestures,
    hover: (sample) => announce(editor, sample),
    finish: () => false,
    hold(axis) {
      // The first key counts once the points move.
      if (lastMove === null || gestures.current() !== lastMove || editor.state.value.solid.drag === null) return false;
      lastMove.hold(axis);
      return true;
    },
  };
}

/** With Shift a point is chosen beside others, or no more; beside all points a click chooses none. */
function choose(editor: Editor, hit: NetRef | null, adds: boolean): void {
  if (hit === null && adds) return;
  if (hit === null) chooseNet(editor, noNetPoints);
  else if (adds) toggleChosen(editor, hit);
  else chooseNet(editor, [hit]);
}

/** The mark and the cursor say what a press would do. */
function announce(editor: Editor, { screen, kind }: PointerSample): void {
  const { solid, cursor } = editor.state.value;
  const hit = netHit(editor.state.value, screen, kind);
  const same = hit === null ? solid.hover === null : solid.hover !== null && sameNetPoint(hit, solid.hover);
  const wanted = hit === null ? "default" : "move";
  if (!same) patchSolid(editor, { hover: hit });
  if (cursor !== wanted) editor.patch({ cursor: wanted });
}
