import {
  BackSide, BufferAttribute, BufferGeometry, Color, FrontSide, Mesh, PerspectiveCamera, Scene, ShaderMaterial, Vector2, Vector3, Vector4, WebGLRenderer,
} from "three";
import { frameOf, opening, type Orbit } from "../../editor/surface/orbit.ts";
import type { Shade } from "../../editor/surface/solid.ts";
import { triangles, type SurfaceMesh } from "../../kernel/surface/surface-mesh.ts";
import { fragmentShader, vertexShader } from "./shaders.ts";

/** The surface drawn by the graphics card. Everything of three.js is in this file and its shader. */

export interface Colours {
  readonly paper: string;
  readonly front: string;
  readonly back: string;
  readonly ink: string;
  readonly tint: string;
  readonly cool: string;
  readonly warm: string;
}

export interface Region {
  readonly from: readonly [number, number];
  readonly size: readonly [number, number];
}

export interface Picture {
  readonly mesh: SurfaceMesh;
  readonly orbit: Orbit;
  readonly shade: Shade;
  readonly iso: boolean;
  readonly colours: Colours;
  /** What a drag is changing. */
  readonly regions: readonly Region[];
  /** 0 for an open direction. */
  readonly period: readonly [number, number];
  /** Iso-lines to a unit of the parameter. */
  readonly isoStep: number;
  /** Turns Gaussian curvature into −1 … 1. */
  readonly curvatureScale: number;
  readonly width: number;
  readonly height: number;
  readonly ratio: number;
}

export interface ShadedView {
  draw(picture: Picture): void;
  dispose(): void;
}

const shades: Readonly<Record<Shade, number>> = { solid: 0, wire: 1, normals: 2, curvature: 3, zebra: 4 };
const mostRegions = 8;
const colourNames = ["front", "back", "paper", "ink", "tint", "cool", "warm"] as const;
/** The numbers of a vertex: what the mesh calls them, what the shader does, and how many they are. */
const vertexParts = [["positions", "position", 3], ["normals", "normal", 3], ["parameters", "parameter", 2], ["curvature", "curvature", 1]] as const;

/** `lost` is told when the graphics card takes the context away and when it gives it back. */
export function createShadedView(canvas: HTMLCanvasElement, lost: (gone: boolean) => void): ShadedView | null {
  const context = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "low-power" });
  if (context === null) return null;
  const life = new AbortController();
  watchContext(canvas, lost, life.signal);
  return new Shaded(new WebGLRenderer({ canvas, context, antialias: true }), life);
}

function watchContext(canvas: HTMLCanvasElement, lost: (gone: boolean) => void, signal: AbortSignal): void {
  // The default is to give up: a context that was lost comes back only to those who say that they wait for it.
  canvas.addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    lost(true);
  }, { signal });
  canvas.addEventListener("webglcontextrestored", () => lost(false), { signal });
}

class Shaded implements ShadedView {
  readonly #renderer: WebGLRenderer;
  readonly #life: AbortController;
  readonly #scene = new Scene();
  readonly #camera = new PerspectiveCamera((opening * 180) / Math.PI, 1, 0.01, 1000);
  readonly #uniforms = freshUniforms();
  /**
   * Outside and inside. Of sheets that lie on each other, as those of the Roman surface do, the outside is seen: the
   * inside is a little farther away.
   */
  readonly #sides = [FrontSide, BackSide].map((side) => new Mesh(new BufferGeometry(), new ShaderMaterial({
    vertexShader, fragmentShader, uniforms: this.#uniforms, side, polygonOffset: side === BackSide, polygonOffsetFactor: 2, polygonOffsetUnits: 16,
  })));
  #geometry = new BufferGeometry();
  readonly #clear = new Color();
  #shown: SurfaceMesh | null = null;

  constructor(renderer: WebGLRenderer, life: AbortController) {
    this.#renderer = renderer;
    this.#life = life;
    this.#camera.up.set(0, 0, 1);
    for (const side of this.#sides) side.frustumCulled = false;
    this.#scene.add(...this.#sides);
  }

  draw(picture: Picture): void {
    if (picture.width < 1 || picture.height < 1) return;
    this.#renderer.setPixelRatio(picture.ratio);
    this.#renderer.setSize(picture.width, picture.height, false);
    this.#look(picture);
    this.#put(picture.mesh);
    this.#style(picture);
    this.#renderer.render(this.#scene, this.#camera);
  }

  dispose(): void {
    this.#life.abort();
    this.#geometry.dispose();
    for (const { material } of this.#sides) material.dispose();
    this.#renderer.dispose();
  }

  #look({ orbit, width, height }: Picture): void {
    const { eye } = frameOf(orbit);
    const camera = this.#camera;
    camera.position.set(...eye);
    camera.aspect = width / Math.max(1, height);
    camera.near = orbit.distance / 100;
    camera.far = orbit.distance * 40;
    camera.lookAt(...orbit.target);
    camera.updateProjectionMatrix();
    this.#uniforms.eye.value.set(...eye);
  }

  /** What has stayed the same is not sent to the graphics card anew. */
  #put(mesh: SurfaceMesh): void {
    const shown = this.#shown;
    if (mesh === shown) return;
    const sameShape = shown !== null && shown.rows === mesh.rows && shown.cols === mesh.cols;
    if (!sameShape) {
      this.#geometry.dispose();
      this.#geometry = emptyGeometry(mesh);
      for (const side of this.#sides) side.geometry = this.#geometry;
    }
    for (const [part, name] of vertexParts) {
      const values = mesh[part];
      if (values !== null && !(sameShape && values === shown[part])) setNumbers(this.#geometry, name, values);
    }
    this.#shown = mesh;
  }

  #style({ colours, shade, iso, regions, period, isoStep, curvatureScale }: Picture): void {
    const uniforms = this.#uniforms;
    // Colours of the page are what the screen shows: no conversion on the way.
    for (const name of colourNames) uniforms[name].value.setStyle(colours[name], "");
    uniforms.shade.value = shades[shade];
    uniforms.iso.value = iso;
    uniforms.isoStep.value = isoStep;
    uniforms.curvatureScale.value = curvatureScale;
    uniforms.period.value.set(...period);
    uniforms.regions.value = Math.min(mostRegions, regions.length);
    regions.slice(0, mostRegions).forEach(({ from, size }, i) => uniforms.region.value[i]?.set(from[0], size[0], from[1], size[1]));
    // The clear colour alone is converted by the renderer, so it is given as one that has not been.
    this.#renderer.setClearColor(this.#clear.setStyle(colours.paper), 1);
  }
}

function freshUniforms() {
  const colour = (): { value: Color } => ({ value: new Color() });
  return {
    front: colour(), back: colour(), paper: colour(), ink: colour(), tint: colour(), cool: colour(), warm: colour(),
    shade: { value: 0 }, iso: { value: true }, isoStep: { value: 1 }, curvatureScale: { value: 1 },
    eye: { value: new Vector3() }, period: { value: new Vector2() },
    region: { value: Array.from({ length: mostRegions }, () => new Vector4()) }, regions: { value: 0 },
  };
}

/** The triangles of a mesh, and room for its numbers. */
function emptyGeometry({ rows, cols }: SurfaceMesh): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setIndex(new BufferAttribute(triangles(rows, cols), 1));
  for (const [, name, width] of vertexParts) geometry.setAttribute(name, new BufferAttribute(new Float32Array(width * rows * cols), width));
  return geometry;
}

function setNumbers(geometry: BufferGeometry, name: string, values: ArrayLike<number>): void {
  const attribute = geometry.getAttribute(name);
  if (!(attribute instanceof BufferAttribute)) return;
  attribute.array.set(values);
  attribute.needsUpdate = true;
}
