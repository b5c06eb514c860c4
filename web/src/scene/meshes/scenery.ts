// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../../format/scene";
import { clamp, cross, dot, length, MeshData, minus, plus, times, unit } from "./mesh_data";
import { fractal2, latticeValue, noise2 } from "./noise";

interface Piece { kind: "pine" | "oak" | "rock"; size: number; seed: number; height: number; width: number; depth: number }

const PIECES: Readonly<Record<string, Piece>> = {
  pine_1: { kind: "pine", size: 6, seed: 1, height: 6, width: 0.4, depth: 0.4 },
  pine_2: { kind: "pine", size: 8.5, seed: 2, height: 8.5, width: 0.5, depth: 0.5 },
  oak_1: { kind: "oak", size: 6, seed: 3, height: 6, width: 0.5, depth: 0.5 },
  oak_2: { kind: "oak", size: 7.5, seed: 4, height: 7.5, width: 0.6, depth: 0.6 },
  rock_1: { kind: "rock", size: 0.9, seed: 5, height: 0.55, width: 0.84, depth: 0.8 },
  rock_2: { kind: "rock", size: 1.8, seed: 6, height: 1.1, width: 1.68, depth: 1.6 },
  rock_3: { kind: "rock", size: 3.2, seed: 7, height: 1.95, width: 3, depth: 2.8 },
  rock_4: { kind: "rock", size: 2.4, seed: 8, height: 1.45, width: 2.2, depth: 2.1 },
};

const chanceOf = (seed: number, index: number): number => latticeValue(index, 17, 3, seed * 7919);

/** Rows of rings joined to a skin with smooth normals; each row closes around. */
function addRings(mesh: MeshData, rows: readonly (readonly Vec3[])[], tint: number, lightBelow: number, lightAbove: number, perMetre: number): void {
  const base = mesh.count, around = rows[0]!.length;
  rows.forEach((row, r) => {
    for (let s = 0; s <= around; ++s) {
      const here = s % around, up = Math.min(r + 1, rows.length - 1), down = Math.max(r - 1, 0);
      const isPole = length(minus(row[0]!, row[Math.floor(around / 2)]!)) < 1e-3;
      const wide = rows[isPole ? (r === 0 ? 1 : r - 1) : r]!;
      const across = minus(wide[(here + 1) % around]!, wide[(here + around - 1) % around]!);
      const p = row[here]!;
      mesh.vertex(p, unit(cross(across, minus(rows[up]![here]!, rows[down]![here]!))), (s / around) * perMetre * 3, -p[1] * perMetre, tint,
        lightBelow + ((lightAbove - lightBelow) * r) / (rows.length - 1));
    }
  });
  const width = around + 1;
  for (let r = 0; r + 1 < rows.length; ++r) {
    for (let s = 0; s < around; ++s) {
      const a = base + r * width + s;
      mesh.quad(a, a + 1, a + width + 1, a + width);
    }
  }
}

function circle(centre: Vec3, radius: number, count: number, seed: number, rough: number): Vec3[] {
  return Array.from({ length: count }, (_, i) => {
    const angle = (2 * Math.PI * i) / count, r = radius * (1 + rough * (chanceOf(seed, i) - 0.5));
    return plus(centre, [r * Math.sin(angle), 0, r * Math.cos(angle)]);
  });
}

function addTrunk(mesh: MeshData, height: number, radius: number, seed: number): void {
  const rows = Array.from({ length: 7 }, (_, i) => {
    const t = i / 6, foot = 1 + 0.7 * (1 - t) ** 8;
    const bend: Vec3 = [0.05 * height * (noise2(t * 2, 0.5, seed) - 0.5) * t, t * height, 0.05 * height * (noise2(0.5, t * 2, seed + 1) - 0.5) * t];
    return circle(bend, radius * foot * (1 - 0.6 * t), 9, seed + 5, 0.25);
  });
  addRings(mesh, rows, 0, 0.7, 1, 0.8);
}

/** Skirts of twigs, one above the other. */
function pine(size: number, seed: number): MeshData {
  const mesh = new MeshData(), skirts = 9, points = 22;
  addTrunk(mesh, 0.85 * size, 0.024 * size, seed);
  for (let skirt = 0; skirt < skirts; ++skirt) {
    const t = skirt / skirts, low = size * (0.14 + 0.76 * t), high = low + size * (0.26 - 0.1 * t);
    const wide = size * (0.245 - 0.205 * t ** 0.85) * (0.92 + 0.16 * chanceOf(seed, skirt));
    const lean: Vec3 = [0.02 * size * (chanceOf(seed, 40 + skirt) - 0.5), 0, 0.02 * size * (chanceOf(seed, 60 + skirt) - 0.5)];
    const rows: Vec3[][] = [[], [], [], []];
    for (let i = 0; i < points; ++i) {
      const angle = (2 * Math.PI * (i + 0.4 * chanceOf(seed, 100 + skirt))) / points, twig = i % 2 === 0;
      const reach = wide * (twig ? 1 : 0.74) * (0.86 + 0.28 * chanceOf(seed, skirt * 37 + i)), hang = size * (twig ? 0.03 : 0.008);
      const at = (y: number, share: number): Vec3 => plus(lean, [share * reach * Math.sin(angle), y, share * reach * Math.cos(angle)]);
      rows[0]!.push(at(low + 0.03 * size, 0.25));
      rows[1]!.push(at(low - hang, 1));
      rows[2]!.push(at(low + 0.42 * (high - low), 0.52));
      rows[3]!.push(at(high, 0));
    }
    addRings(mesh, rows, 1, 0.42, 1, 1.1);
  }
  return mesh;
}

function addCrown(mesh: MeshData, centre: Vec3, half: Vec3, seed: number, around: number): void {
  const up = Math.floor(around / 2);
  const rows = Array.from({ length: up + 1 }, (_, r) => Array.from({ length: around }, (_none, s): Vec3 => {
    const t = Math.PI * (r / up - 0.5), angle = (2 * Math.PI * s) / around;
    const out: Vec3 = [Math.cos(t) * Math.sin(angle), Math.sin(t), Math.cos(t) * Math.cos(angle)];
    const lump = r === 0 || r === up ? 1
      : 1 + 0.42 * (latticeValue(s, r, 1, seed) - 0.5) + 0.25 * (noise2(out[0] * 2 + 5, out[1] * 2 + out[2] * 2 + 5, seed) - 0.5);
    return plus(centre, [half[0] * out[0] * lump, half[1] * out[1] * lump, half[2] * out[2] * lump]);
  }));
  addRings(mesh, rows, 1, 0.45, 1.05, 0.95);
}

function oak(size: number, seed: number): MeshData {
  const mesh = new MeshData();
  addTrunk(mesh, 0.62 * size, 0.04 * size, seed);
  addCrown(mesh, [0, 0.72 * size, 0], [0.25 * size, 0.2 * size, 0.25 * size], seed + 1, 18);
  for (let i = 0; i < 7; ++i) {
    const angle = (2 * Math.PI * (i + 0.6 * chanceOf(seed, i))) / 7, out = size * (0.17 + 0.09 * chanceOf(seed, 10 + i));
    const high = size * (0.5 + 0.28 * chanceOf(seed, 20 + i)), half = size * (0.13 + 0.06 * chanceOf(seed, 30 + i));
    addCrown(mesh, [out * Math.sin(angle), high, out * Math.cos(angle)], [half, 0.82 * half, half], seed + 40 + i, 14);
  }
  return mesh;
}

/** A ball cut by planes, so that it has faces and edges, and roughened. */
function rock(piece: Piece): MeshData {
  const around = 30, up = 18, { seed, width, height, depth } = piece;
  const cuts = Array.from({ length: 16 }, (_, i) => ({
    normal: unit([chanceOf(seed, i) - 0.5, 0.9 * (chanceOf(seed, 30 + i) - 0.4), chanceOf(seed, 60 + i) - 0.5]), at: 0.66 + 0.26 * chanceOf(seed, 90 + i),
  }));
  const rows = Array.from({ length: up + 1 }, (_, r) => Array.from({ length: around }, (_none, s): Vec3 => {
    const t = Math.PI * (r / up - 0.5), angle = (2 * Math.PI * s) / around;
    const out: Vec3 = [Math.cos(t) * Math.sin(angle), Math.sin(t), Math.cos(t) * Math.cos(angle)];
    let reach = 1;
    for (const cut of cuts) {
      const facing = dot(out, cut.normal);
      if (facing > 0.05) reach = Math.min(reach, cut.at / facing);
    }
    const rough = fractal2(out[0] * 3 + 9, out[1] * 3 + out[2] * 2 + 9, 3, seed) - 0.5;
    const p = times(out, reach * (1 + 0.05 * rough));
    return [0.5 * width * p[0], Math.max(-0.02 * height, height * (0.42 + 0.58 * p[1])), 0.5 * depth * p[2]];
  }));
  const mesh = new MeshData();
  const paint = (p: Vec3, n: Vec3): { u: number; v: number; light: number } => ({
    u: Math.abs(n[0]) > 0.7 ? p[2] : p[0], v: Math.abs(n[1]) > 0.7 ? p[2] : -p[1], light: clamp(0.62 + 0.9 * p[1], 0.62, 1),
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

/** Trees and rocks by their resource's name; null for other names. */
export function sceneryMesh(resource: string): MeshData | null {
  const name = /^models\/soarbox\/(\w+)\.mesh$/.exec(resource)?.[1] ?? "";
  if (!Object.hasOwn(PIECES, name)) return null;
  const piece = PIECES[name]!;
  const mesh = piece.kind === "pine" ? pine(piece.size, piece.seed) : piece.kind === "oak" ? oak(piece.size, piece.seed) : rock(piece);
  mesh.material = piece.kind === "rock" ? "Soarbox/Stone" : "Soarbox/Leaves";
  return mesh;
}

/** Worlds whose ground is a square plain of this size have hills, woods and a fence around it. */
export const PLAIN_SIDE_M = 200;

function onHills(angle: number, behind: number): Vec3 {
  const edge = PLAIN_SIDE_M / 2 / Math.max(Math.abs(Math.sin(angle)), Math.abs(Math.cos(angle)));
  const crest = 3 + 17 * fractal2(2.4 * Math.sin(angle) + 7, 2.4 * Math.cos(angle) + 7, 3, 21), rise = clamp(behind / 55, 0, 1);
  return [(edge + behind) * Math.sin(angle), -0.4 + crest * rise * rise * (3 - 2 * rise), (edge + behind) * Math.cos(angle)];
}

export function hillsMesh(): MeshData {
  const mesh = new MeshData(), around = 160, behinds = [-6, 2, 10, 20, 32, 45, 60, 80];
  mesh.material = "Soarbox/Hills";
  for (const behind of behinds) {
    for (let s = 0; s <= around; ++s) {
      const angle = (2 * Math.PI * (s % around)) / around, p = onHills(angle, behind);
      let normal = unit(cross(minus(onHills(angle, behind + 2), onHills(angle, behind - 2)), minus(onHills(angle + 0.02, behind), onHills(angle - 0.02, behind))));
      if (normal[1] < 0) normal = times(normal, -1);
      const patch = fractal2(p[0] * 0.06 + 50, p[2] * 0.06 + 50, 3, 4);
      mesh.vertex(p, normal, 0, 0, patch > 0.3 ? 1 : 0.75, 0.72 + 0.5 * patch);
    }
  }
  const row = around + 1;
  for (let r = 0; r + 1 < behinds.length; ++r) {
    for (let s = 0; s < around; ++s) {
      const a = r * row + s;
      mesh.quad(a, a + row, a + row + 1, a + 1);
    }
  }
  return mesh;
}

export function woodsMesh(): MeshData {
  const mesh = new MeshData(), trees = 150;
  mesh.material = "Soarbox/Leaves";
  const cone = (foot: Vec3, radius: number, height: number, tint: number, light: number): void => {
    const tip = plus(foot, [0, height, 0]), rim = (angle: number): Vec3 => plus(foot, [radius * Math.sin(angle), 0, radius * Math.cos(angle)]);
    for (let i = 0; i < 7; ++i)
      mesh.facet(rim((2 * Math.PI * i) / 7), rim((2 * Math.PI * (i + 1)) / 7), tip,
        (p) => ({ u: p[0] * 0.6 + p[2] * 0.4, v: -p[1] * 0.6, tint, light: light * (p === tip ? 1 : 0.62) }));
  };
  for (let i = 0; i < trees; ++i) {
    const chance = (n: number): number => latticeValue(i, n, 9, 31);
    const angle = (2 * Math.PI * (i + chance(1))) / trees, wood = noise2(3 * Math.sin(angle) + 5, 3 * Math.cos(angle) + 5, 8);
    if (wood < 0.42 && chance(2) < 0.8) continue;
    const foot = onHills(angle, 3 + 42 * chance(3)), high = 4.5 + 4.5 * chance(4), light = 0.85 + 0.3 * chance(5);
    cone(plus(foot, [0, -0.3, 0]), 0.05 * high, 0.4 * high, 0, 0.9);
    for (const level of [0.16, 0.4, 0.63]) cone(plus(foot, [0, level * high, 0]), (0.3 - 0.28 * level) * high, 0.42 * high, 1, light);
  }
  return mesh;
}
