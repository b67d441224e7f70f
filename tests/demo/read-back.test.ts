import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { TensorSurface } from "expline";
import { siRust } from "simple-icons";
import { Mesh, type BufferGeometry, type Object3D } from "three";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { OBJLoader } from "three/examples/jsm/loaders/OBJLoader.js";
import { boxDiagonal, directedDistance, useBrowser, type Demo, type Pair } from "./page.ts";

/** What leaves the page, read by who knows nothing of it: the browser's own paths, and the loaders of three.js. */

const { open } = useBrowser();

interface ReadPath {
  readonly length: number;
  readonly box: readonly [left: number, top: number, right: number, bottom: number];
  readonly places: Pair[];
}

/** Each subpath as the browser measures it. */
function readByBrowser(demo: Demo, d: string, places: number): Promise<ReadPath[]> {
  return demo.page.evaluate(([text, count]) => {
    const picture = document.createElementNS("http://www.w3.org/2000/svg", "svg");
    document.body.append(picture);
    const read = text.split(/(?=M)/u).map((part) => {
      const path = document.createElementNS("http://www.w3.org/2000/svg", "path");
      path.setAttribute("d", part);
      picture.append(path);
      const { x, y, width, height } = path.getBBox();
      const length = path.getTotalLength();
      const at = (i: number): Pair => {
        const place = path.getPointAtLength((i / count) * length);
        return [place.x, place.y];
      };
      return { length, box: [x, y, x + width, y + height] as const, places: Array.from({ length: count }, (_, i) => at(i)) };
    });
    picture.remove();
    return read;
  }, [d, places] as const);
}

const WORKS = [
  ["a heart", "#/curve?sample=heart", ""],
  ["interpolated points", "#/curve?sample=net-64", ""],
  ["a logo", "#/curve", siRust.svg],
  ["a trace", "#/trace?sample=trace-logo", ""],
  ["a fit", "#/fit?sample=fit-roundrect", ""],
] as const;

for (const [name, hash, picture] of WORKS) {
  test(`of ${name} the browser measures what the page says: length, size, number of bytes, and how far the path is from the curve`, async (t) => {
    const demo = await open(t, hash);
    if (picture !== "") {
      await demo.byId("btn-import").click();
      await demo.byId("import-text").fill(picture);
      await demo.byId("import-replace").check();
      await demo.byId("import-apply").click();
      await demo.byId("import-apply").waitFor({ state: "detached" });
      await demo.idle();
    }
    const metrics = hash.startsWith("#/curve") ? { length: await demo.metric("m-length"), contours: await demo.metric("m-contours") } : null;
    const bytes = await demo.metric("m-bytes");
    await demo.byId("btn-export").click();
    await demo.byId("export-dialog").waitFor();
    assert.equal(await demo.metric("export-bytes"), bytes, "bytes below the stage and in the dialog");
    await demo.byId("export-segments").selectOption("cubics");
    await demo.idle();
    const stated = await demo.metric("export-deviation");
    const d = await demo.byId("export-preview").inputValue();
    assert.equal(await demo.metric("export-bytes"), d.length);
    const read = await readByBrowser(demo, d, 400);

    const curves: Pair[][] = [];
    for (let i = 0; i < read.length; i += 1) curves.push(await demo.sample(6000, i));
    const size = boxDiagonal(curves.flat());
    // Browsers keep paths in single precision, and the curve here is a polygon of 6000 sides.
    const slack = 1e-5 * size;
    const away = read.map(({ places }, i) => directedDistance(places, curves[i] ?? [], true));
    assert.ok(Math.max(...away) <= stated + slack, `${Math.max(...away)} away, said to be ${stated}`);
    assert.ok(Math.max(...away) >= stated / 2 - slack, `${Math.max(...away)} away, said to be ${stated}`);
    for (const [i, { box }] of read.entries()) {
      const [xs, ys] = [0, 1].map((k) => (curves[i] ?? []).map((place) => place[k] ?? NaN)) as [number[], number[]];
      [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)].forEach((side, k) => assert.ok(Math.abs(side - (box[k] ?? NaN)) <= stated + slack, `side ${k}: ${side} and ${box[k]}`));
    }
    if (metrics === null) return;
    assert.equal(read.length, metrics.contours);
    const length = read.reduce((sum, each) => sum + each.length, 0);
    assert.ok(Math.abs(length - metrics.length) <= 1e-3 * metrics.length, `${length} and ${metrics.length}`);
  });
}

async function downloaded(demo: Demo, id: string): Promise<Buffer> {
  const [download] = await Promise.all([demo.page.waitForEvent("download"), demo.byId(id).click()]);
  return readFile(await download.path());
}

function geometryIn(scene: Object3D): BufferGeometry {
  const found: BufferGeometry[] = [];
  scene.traverse((part) => {
    if (part instanceof Mesh) found.push(part.geometry as BufferGeometry);
  });
  const [geometry] = found;
  assert.ok(geometry !== undefined && found.length === 1, "there is one mesh");
  return geometry;
}

/** The numbers of an attribute, a triangle's corner after the other; text knows no −0. */
function corners(geometry: BufferGeometry, name: "position" | "normal"): Float32Array {
  const unfolded = geometry.index === null ? geometry : geometry.toNonIndexed();
  return Float32Array.from(unfolded.getAttribute(name).array, (value) => value + 0);
}

for (const sample of ["surf-sphere", "surf-torus", "surf-paraboloid", "surf-cylinder"]) {
  test(`OBJ and glTF of ${sample}, edited, are to three.js the vertices, normals and triangles of the library's mesh`, async (t) => {
    const demo = await open(t, `#/surface?sample=${sample}`, { viewport: { width: 1030, height: 560 } });
    await demo.focusStage();
    for (let i = 0; i < 11; i += 1) await demo.press("]");
    await demo.byId("surf-x").fill("1.2345678901");
    await demo.press("Enter");
    const { u, v, net } = (await demo.state()).surface;
    assert.ok(u !== undefined && v !== undefined);
    const surface = new TensorSurface({ u, v, net: net.flatMap(({ x, y, z }) => [x, y, z]) });
    await demo.byId("btn-export").click();
    await demo.byId("export-dialog").waitFor();
    await demo.slide("export-sides", 5);
    const vertices = ([from, to]: readonly [number, number], closed: boolean): number => (to - from) * 5 + (closed ? 0 : 1);
    const mesh = surface.mesh(vertices(surface.domain.u, u.closed), vertices(surface.domain.v, v.closed));
    const spread = (list: ArrayLike<number>): Float32Array => Float32Array.from([...mesh.indices].flatMap((i) => [0, 1, 2].map((k) => (list[3 * i + k] ?? NaN) + 0)));
    const [obj, gltf] = [await downloaded(demo, "export-obj"), await downloaded(demo, "export-gltf")];
    const { scene } = await new GLTFLoader().parseAsync(new Uint8Array(gltf).buffer, "");
    for (const [kind, read] of [["OBJ", new OBJLoader().parse(obj.toString())], ["glTF", scene]] as const) {
      const geometry = geometryIn(read);
      assert.deepEqual(corners(geometry, "position"), spread(mesh.positions), `positions of the ${kind}`);
      assert.deepEqual(corners(geometry, "normal"), spread(mesh.normals), `normals of the ${kind}`);
    }
    assert.deepEqual(Array.from(geometryIn(scene).getIndex()?.array ?? []), Array.from(mesh.indices));
    assert.equal(await demo.textOf("export-triangles"), String(mesh.indices.length / 3));
  });
}
