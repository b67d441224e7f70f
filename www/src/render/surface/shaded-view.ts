import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Mesh, PerspectiveCamera, Scene, ShaderMaterial, Vector2, Vector3, Vector4, WebGLRenderer,
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
/** What the shader calls the numbers of a vertex. */
const names = { positions: "position", normals: "normal", parameters: "parameter", curvature: "curvature" } as const;

/** `lost` is told when the graphics card takes the context away and when it gives it back. */
export function createShadedView(canvas: HTMLCanvasElement, lost: (gone: boolean) => void): ShadedView | null {
  const context = canvas.getContext("webgl2", { antialias: true, alpha: false, powerPreference: "low-power" });
  if (context === null) return null;
  const renderer = new WebGLRenderer({ canvas, context, antialias: true });
  const scene = new Scene();
  const camera = new PerspectiveCamera((opening * 180) / Math.PI, 1, 0.01, 1000);
  camera.up.set(0, 0, 1);
  const uniforms = {
    shade: { value: 0 }, iso: { value: true }, front: { value: new Color() }, back: { value: new Color() }, paper: { value: new Color() },
    ink: { value: new Color() }, tint: { value: new Color() }, cool: { value: new Color() }, warm: { value: new Color() }, eye: { value: new Vector3() },
    curvatureScale: { value: 1 }, isoStep: { value: 1 }, period: { value: new Vector2() },
    region: { value: Array.from({ length: mostRegions }, () => new Vector4()) }, regions: { value: 0 },
  };
  const material = new ShaderMaterial({ vertexShader, fragmentShader, uniforms, side: DoubleSide });
  let geometry = new BufferGeometry();
  const solid = new Mesh(geometry, material);
  solid.frustumCulled = false;
  scene.add(solid);
  let shown: SurfaceMesh | null = null;
  const clear = new Color();

  // The default is to give up: a context that was lost comes back only to those who say that they wait for it.
  const onLost = (event: Event): void => {
    event.preventDefault();
    lost(true);
  };
  const onRestored = (): void => lost(false);
  canvas.addEventListener("webglcontextlost", onLost);
  canvas.addEventListener("webglcontextrestored", onRestored);

  function put(mesh: SurfaceMesh): void {
    const sameShape = shown !== null && shown.rows === mesh.rows && shown.cols === mesh.cols;
    if (!sameShape) {
      geometry.dispose();
      geometry = new BufferGeometry();
      geometry.setIndex(new BufferAttribute(triangles(mesh.rows, mesh.cols), 1));
      for (const [name, width] of [["position", 3], ["normal", 3], ["parameter", 2], ["curvature", 1]] as const) {
        geometry.setAttribute(name, new BufferAttribute(new Float32Array(width * mesh.rows * mesh.cols), width));
      }
      solid.geometry = geometry;
    }
    const set = (name: "positions" | "normals" | "parameters" | "curvature"): void => {
      const values = mesh[name];
      const attribute = geometry.getAttribute(names[name]);
      if (values === null || !(attribute instanceof BufferAttribute) || (sameShape && values === shown?.[name])) return;
      attribute.array.set(values);
      attribute.needsUpdate = true;
    };
    for (const name of ["positions", "normals", "parameters", "curvature"] as const) set(name);
    shown = mesh;
  }

  function look({ orbit, width, height, mesh }: Picture): void {
    const { eye } = frameOf(orbit);
    camera.position.set(...eye);
    camera.aspect = width / Math.max(1, height);
    camera.near = orbit.distance / 100;
    camera.far = orbit.distance * 40;
    camera.lookAt(...orbit.target);
    camera.updateProjectionMatrix();
    uniforms.eye.value.set(...eye);
    if (mesh !== shown) put(mesh);
  }

  /** Colours of the page are what the screen shows: no conversion on the way. */
  function paint(color: Color, css: string): void {
    color.setStyle(css, "");
  }

  function style({ colours, shade, iso, regions, period, isoStep, curvatureScale }: Picture): void {
    for (const name of ["front", "back", "paper", "ink", "tint", "cool", "warm"] as const) paint(uniforms[name].value, colours[name]);
    uniforms.shade.value = shades[shade];
    uniforms.iso.value = iso;
    uniforms.isoStep.value = isoStep;
    uniforms.curvatureScale.value = curvatureScale;
    uniforms.period.value.set(...period);
    uniforms.regions.value = Math.min(mostRegions, regions.length);
    regions.slice(0, mostRegions).forEach(({ from, size }, i) => uniforms.region.value[i]?.set(from[0], size[0], from[1], size[1]));
    // The clear colour alone is converted by the renderer, so it is given as one that has not been.
    renderer.setClearColor(clear.setStyle(colours.paper), 1);
  }

  return {
    draw(picture) {
      if (picture.width < 1 || picture.height < 1) return;
      renderer.setPixelRatio(picture.ratio);
      renderer.setSize(picture.width, picture.height, false);
      look(picture);
      style(picture);
      renderer.render(scene, camera);
    },
    dispose() {
      canvas.removeEventListener("webglcontextlost", onLost);
      canvas.removeEventListener("webglcontextrestored", onRestored);
      geometry.dispose();
      material.dispose();
      renderer.dispose();
    },
  };
}
