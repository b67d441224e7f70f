import { writeState } from "../../document/file/write.ts";
import { surfaceTitle } from "../../document/surface/surface-samples.ts";
import { meshSize, objSize, surfaceGltf, surfaceObj } from "../../kernel/surface/surface-files.ts";
import { button, openDialog } from "../controls/dialog.ts";
import { h, setText } from "../controls/dom.ts";
import { sliderField } from "../controls/fields.ts";
import { formatBytes } from "../controls/format.ts";
import type { Shell } from "../shell.ts";
import { surfaceThumbnail } from "./surface-gallery.ts";

let sides = 16;

/** The surface as triangles for other programs, or as its own file to open here again. */
export function openSurfaceExport(shell: Shell): void {
  const { editor, io, toasts } = shell;
  const { surface } = editor.state.value;
  const stem = surface.sample;
  const count = h("dd", { class: "num", testid: "export-triangles" });
  const [obj, gltf] = [h("dd", { class: "num", testid: "export-obj-size" }), h("dd", { class: "num", testid: "export-gltf-size" })];
  const numbers = h("dl", { class: "export-numbers num" },
    h("div", {}, h("dt", {}, "Triangles"), count), h("div", {}, h("dt", {}, "OBJ"), obj), h("div", {}, h("dt", {}, "glTF"), gltf));
  const show = (): void => {
    slider.show(sides);
    const { rows, cols } = meshSize(surface, sides);
    const cells = (surface.u?.closed === true ? rows : rows - 1) * (surface.v?.closed === true ? cols : cols - 1);
    setText(count, String(2 * cells));
    // Positions and normals in single precision, three indices of four bytes to a triangle.
    setText(gltf, `about ${formatBytes(24 * rows * cols + 24 * cells + 1000)}`);
    setText(obj, `about ${formatBytes(objSize(surface, sides))}`);
  };
  const slider = sliderField({
    label: "Sides", testid: "export-sides", about: "How many sides each segment of the net is divided into.",
    least: 2, most: 64, step: 1, direction: "smoother", print: String,
    write: (value) => { sides = value; show(); },
  });
  show();
  const dialog = openDialog(
    { title: "Export the surface", testid: "export-dialog" },
    h("p", { class: "quiet" }, `${surfaceTitle(surface.sample)}: triangles with positions and normals. JSON keeps the exact net, to reopen it here.`),
    h("div", { class: "export-picture" }, surfaceThumbnail(surface)), slider.element, numbers,
  );
  const save = (name: string, content: Blob): void => {
    io.download(name, content);
    toasts.say(`Saved ${name}.`);
  };
  dialog.foot.append(
    button("OBJ", {
      class: "primary",
      testid: "export-obj",
      title: "Download a Wavefront OBJ file",
      click: () => save(`${stem}.obj`, new Blob([surfaceObj(surface, sides)], { type: "model/obj" })),
    }),
    button("glTF", {
      testid: "export-gltf",
      title: "Download a binary glTF file",
      click: () => save(`${stem}.glb`, new Blob([surfaceGltf(surface, sides)], { type: "model/gltf-binary" })),
    }),
    button("JSON", {
      testid: "export-json",
      title: "Download the surface to reopen it here",
      click: () => save(`${stem}.json`, new Blob([writeState(editor.getState())], { type: "application/json" })),
    }),
  );
}
