// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../../format/scene";
import { MeshData, minus } from "./mesh_data";
import { boxMesh } from "./shapes";

const FOLDER = "models/nobiax_modular/", SUFFIX = ".mesh";

/** The sandbox's building pieces: width and height about the origin, in cm; what differs is by name below. */
type Extent = readonly [number, number, number, number, number, number];
const EXTENTS: Readonly<Record<string, Extent>> = {
  block: [-41, -32, -40, 39, 32, 40], brick_door: [-128, -77, -16, 128, 179, 16], brick_double_window: [-128, -129, -16, 128, 127, 16],
  brick_small_double_window: [-129, -127, -16, 127, 129, 16], brick_small_window_1: [-128, -128, -16, 128, 128, 16],
  brick_small_window_2: [-64, -127, -16, 64, 129, 16], brick_window_1: [-129, -128, -16, 127, 128, 16], brick_window_2: [-65, -126, -16, 63, 130, 16],
  concrete_door: [-128, -129, -16, 128, 127, 16], concrete_double_window: [-129, -128, -16, 127, 128, 16],
  concrete_small_double_window: [-128, -127, -16, 128, 129, 16], concrete_small_window_1: [-128, -130, -16, 128, 126, 16],
  concrete_small_window_2: [-63, -129, -16, 65, 127, 16], concrete_window_1: [-128, -128, -16, 128, 128, 16], concrete_window_2: [-64, -127, -16, 64, 129, 16],
  cooling: [-44, -39, -5, 44, 41, 40], hangar_door: [-128, -128, -16, 128, 128, -0.5], pillar_brick_1: [-32, -128, -32, 32, 128, 32],
  pillar_brick_2: [-31, -97, -32, 33, 95, 32], pillar_brick_3: [-31, -64, -32, 33, 64, 32], pillar_concrete_1: [-31, -129, -32, 33, 127, 32],
  pillar_concrete_2: [-32, -96, -32, 32, 96, 32], pillar_concrete_3: [-32, -63, -32, 32, 65, 32], roof: [-161, -16, -159, 156, 16, 158],
  wall_brick_1: [-128, -128, -16, 128, 128, 16], wall_brick_2: [-64, -127, -16, 64, 129, 16], wall_brick_3: [-63, -66, -16, 65, 62, 16],
  wall_brick_4: [-129, -31, -16, 127, 33, 16], wall_brick_5: [-64, -31, -16, 64, 33, 16], wall_concrete_1: [-128, -127, -16, 128, 129, 16],
  wall_concrete_2: [-63, -128, -16, 65, 128, 16], wall_concrete_3: [-63, -63, -16, 65, 65, 16], wall_concrete_4: [-128, -30, -16, 128, 34, 16],
  wall_concrete_5: [-63, -31, -16, 65, 33, 16],
};

const box = (min: Vec3, max: Vec3): MeshData => boxMesh(min, max, { metricUv: true });

interface Opening { left: number; right: number; bottom: number; top: number }

/** A wall with openings beside each other, as shares of its width and height; glass or nothing within. */
function wallWith(min: Vec3, max: Vec3, openings: readonly Opening[], glass: boolean): MeshData {
  const size = minus(max, min), mesh = new MeshData();
  const at = (x: number, y: number, z: number): Vec3 => [min[0] + x * size[0], min[1] + y * size[1], min[2] + z * size[2]];
  let left = 0;
  for (const hole of openings) {
    mesh.append(box(at(left, 0, 0), at(hole.left, 1, 1)));
    mesh.append(box(at(hole.left, hole.top, 0), at(hole.right, 1, 1)));
    if (hole.bottom > 0) mesh.append(box(at(hole.left, 0, 0), at(hole.right, hole.bottom, 1)));
    if (glass) mesh.append(box(at(hole.left, hole.bottom, 0.42), at(hole.right, hole.top, 0.58)).moved([0, 0, 0], { tint: 0, gloss: 1 }));
    left = hole.right;
  }
  mesh.append(box(at(left, 0, 0), at(1, 1, 1)));
  return mesh;
}

function ribbed(min: Vec3, max: Vec3, ribs: number): MeshData {
  const size = minus(max, min), mesh = box(min, [max[0], max[1], max[2] - 0.25 * size[2]]);
  for (let i = 0; i < ribs; ++i)
    mesh.append(box([min[0], min[1] + (size[1] * (i + 0.1)) / ribs, max[2] - 0.3 * size[2]], [max[0], min[1] + (size[1] * (i + 0.9)) / ribs, max[2]]));
  return mesh;
}

function pillar(min: Vec3, max: Vec3): MeshData {
  const size = minus(max, min), inset = 0.08 * size[0], cap = Math.min(0.16, 0.12 * size[1]);
  const mesh = box([min[0] + inset, min[1], min[2] + inset], [max[0] - inset, max[1], max[2] - inset]);
  mesh.append(box(min, [max[0], min[1] + cap, max[2]]));
  mesh.append(box([min[0], max[1] - cap, min[2]], max));
  return mesh;
}

/** A box set back a little behind a frame along its edges. */
export function crateMesh(min: Vec3, max: Vec3): MeshData {
  const size = minus(max, min), beam = 0.13 * Math.min(...size), depth = 0.045 * size[0];
  const mesh = box([min[0] + depth, min[1] + depth, min[2] + depth], [max[0] - depth, max[1] - depth, max[2] - depth]).moved([0, 0, 0], { light: 0.82 });
  const span = (high: boolean, lo: number, hi: number): [number, number] => (high ? [hi - beam, hi] : [lo, lo + beam]);
  for (const a of [false, true]) {
    for (const b of [false, true]) {
      const [x0, x1] = span(a, min[0], max[0]), [z0, z1] = span(b, min[2], max[2]), [ya0, ya1] = span(a, min[1], max[1]), [yb0, yb1] = span(b, min[1], max[1]);
      mesh.append(box([x0, min[1], z0], [x1, max[1], z1]));
      mesh.append(box([min[0] + beam, ya0, z0], [max[0] - beam, ya1, z1]));
      mesh.append(box([x0, yb0, min[2] + beam], [x1, yb1, max[2] - beam]));
    }
  }
  return mesh;
}

function build(name: string, min: Vec3, max: Vec3): MeshData {
  if (name.includes("block")) return crateMesh(min, max);
  if (name.includes("pillar")) return pillar(min, max);
  if (name.includes("cooling")) return ribbed(min, max, 6);
  if (name.includes("hangar")) return ribbed(min, max, 8);
  if (name.includes("small_double_window"))
    return wallWith(min, max, [{ left: 0.14, right: 0.44, bottom: 0.5, top: 0.8 }, { left: 0.56, right: 0.86, bottom: 0.5, top: 0.8 }], true);
  if (name.includes("double_window"))
    return wallWith(min, max, [{ left: 0.1, right: 0.45, bottom: 0.3, top: 0.82 }, { left: 0.55, right: 0.9, bottom: 0.3, top: 0.82 }], true);
  if (name.includes("small_window")) return wallWith(min, max, [{ left: 0.3, right: 0.7, bottom: 0.5, top: 0.8 }], true);
  if (name.includes("window")) return wallWith(min, max, [{ left: 0.22, right: 0.78, bottom: 0.3, top: 0.82 }], true);
  if (name.endsWith("_door")) return wallWith(min, max, [{ left: 0.3, right: 0.7, bottom: 0, top: 0.8 }], false);
  return box(min, max);
}

/** Null if no building piece has this name. */
export function modularMesh(resource: string): MeshData | null {
  if (!resource.startsWith(FOLDER) || !resource.endsWith(SUFFIX)) return null;
  const name = resource.slice(FOLDER.length, -SUFFIX.length).replace(/^modular_/, "");
  if (!Object.hasOwn(EXTENTS, name)) return null;
  const [x0, y0, z0, x1, y1, z1] = EXTENTS[name]!.map((cm) => cm / 100) as [number, number, number, number, number, number];
  const mesh = build(name, [x0, y0, z0], [x1, y1, z1]);
  mesh.material = name.includes("brick") ? "Soarbox/Brick" : name.includes("block") ? "Soarbox/Crate"
    : name.includes("cooling") || name.includes("hangar") ? "Soarbox/Metal" : "Soarbox/Concrete";
  return mesh;
}
