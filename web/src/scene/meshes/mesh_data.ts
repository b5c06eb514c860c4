// SPDX-License-Identifier: BSD-2-Clause
import type { Vec3 } from "../../format/scene";

/**
 * Triangles as plain data, built by code: the shapes of the window's viewer. Counter-clockwise seen from outside. Beside
 * its geometry a vertex has paint: tint (1 the material's colour, 0 its second one), light (multiplies the colour) and gloss.
 */
export class MeshData {
  readonly positions: number[] = [];
  readonly normals: number[] = [];
  readonly uvs: number[] = [];
  readonly paint: number[] = [];
  readonly indices: number[] = [];
  /** Used where the drawable names none. */
  material = "White";

  get count(): number {
    return this.positions.length / 3;
  }

  vertex(at: Vec3, normal: Vec3, u = 0, v = 0, tint = 1, light = 1, gloss = 0): number {
    this.positions.push(...at);
    this.normals.push(...normal);
    this.uvs.push(u, v);
    this.paint.push(tint, light, gloss);
    return this.count - 1;
  }

  triangle(a: number, b: number, c: number): void {
    this.indices.push(a, b, c);
  }

  quad(a: number, b: number, c: number, d: number): void {
    this.indices.push(a, b, c, a, c, d);
  }

  /** Three corners of their own, with one normal. */
  facet(a: Vec3, b: Vec3, c: Vec3, of: (p: Vec3, normal: Vec3) => { u: number; v: number; tint?: number; light?: number }): void {
    const face = cross(minus(b, a), minus(c, a));
    if (dot(face, face) < 1e-12) return;
    const normal = unit(face);
    for (const p of [a, b, c]) {
      const { u, v, tint, light } = of(p, normal);
      this.vertex(p, normal, u, v, tint ?? 1, light ?? 1);
    }
    this.triangle(this.count - 3, this.count - 2, this.count - 1);
  }

  append(other: MeshData): void {
    const base = this.count;
    for (const index of other.indices) this.indices.push(base + index);
    for (const [into, from] of [[this.positions, other.positions], [this.normals, other.normals], [this.uvs, other.uvs], [this.paint, other.paint]] as const)
      for (const value of from) into.push(value);
  }

  /** Moves what is there, and paints it if a coat is given. */
  moved(by: Vec3, coat?: { tint?: number; light?: number; gloss?: number }): this {
    for (let i = 0; i < this.positions.length; ++i) this.positions[i]! += by[i % 3]!;
    if (coat !== undefined) {
      for (let i = 0; i < this.paint.length; i += 3) {
        if (coat.tint !== undefined) this.paint[i] = coat.tint;
        this.paint[i + 1]! *= coat.light ?? 1;
        if (coat.gloss !== undefined) this.paint[i + 2] = coat.gloss;
      }
    }
    return this;
  }

  scaled(by: number): this {
    for (let i = 0; i < this.positions.length; ++i) this.positions[i]! *= by;
    return this;
  }
}

export const plus = (a: Vec3, b: Vec3): Vec3 => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const minus = (a: Vec3, b: Vec3): Vec3 => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const times = (a: Vec3, by: number): Vec3 => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vec3, b: Vec3): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vec3, b: Vec3): Vec3 => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a: Vec3): number => Math.hypot(a[0], a[1], a[2]);
export function unit(a: Vec3): Vec3 {
  const size = length(a);
  return size > 1e-12 ? times(a, 1 / size) : [0, 0, 0];
}
export const clamp = (value: number, low: number, high: number): number => Math.min(Math.max(value, low), high);
