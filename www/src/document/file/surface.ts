import { emptySurface, type Detail, type NetDirection, type NetPoint, type NetWindow, type Root, type SavedOrbit, type SurfaceDocument } from "../surface/surface.ts";
import { asArray, asBoolean, asNumber, asSampleId, asWhole, field, optional, type Found } from "./check.ts";
import { FileError } from "./error.ts";

/** Surfaces and the roots of generators, as a file has them. */

const limits = { maxRoots: 16, maxRows: 1024, maxNet: 100_000, maxLevel: 6, maxDetails: 64 };

export function readRoots(found: Found): readonly Root[] {
  const roots = asArray(found, (root) => ({ re: asNumber(field(root, "re"), -64, 64), im: asNumber(field(root, "im"), -64, 64) }), limits.maxRoots, "maxRoots");
  if (roots.length < 2) throw new FileError("E_SCHEMA", found.path, "has fewer than two roots");
  return roots;
}

function readDirection(found: Found): NetDirection {
  return {
    roots: readRoots(field(found, "roots")),
    count: asWhole(field(found, "count"), 2, limits.maxRows),
    closed: asBoolean(field(found, "closed")),
  };
}

function readNetPoint(found: Found): NetPoint {
  return {
    u: asWhole(field(found, "u"), 0, limits.maxNet),
    v: asWhole(field(found, "v"), 0, limits.maxNet),
    x: asNumber(field(found, "x")),
    y: asNumber(field(found, "y")),
    z: asNumber(field(found, "z")),
  };
}

export function readOrbit(found: Found): SavedOrbit {
  const [x, y, z, ...rest] = asArray(field(found, "target"), (value) => asNumber(value), 3, "triple");
  if (x === undefined || y === undefined || z === undefined || rest.length > 0) throw new FileError("E_SCHEMA", `${found.path}.target`, "is not three numbers");
  return {
    yaw: asNumber(field(found, "yaw"), -100, 100),
    pitch: asNumber(field(found, "pitch"), -Math.PI / 2, Math.PI / 2),
    distance: asNumber(field(found, "distance"), 1e-9),
    target: [x, y, z],
  };
}

function readWindow(found: Found): NetWindow {
  return {
    level: asWhole(field(found, "level"), 1, limits.maxLevel),
    first: asWhole(field(found, "first"), 0, limits.maxNet),
    count: asWhole(field(found, "count"), 1, limits.maxRows),
  };
}

function readDetail(found: Found): Detail {
  const [u, v] = [readWindow(field(found, "u")), readWindow(field(found, "v"))];
  const displacements = asArray(field(found, "displacements"), (value) => asNumber(value), 3 * limits.maxNet, "maxNet");
  if (displacements.length !== 3 * u.count * v.count) {
    throw new FileError("E_SCHEMA", `${found.path}.displacements`, `has not three numbers for each of ${u.count * v.count} points`);
  }
  return { u, v, displacements };
}

function readPair(found: Found): readonly [number, number] {
  const [u, v, ...rest] = asArray(found, (value) => asWhole(value, 0, 64), 2, "pair");
  if (u === undefined || v === undefined || rest.length > 0) throw new FileError("E_SCHEMA", found.path, "is not a pair of numbers");
  return [u, v];
}

export function readSurface(found: Found): SurfaceDocument {
  const level = (name: string): number => asWhole(field(found, name), 0, limits.maxLevel);
  const sample = asSampleId(field(found, "sample"));
  const net = asArray(field(found, "net"), readNetPoint, limits.maxNet, "maxNet");
  const [u, v] = [optional(found, "u", readDirection), optional(found, "v", readDirection)];
  // Version 1 had no surfaces: it names a sample at most.
  if (net.length === 0 || u === undefined || v === undefined) return { ...emptySurface, sample };
  checkOrder(net, found.path);
  const details = optional(found, "details", (each) => asArray(each, readDetail, limits.maxDetails, "maxDetails"));
  return {
    sample, net, u, v,
    ...(details === undefined ? {} : { details }),
    levelU: level("levelU"),
    levelV: level("levelV"),
    support: readPair(field(found, "support")),
    patches: asWhole(field(found, "patches"), 0, 1e6),
  };
}

/** A whole rectangle, row by row: everything else would put points where others are. */
function checkOrder(net: readonly NetPoint[], path: string): void {
  const columns = (net.at(-1)?.v ?? 0) + 1;
  const right = net.length % columns === 0 && net.every((point, i) => point.u === Math.floor(i / columns) && point.v === i % columns);
  if (!right) throw new FileError("E_SCHEMA", `${path}.net`, "is not a rectangle of points, row by row");
}
