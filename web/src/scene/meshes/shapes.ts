// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../../format/scene";
import { clamp, cross, MeshData, minus, unit } from "./mesh_data";

interface Ring { radius: number; y: number; tint?: number; light?: number; gloss?: number }

const sane = (size: number): number => (Number.isFinite(size) && size > 0 ? size : 0);

let isCoarse = false;

/** Whatever is made meanwhile has fewer faces: for pictures that the processor draws. */
export function coarsely<T>(coarse: boolean, make: () => T): T {
  const before = isCoarse;
  isCoarse = coarse;
  try {
    return make();
  } finally {
    isCoarse = before;
  }
}
/** How many parts something round is made of. */
export const partsOf = (fine: number): number => (isCoarse ? Math.max(5, Math.round(fine * 0.45)) : fine);

/** Turns a profile, from bottom to top, about the y axis. */
function revolve(profile: readonly Ring[]): MeshData {
  const mesh = new MeshData(), segments = partsOf(28);
  profile.forEach((ring, i) => {
    const below = profile[Math.max(i - 1, 0)]!, above = profile[Math.min(i + 1, profile.length - 1)]!;
    const dr = above.radius - below.radius, dy = above.y - below.y, size = Math.max(Math.hypot(dr, dy), 1e-6);
    const pole = ring.radius < 1e-5;
    const out = pole ? 0 : dy / size, up = pole ? (i === 0 ? -1 : 1) : -dr / size;
    for (let s = 0; s <= segments; ++s) {
      const turn = s / segments, x = Math.sin(2 * Math.PI * turn), z = Math.cos(2 * Math.PI * turn);
      mesh.vertex([ring.radius * x, ring.y, ring.radius * z], [out * x, up, out * z], turn, 1 - i / (profile.length - 1), ring.tint, ring.light, ring.gloss);
    }
  });
  const row = segments + 1;
  for (let i = 0; i + 1 < profile.length; ++i) {
    for (let s = 0; s < segments; ++s) {
      const a = i * row + s;
      mesh.quad(a, a + 1, a + row + 1, a + row);
    }
  }
  return mesh;
}

function arc(profile: Ring[], radius: number, height: number, centre: number, from: number, to: number, fineSteps: number, light?: number): void {
  const steps = isCoarse ? Math.max(2, Math.round(fineSteps * 0.4)) : fineSteps;
  for (let i = 0; i <= steps; ++i) {
    const angle = from + ((to - from) * i) / steps;
    profile.push({ radius: Math.max(0, radius * Math.cos(angle)), y: centre + height * Math.sin(angle), ...(light === undefined ? {} : { light }) });
  }
}

export function boxMesh(min: Vec3, max: Vec3, style: { repeats?: readonly [number, number]; chamfer?: number; metricUv?: boolean } = {}): MeshData {
  const [ru, rv] = style.repeats ?? [1, 1];
  const size: Vec3 = [sane(max[0] - min[0]), sane(max[1] - min[1]), sane(max[2] - min[2])];
  const chamfer = Math.min(style.chamfer ?? 0.02, 0.2 * Math.min(...size));
  const lo = min, hi: Vec3 = [min[0] + size[0], min[1] + size[1], min[2] + size[2]];
  const mesh = new MeshData();
  const index = (axis: number, high: boolean, highU: boolean, highV: boolean): number => 4 * (2 * axis + (high ? 1 : 0)) + (highV ? 2 : 0) + (highU ? 1 : 0);
  const sides = [false, true];
  for (let n = 0; n < 3; ++n) {
    const u = (n + 1) % 3, v = (n + 2) % 3;
    for (const high of sides) {
      for (const highV of sides) {
        for (const highU of sides) {
          const p = [0, 0, 0], normal = [0, 0, 0];
          p[n] = high ? hi[n]! : lo[n]!;
          p[u] = highU ? hi[u]! - chamfer : lo[u]! + chamfer;
          p[v] = highV ? hi[v]! - chamfer : lo[v]! + chamfer;
          normal[n] = high ? 1 : -1;
          // Upright faces keep the texture's v along the world's y.
          const across = n === 0 ? 2 : 0, upward = n === 1 ? 2 : 1;
          const share = (axis: number): number => (p[axis]! - lo[axis]!) / Math.max(hi[axis]! - lo[axis]!, 1e-6);
          const [s, t] = style.metricUv === true ? [p[across]!, -p[upward]!] : [ru * share(across), rv * (1 - share(upward))];
          mesh.vertex(p as unknown as Vec3, normal as unknown as Vec3, s, t);
        }
      }
      const [a, b, c, d] = [index(n, high, false, false), index(n, high, true, false), index(n, high, true, true), index(n, high, false, true)];
      if (high) mesh.quad(a, b, c, d);
      else mesh.quad(a, d, c, b);
    }
  }
  if (chamfer <= 0) return mesh;
  for (let n = 0; n < 3; ++n) {
    const u = (n + 1) % 3;
    for (const highN of sides) {
      for (const highU of sides) {
        const a = index(n, highN, highU, false), b = index(n, highN, highU, true), c = index(u, highU, true, highN), d = index(u, highU, false, highN);
        if (highN === highU) mesh.quad(a, d, c, b);
        else mesh.quad(a, b, c, d);
      }
    }
  }
  for (const x of sides) {
    for (const y of sides) {
      for (const z of sides) {
        const a = index(0, x, y, z), b = index(1, y, z, x), c = index(2, z, x, y);
        if ((x !== y) !== z) mesh.triangle(a, b, c);
        else mesh.triangle(a, c, b);
      }
    }
  }
  return mesh;
}

export function boxAround(middle: Vec3, size: Vec3, chamfer = 0.02): MeshData {
  return boxMesh(
    [middle[0] - size[0] / 2, middle[1] - size[1] / 2, middle[2] - size[2] / 2],
    [middle[0] + size[0] / 2, middle[1] + size[1] / 2, middle[2] + size[2] / 2], { chamfer });
}

export function capsuleMesh(radiusM: number, heightM: number): MeshData {
  const radius = sane(radiusM), half = Math.max(0, sane(heightM) / 2 - radius), profile: Ring[] = [];
  arc(profile, radius, radius, -half, -Math.PI / 2, 0, 8);
  arc(profile, radius, radius, half, 0, Math.PI / 2, 8);
  return revolve(profile);
}

export function cylinderMesh(radiusM: number, heightM: number): MeshData {
  const radius = sane(radiusM), half = sane(heightM) / 2, rim = Math.min(0.03, 0.2 * radius, 0.4 * half);
  const profile: Ring[] = [{ radius: 0, y: -half }, { radius: 0.5 * (radius - rim), y: -half }];
  const corner = (centre: number, from: number, to: number): void => {
    const made: Ring[] = [];
    arc(made, rim, rim, centre, from, to, 3);
    for (const ring of made) profile.push({ ...ring, radius: ring.radius + radius - rim });
  };
  corner(-half + rim, -Math.PI / 2, 0);
  corner(half - rim, 0, Math.PI / 2);
  profile.push({ radius: 0.5 * (radius - rim), y: half }, { radius: 0, y: half });
  return revolve(profile);
}

export function sphereMesh(radiusM: number): MeshData {
  const profile: Ring[] = [];
  arc(profile, sane(radiusM), sane(radiusM), 0, -Math.PI / 2, Math.PI / 2, 18);
  return revolve(profile);
}

export function planeMesh(sizeX: number, sizeZ: number, repeatsU: number, repeatsV: number): MeshData {
  const x = sane(sizeX) / 2, z = sane(sizeZ) / 2, up: Vec3 = [0, 1, 0], mesh = new MeshData();
  mesh.vertex([-x, 0, -z], up, 0, 0);
  mesh.vertex([-x, 0, z], up, 0, repeatsV);
  mesh.vertex([x, 0, z], up, repeatsU, repeatsV);
  mesh.vertex([x, 0, -z], up, repeatsU, 0);
  mesh.quad(0, 1, 2, 3);
  return mesh;
}

/** Radius of a profile at a height, between its rings. */
function radiusAt(profile: readonly Ring[], y: number): number {
  for (let i = 1; i < profile.length; ++i) {
    const above = profile[i]!, below = profile[i - 1]!;
    if (y > above.y) continue;
    const t = clamp((y - below.y) / Math.max(above.y - below.y, 1e-6), 0, 1);
    return below.radius + (above.radius - below.radius) * t;
  }
  return 0;
}

/** A dark, glossy patch on the front (+z) that shows where somebody looks; its border sinks into the body. */
function visor(profile: readonly Ring[], low: number, high: number, halfAngle: number, radius: number): MeshData {
  const columns = partsOf(20), rows = partsOf(12), mesh = new MeshData();
  const point = (a: number, b: number): Vec3 => {
    const y = (low + high) / 2 + ((high - low) / 2) * b, inside = 1 - a ** 4 - b ** 4;
    const r = radiusAt(profile, y) + radius * (inside > 0 ? 0.075 * Math.sqrt(inside) : -0.1 * Math.min(1, -inside));
    return [r * Math.sin(a * halfAngle), y, r * Math.cos(a * halfAngle)];
  };
  for (let row = 0; row <= rows; ++row) {
    for (let column = 0; column <= columns; ++column) {
      const a = (2 * column) / columns - 1, b = (2 * row) / rows - 1;
      const across = minus(point(a + 0.02, b), point(a - 0.02, b)), up = minus(point(a, b + 0.02), point(a, b - 0.02));
      mesh.vertex(point(a, b), unit(cross(across, up)), 0, 0, 0, 1, 1);
    }
  }
  const width = columns + 1;
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      const a = row * width + column;
      mesh.quad(a, a + 1, a + width + 1, a + width);
    }
  }
  return mesh;
}

/** The body of an agent that has no other: a capsule with foot, neck, head and visor. */
export function agentMesh(radiusM: number, heightM: number): MeshData {
  const r = sane(radiusM), height = Math.max(sane(heightM), 2 * r), bottom = -height / 2, top = height / 2, neck = top - 0.36 * height;
  const profile: Ring[] = [];
  arc(profile, 0.86 * r, 0.42 * r, bottom + 0.42 * r, -Math.PI / 2, 0, 6, 0.75);
  profile.push(
    { radius: 0.9 * r, y: bottom + 0.55 * r }, { radius: 0.95 * r, y: bottom + 0.85 * r },
    { radius: 0.985 * r, y: (bottom + 0.85 * r + neck) / 2 }, { radius: 0.99 * r, y: neck - 0.14 * r },
    { radius: 0.965 * r, y: neck - 0.06 * r }, { radius: 0.915 * r, y: neck - 0.015 * r, light: 0.7 },
    { radius: 0.885 * r, y: neck + 0.005 * r, tint: 0, light: 0.6 }, { radius: 0.885 * r, y: neck + 0.055 * r, tint: 0, light: 0.6 },
    { radius: 0.915 * r, y: neck + 0.075 * r, light: 0.7 }, { radius: 0.965 * r, y: neck + 0.12 * r });
  const dome = Math.max(top - r, neck + 0.2 * r);
  arc(profile, r, top - dome, dome, 0, Math.PI / 2, 10);
  const mesh = revolve(profile), low = neck + 0.26 * r;
  mesh.append(visor(profile, low, Math.max(low + 0.3 * r, dome + 0.5 * (top - dome)), 1.05, r));
  return mesh;
}
