// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../../format/scene";
import { clamp, dot, MeshData, plus, times, unit } from "./mesh_data";
import { latticeValue, noise2 } from "./noise";
import { boxAround, capsuleMesh, coarsely, cylinderMesh, partsOf } from "./shapes";

type Coat = readonly [tint: number, light: number, gloss: number];
const OWN: Coat = [1, 1, 0];

function paste(mesh: MeshData, part: MeshData, at: Vec3, [tint, light, gloss]: Coat = OWN): void {
  mesh.append(part.moved(at, { tint, light, gloss }));
}

/** A ball squeezed to these half axes, with lumps of that share of them. */
function ball(half: Vec3, lumps = 0, seed = 1, fineAround = 16, fineUp = 10): MeshData {
  const mesh = new MeshData(), around = partsOf(fineAround), up = Math.max(4, partsOf(fineUp) - 1);
  for (let r = 0; r <= up; ++r) {
    const t = Math.PI * (r / up - 0.5);
    for (let s = 0; s <= around; ++s) {
      const angle = (2 * Math.PI * (s % around)) / around;
      const out: Vec3 = [Math.cos(t) * Math.sin(angle), Math.sin(t), Math.cos(t) * Math.cos(angle)];
      const lump = 1 + lumps * (noise2(4 * out[0] + 9, 4 * out[1] + 4 * out[2] + 9, seed) - 0.5);
      mesh.vertex([half[0] * out[0] * lump, half[1] * out[1] * lump, half[2] * out[2] * lump],
        unit([out[0] / half[0], out[1] / half[1], out[2] / half[2]]), 0, 0, 1, 0.78 + 0.22 * (0.5 + 0.5 * out[1]) + 0.5 * lumps * (lump - 1));
    }
  }
  const row = around + 1;
  for (let r = 0; r < up; ++r) {
    for (let s = 0; s < around; ++s) {
      const a = r * row + s;
      mesh.quad(a, a + 1, a + row + 1, a + row);
    }
  }
  return mesh;
}

/** Brings what stands on the ground to the middle of a shape of this size. */
function standing(mesh: MeshData, size: Vec3): MeshData {
  return mesh.scaled(size[1] / 1.7).moved([0, -size[1] / 2, 0]);
}

interface Beast {
  length: number; height: number; leg: number; girth: number;
  head: Vec3; headUp: number; headAhead: number; ear: number; tail: number; lumps: number;
  darkHead?: boolean; darkLegs?: boolean;
}

function animal(b: Beast): MeshData {
  const mesh = new MeshData(), middle = b.leg + b.girth;
  paste(mesh, ball([b.girth, b.girth, b.length / 2], b.lumps, 7), [0, middle, 0]);
  const legs: Coat = [b.darkLegs === true ? 0 : 1, 0.85, 0], head: Coat = [b.darkHead === true ? 0 : 1, 1, 0.05];
  for (const x of [-0.55, 0.55])
    for (const z of [-0.32, 0.32])
      paste(mesh, cylinderMesh(0.2 * b.girth, b.leg + 0.5 * b.girth), [x * b.girth, (b.leg + 0.5 * b.girth) / 2, z * b.length], legs);
  const at: Vec3 = [0, b.height + b.headUp, b.length / 2 + b.headAhead];
  paste(mesh, ball([0.55 * b.girth, 0.8 * b.girth, 0.55 * b.girth], b.lumps, 5), [0, (at[1] + middle) / 2, (at[2] + 0.32 * b.length) / 2]);
  paste(mesh, ball(b.head), at, head);
  paste(mesh, ball([0.6 * b.head[0], 0.5 * b.head[1], 0.55 * b.head[2]]), plus(at, [0, -0.25 * b.head[1], 0.75 * b.head[2]]), [0, 0.9, 0.1]);
  for (const side of [-1, 1]) {
    paste(mesh, ball([0.35 * b.head[0], b.ear, 0.2 * b.head[0]]), plus(at, [side * 0.8 * b.head[0], 0.7 * b.head[1] + 0.6 * b.ear, -0.2 * b.head[2]]), head);
    paste(mesh, ball([0.14 * b.head[0], 0.16 * b.head[1], 0.1 * b.head[2]]), plus(at, [side * 0.55 * b.head[0], 0.25 * b.head[1], 0.72 * b.head[2]]), [0, 0.25, 0.6]);
  }
  paste(mesh, ball([b.tail, b.tail, b.tail]), [0, middle + 0.3 * b.girth, -b.length / 2], [1, 1.15, 0]);
  return mesh;
}

const sheep = (): MeshData => animal({ length: 1.05, height: 0.95, leg: 0.3, girth: 0.33, head: [0.11, 0.13, 0.19], headUp: 0.1, headAhead: 0.02, ear: 0.07, tail: 0.09, lumps: 0.35, darkHead: true, darkLegs: true });
const bear = (): MeshData => animal({ length: 1.75, height: 1.25, leg: 0.42, girth: 0.46, head: [0.24, 0.23, 0.28], headUp: 0.12, headAhead: 0.1, ear: 0.09, tail: 0.08, lumps: 0.12 });
const hare = (): MeshData => animal({ length: 0.48, height: 0.36, leg: 0.12, girth: 0.13, head: [0.075, 0.085, 0.1], headUp: 0.09, headAhead: 0, ear: 0.14, tail: 0.055, lumps: 0.1 });
const wolf = (): MeshData => animal({ length: 1.3, height: 0.82, leg: 0.4, girth: 0.22, head: [0.12, 0.13, 0.22], headUp: 0.12, headAhead: 0.08, ear: 0.11, tail: 0.1, lumps: 0.15 });

/** Legs, arms, hands, head and eyes of somebody in clothes. */
function person(mesh: MeshData, legLight: number, armAt: number, sleeve: number): void {
  for (const x of [-0.1, 0.1]) paste(mesh, cylinderMesh(0.085, 0.8), [x, 0.4, 0], [0, legLight, 0]);
  for (const x of [-armAt, armAt]) {
    paste(mesh, capsuleMesh(0.065, 0.52), [x, 1.08, 0.04], [1, sleeve, 0]);
    paste(mesh, ball([0.065, 0.065, 0.065]), [x, 0.8, 0.05], [0, 1, 0.05]);
  }
  paste(mesh, ball([0.105, 0.135, 0.12]), [0, 1.47, 0], [0, 1, 0.05]);
  for (const x of [-0.04, 0.04]) paste(mesh, ball([0.015, 0.018, 0.012]), [x, 1.49, 0.115], [0, 0.1, 0.6]);
}

function villager(): MeshData {
  const mesh = new MeshData();
  person(mesh, 0.35, 0.26, 0.85);
  paste(mesh, ball([0.23, 0.42, 0.16]), [0, 1, 0]);
  paste(mesh, cylinderMesh(0.22, 0.02), [0, 1.56, 0], [0, 1.15, 0]);
  paste(mesh, ball([0.13, 0.11, 0.13]), [0, 1.59, 0], [0, 1.15, 0]);
  return mesh;
}

function cook(): MeshData {
  const mesh = new MeshData();
  person(mesh, 0.45, 0.27, 0.95);
  paste(mesh, ball([0.24, 0.4, 0.17]), [0, 1.02, 0]);
  paste(mesh, boxAround([0, 0.86, 0.12], [0.34, 0.52, 0.08]), [0, 0, 0], [1, 0.86, 0]);
  paste(mesh, cylinderMesh(0.115, 0.14), [0, 1.62, 0], [1, 1.05, 0]);
  paste(mesh, ball([0.17, 0.11, 0.17], 0.25, 3), [0, 1.74, 0], [1, 1.1, 0]);
  return mesh;
}

function robot(): MeshData {
  const mesh = boxAround([0, 0.34, -0.05], [0.72, 0.34, 1.05], 0.08);
  paste(mesh, boxAround([0, 0.56, -0.12], [0.5, 0.14, 0.62], 0.06), [0, 0, 0], [1, 0.75, 0.2]);
  for (const x of [-0.42, 0.42]) {
    paste(mesh, ball([0.07, 0.26, 0.26]), [x, 0.26, -0.3], [0, 0.8, 0.1]);
    paste(mesh, ball([0.06, 0.16, 0.16]), [x, 0.16, 0.36], [0, 0.8, 0.1]);
  }
  paste(mesh, cylinderMesh(0.02, 0.35), [0, 0.78, -0.3], [0, 1, 0.3]);
  paste(mesh, ball([0.06, 0.06, 0.06]), [0, 0.97, -0.3], [1, 1.3, 0.6]);
  paste(mesh, boxAround([0, 0.4, 0.5], [0.4, 0.1, 0.06]), [0, 0, 0], [0, 2.5, 0.6]);
  return mesh;
}

function cart(): MeshData {
  const mesh = boxAround([0, 0.52, -0.15], [0.8, 0.08, 1.4]);
  for (const x of [-0.4, 0.4]) {
    paste(mesh, boxAround([x, 0.72, -0.15], [0.05, 0.34, 1.4]), [0, 0, 0], [1, 0.85, 0]);
    paste(mesh, ball([0.06, 0.36, 0.36]), [1.2 * x, 0.36, -0.15], [0, 0.7, 0]);
    paste(mesh, boxAround([0.7 * x, 0.52, 0.95], [0.06, 0.06, 0.9]), [0, 0, 0], [1, 0.8, 0]);
  }
  for (const z of [-0.85, 0.55]) paste(mesh, boxAround([0, 0.72, z], [0.8, 0.34, 0.05]), [0, 0, 0], [1, 0.85, 0]);
  paste(mesh, ball([0.36, 0.3, 0.62], 0.35, 4), [0, 0.8, -0.15], [0, 1.9, 0]);
  return mesh;
}

function bee(): MeshData {
  const high = 1.15, mesh = new MeshData();
  paste(mesh, ball([0.24, 0.23, 0.36]), [0, high, -0.12]);
  for (const z of [-0.32, -0.14, 0.04]) {
    const wide = Math.sqrt(1 - (z + 0.12) ** 2 / 0.36 ** 2);
    paste(mesh, ball([0.255 * wide, 0.245 * wide, 0.055]), [0, high, z], [0, 0.9, 0]);
  }
  paste(mesh, ball([0.16, 0.16, 0.15]), [0, high + 0.04, 0.32], [0, 1.4, 0.05]);
  for (const side of [-1, 1]) {
    paste(mesh, ball([0.05, 0.07, 0.04]), [side * 0.09, high + 0.1, 0.43], [0, 5, 0.5]);
    paste(mesh, ball([0.34, 0.015, 0.16]), [side * 0.4, high + 0.24, -0.02], [0, 11, 0.2]);
    paste(mesh, capsuleMesh(0.012, 0.18), [side * 0.05, high + 0.26, 0.38], [0, 1, 0]);
  }
  return mesh;
}

function bell(): MeshData {
  const mesh = new MeshData();
  for (const x of [-0.62, 0.62]) paste(mesh, boxAround([x, 0.85, 0], [0.14, 1.7, 0.14]), [0, 0, 0], [0, 1, 0]);
  paste(mesh, boxAround([0, 1.7, 0], [1.5, 0.14, 0.18]), [0, 0, 0], [0, 0.85, 0]);
  paste(mesh, cylinderMesh(0.05, 0.2), [0, 1.55, 0], [1, 0.7, 0.3]);
  paste(mesh, ball([0.3, 0.42, 0.3]), [0, 1.12, 0], [1, 1, 0.45]);
  paste(mesh, cylinderMesh(0.37, 0.12), [0, 0.86, 0], [1, 0.9, 0.45]);
  paste(mesh, ball([0.09, 0.09, 0.09]), [0, 0.76, 0], [1, 0.6, 0.3]);
  return mesh;
}

/** Bars of metal in a pile. */
function bars(size: Vec3): MeshData {
  const mesh = new MeshData(), unitM = size[0], ground = -0.5 * size[1];
  for (let row = 0; row < 3; ++row) {
    for (let i = 0; i < 3 - row; ++i) {
      const x = (i - 0.5 * (2 - row)) * 0.95 * unitM, y = ground + (0.25 + 0.5 * row) * unitM;
      paste(mesh, boxAround([x, y, 0], [0.86 * unitM, 0.48 * unitM, 1.9 * unitM], 0.12 * unitM), [0, 0, 0], [1, 0.85 + 0.08 * ((i + row) % 3), 0.6]);
    }
  }
  return mesh;
}

function flower(size: Vec3): MeshData {
  const mesh = new MeshData(), u = size[0], ground = -0.5 * size[1], top = ground + 1.7 * u;
  paste(mesh, cylinderMesh(0.1 * u, 1.7 * u), [0, 0.5 * (ground + top), 0], [0, 0.6, 0]);
  for (const side of [-1, 1]) paste(mesh, ball([0.5 * u, 0.06 * u, 0.2 * u]), [side * 0.5 * u, ground + 0.5 * u, 0], [0, 0.7, 0]);
  for (let i = 0; i < 6; ++i) {
    const angle = (Math.PI * i) / 3;
    paste(mesh, ball([0.48 * u, 0.12 * u, 0.48 * u]), [0.72 * u * Math.cos(angle), top, 0.72 * u * Math.sin(angle)]);
  }
  paste(mesh, ball([0.42 * u, 0.22 * u, 0.42 * u]), [0, top + 0.06 * u, 0], [0, 1.5, 0]);
  return mesh;
}

/** Leaves that fill the box. */
function hedge(size: Vec3): MeshData {
  const least = Math.min(...size), isCoarse = partsOf(28) < 28, mesh = boxAround([0, 0, 0], times(size, 0.94), 0.1 * least).moved([0, 0, 0], { light: 0.72 });
  const leaf = clamp(1.3 * least, 0.25, 1.2) * (isCoarse ? 1.9 : 1), steps = size.map((side) => clamp(Math.round((1.6 * side) / leaf), 1, 24));
  const [across, up, along] = steps as [number, number, number];
  let seed = 3;
  for (let i = 0; i < across; ++i) {
    for (let j = 0; j < up; ++j) {
      for (let k = 0; k < along; ++k, ++seed) {
        if (i > 0 && i + 1 < across && j > 0 && j + 1 < up && k > 0 && k + 1 < along) continue;
        const at = (n: number, count: number, side: number): number => side * ((n + 0.5) / count - 0.5);
        paste(mesh, ball([leaf / 2, leaf / 2, Math.min(leaf / 2, 0.8 * size[2])], 0.5, seed, 9, 5), [at(i, across, size[0]), at(j, up, size[1]), at(k, along, size[2])],
          [1, 0.8 + 0.35 * latticeValue(i, j, k, 11), 0]);
      }
    }
  }
  return mesh;
}

/** A case with a cross on each side. */
function medkit(size: Vec3): MeshData {
  const mesh = boxAround([0, 0, 0], size, 0.12 * Math.min(...size)).moved([0, 0, 0], { gloss: 0.15 });
  const cross = (middle: Vec3, across: Vec3, along: Vec3, out: Vec3, wide: number, high: number): void => {
    const reach = Math.min(wide, high);
    for (const [a, b] of [[0.62, 0.22], [0.22, 0.62]] as const) {
      const part = plus(plus(times(across, a * reach), times(along, b * reach)), times(out, 0.02 * reach));
      paste(mesh, boxAround(middle, part, 0.004), [0, 0, 0], [0, 1, 0.1]);
    }
  };
  for (const side of [-0.5, 0.5]) {
    cross([0, 0, side * size[2]], [1, 0, 0], [0, 1, 0], [0, 0, 1], size[0], size[1]);
    cross([side * size[0], 0, 0], [0, 0, 1], [0, 1, 0], [1, 0, 0], size[2], size[1]);
  }
  cross([0, 0.5 * size[1], 0], [1, 0, 0], [0, 0, 1], [0, 1, 0], size[0], size[2]);
  return mesh;
}

/** A flat case with bands and rounds standing in it. */
function ammunition(size: Vec3): MeshData {
  const mesh = boxAround([0, -0.12 * size[1], 0], [size[0], 0.76 * size[1], size[2]], 0.05 * size[1]);
  for (const x of [-0.3, 0.3]) paste(mesh, boxAround([x * size[0], -0.12 * size[1], 0], [0.08 * size[0], 0.79 * size[1], 1.03 * size[2]], 0.004), [0, 0, 0], [1, 0.6, 0]);
  for (let i = 0; i < 5; ++i)
    for (const z of [-0.22, 0.22])
      paste(mesh, capsuleMesh(0.055 * size[0], 0.55 * size[1]), [(i / 4 - 0.5) * 0.7 * size[0], 0.26 * size[1], z * size[2]], [0, 1, 0.5]);
  return mesh;
}

function sack(size: Vec3): MeshData {
  const mesh = new MeshData();
  paste(mesh, ball([0.48 * size[0], 0.4 * size[1], 0.48 * size[2]], 0.22, 11), [0, -0.1 * size[1], 0]);
  paste(mesh, cylinderMesh(0.11 * size[0], 0.2 * size[1]), [0, 0.34 * size[1], 0], [0, 1, 0]);
  paste(mesh, ball([0.2 * size[0], 0.09 * size[1], 0.2 * size[2]], 0.4, 4), [0, 0.44 * size[1], 0]);
  return mesh;
}

/** A boulder that fills the box: a rough ball with faces. */
function rock(size: Vec3): MeshData {
  const around = 22, up = 13, seed = Math.floor(Math.abs(size[0] * 37 + size[1] * 91 + size[2] * 53));
  const cuts = Array.from({ length: 14 }, (_, i) => {
    const chance = (n: number): number => latticeValue(i, n, 5, seed);
    return { normal: unit([chance(1) - 0.5, 0.8 * (chance(2) - 0.35), chance(3) - 0.5]), at: 0.72 + 0.22 * chance(4) };
  });
  const rows = Array.from({ length: up + 1 }, (_, r) => Array.from({ length: around }, (_none, s): Vec3 => {
    const t = Math.PI * (r / up - 0.5), angle = (2 * Math.PI * s) / around;
    const out: Vec3 = [Math.cos(t) * Math.sin(angle), Math.sin(t), Math.cos(t) * Math.cos(angle)];
    let reach = 1;
    for (const cut of cuts) {
      const facing = dot(out, cut.normal);
      if (facing > 0.05) reach = Math.min(reach, cut.at / facing);
    }
    const square = 1 / Math.max(Math.abs(out[0]), Math.abs(out[1]), Math.abs(out[2]));
    const rough = 0.06 * (noise2(5 * out[0] + 9, 5 * out[1] + 5 * out[2] + 9, seed) - 0.5);
    const p = times(out, reach * (1 + rough) * (0.55 + 0.45 * square));
    return [0.5 * size[0] * clamp(p[0], -1, 1), 0.5 * size[1] * clamp(p[1], -1, 1), 0.5 * size[2] * clamp(p[2], -1, 1)];
  }));
  const mesh = new MeshData();
  const paint = (p: Vec3, n: Vec3): { u: number; v: number; light: number } => ({
    u: Math.abs(n[0]) > 0.7 ? p[2] : p[0], v: Math.abs(n[1]) > 0.7 ? p[2] : -p[1], light: 0.7 + 0.3 * clamp(p[1] / Math.max(0.1, size[1]) + 0.5, 0, 1),
  });
  for (let r = 0; r < up; ++r) {
    for (let s = 0; s < around; ++s) {
      const next = (s + 1) % around, below = rows[r]!, above = rows[r + 1]!;
      mesh.facet(below[s]!, below[next]!, above[next]!, paint);
      mesh.facet(below[s]!, above[next]!, above[s]!, paint);
    }
  }
  return mesh;
}

const FIGURES: Readonly<Record<string, (size: Vec3) => MeshData>> = {
  "Soarbox/Rock": rock, "Soarbox/Medkit": medkit, "Soarbox/Ammunition": ammunition, "Soarbox/Sack": sack,
  "Soarbox/Sheep": (size) => standing(sheep(), size), "Soarbox/Bear": (size) => standing(bear(), size),
  "Soarbox/Hare": (size) => standing(hare(), size), "Soarbox/Cook": (size) => standing(cook(), size),
  "Soarbox/Wolf": (size) => standing(wolf(), size), "Soarbox/Villager": (size) => standing(villager(), size),
  "Soarbox/Robot": (size) => standing(robot(), size), "Soarbox/Cart": (size) => standing(cart(), size),
  "Soarbox/Bee": (size) => standing(bee(), size), "Soarbox/Bell": (size) => standing(bell(), size),
  "Soarbox/Gold": bars, "Soarbox/Silver": bars, "Soarbox/Bronze": bars,
  "Soarbox/RedFlower": flower, "Soarbox/BlueFlower": flower, "Soarbox/WhiteFlower": flower, "Soarbox/Hedge": hedge,
};

/** Whether what has this material is a thing or a creature of its own. */
export function isFigure(material: string): boolean {
  return Object.hasOwn(FIGURES, material);
}

/** Null if the material names no figure, or the size is none. */
export function figureMesh(material: string, size: Vec3, coarse = false): MeshData | null {
  if (!isFigure(material) || !size.every((side) => Number.isFinite(side) && side > 0)) return null;
  return coarsely(coarse, () => FIGURES[material]!(size));
}
