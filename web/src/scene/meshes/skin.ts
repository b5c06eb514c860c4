// SPDX-License-Identifier: BSD-2-Clause
import type { Quat, Vec3 } from "../../format/scene";
import { clamp, cross, length, MeshData, minus, plus, times, unit } from "./mesh_data";

/** Which bones move a vertex: two at most, the first by `share`. */
export interface By { bone: number; other: number; share: number }
export const by = (bone: number, other = 0, share = 1): By => ({ bone, other, share });

/** What a piece is made of: a cell of the picture of cloths, or the colour of the team. */
export enum Cloth { Camouflage, Webbing, Skin, Leather, Metal, Glass, Helmet, Rubber, Steel, Team, DarkCamouflage, DarkWebbing, DarkHelmet }
export const CLOTHS = 13;

const GLOSS: Readonly<Partial<Record<Cloth, number>>> = {
  [Cloth.Glass]: 0.9, [Cloth.Metal]: 0.5, [Cloth.Steel]: 0.5, [Cloth.Leather]: 0.22, [Cloth.Rubber]: 0.2,
  [Cloth.Helmet]: 0.12, [Cloth.DarkHelmet]: 0.12, [Cloth.Skin]: 0.12, [Cloth.Team]: 0.12,
};

export interface Pose { place: Vec3; turn: Quat }
export function rotate(q: Quat, v: Vec3): Vec3 {
  const u: Vec3 = [q[0], q[1], q[2]], t = times(cross(u, v), 2);
  return plus(plus(v, times(t, q[3])), cross(u, t));
}
export function quatTimes(a: Quat, b: Quat): Quat {
  return [
    a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1], a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
    a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3], a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
  ];
}
export const conjugate = (q: Quat): Quat => [-q[0], -q[1], -q[2], q[3]];
export const within = (a: Pose, b: Pose): Pose => ({ place: plus(a.place, rotate(a.turn, b.place)), turn: quatTimes(a.turn, b.turn) });
export function inverse(a: Pose): Pose {
  const back = conjugate(a.turn);
  return { place: rotate(back, times(a.place, -1)), turn: back };
}
export const STILL: Pose = { place: [0, 0, 0], turn: [0, 0, 0, 1] };

/** Triangles that bones move, in the bind pose. */
export class SkinMesh {
  readonly mesh = new MeshData();
  readonly bones: number[] = [];
  readonly shares: number[] = [];
}

const power = (value: number, exponent: number): number => Math.sign(value) * Math.abs(value) ** exponent;

export interface Loop { centre: Vec3; right: number; ahead: number; skin: By; square: number; light: number }
export const loop = (centre: Vec3, right: number, ahead: number, skin: By, square = 0, light = 1): Loop => ({ centre, right, ahead, skin, square, light });

/** Builds bodies from rounded pieces: lofts through loops, and boxes and balls in one. */
export class SkinBuilder {
  readonly made = new SkinMesh();
  bone: By = by(0);
  cloth: Cloth = Cloth.Camouflage;
  light = 1;
  /** The pieces that follow are put here. */
  place: Pose = STILL;

  /** `fineness`: 1 fine, 0.3 for what is seen from afar. */
  constructor(private readonly fineness: number) {}

  wear(cloth: Cloth, bone: By, light = 1): void {
    this.cloth = cloth;
    this.bone = bone;
    this.light = light;
  }

  /** Joins loops whose planes stand across the way, with `ahead` as their second direction. */
  loft(given: readonly Loop[], segments: number, ahead: Vec3, closedEnds = true): void {
    const around = this.count(segments);
    const loops = given.filter((_, i) => i === 0 || i + 1 === given.length || this.fineness >= 0.31 || given.length < 5 || i % 2 === 0);
    const rows: Vec3[][] = [], skins: By[] = [], lights: number[] = [];
    const end = (one: Loop): void => {
      rows.push(Array.from({ length: around }, () => one.centre));
      skins.push(one.skin);
      lights.push(one.light);
    };
    if (closedEnds) end(loops[0]!);
    loops.forEach((one, i) => {
      const along = unit(minus(loops[Math.min(i + 1, loops.length - 1)]!.centre, loops[Math.max(i - 1, 0)]!.centre));
      const right = unit(cross(along, ahead)), front = cross(right, along), exponent = 1 - 0.72 * one.square;
      rows.push(Array.from({ length: around }, (_, s) => {
        const angle = (2 * Math.PI * (s + 0.5)) / around;
        return minus(plus(one.centre, times(right, one.right * power(Math.cos(angle), exponent))), times(front, one.ahead * power(Math.sin(angle), exponent)));
      }));
      skins.push(one.skin);
      lights.push(one.light);
    });
    if (closedEnds) end(loops.at(-1)!);
    this.grid(rows, skins, lights);
  }

  /** A body with half sizes `half`; round 1: an ellipsoid, 0.2: a box with round edges. */
  round(centre: Vec3, half: Vec3, round: number, segments = 14, from = -1, to = 1, bend: (p: Vec3) => Vec3 = (p) => p): void {
    const around = this.count(segments), up = Math.max(this.fineness < 0.31 ? 3 : 4, Math.floor(around / 2));
    const rows = Array.from({ length: up + 1 }, (_, r) => {
      const t = from + ((to - from) * r) / up, high = power(Math.sin((t * Math.PI) / 2), round);
      const wide = (r === 0 && from <= -1) || (r === up && to >= 1) ? 0 : power(Math.cos((t * Math.PI) / 2), round);
      return Array.from({ length: around }, (_none, s) => {
        const angle = (2 * Math.PI * (s + 0.5)) / around;
        return bend(plus(centre, [half[0] * wide * power(Math.cos(angle), round), half[1] * high, -half[2] * wide * power(Math.sin(angle), round)]));
      });
    });
    this.grid(rows, rows.map(() => this.bone), rows.map(() => 1));
  }

  tube(points: readonly Vec3[], radius: number, segments = 8): void {
    const first = points[0]!, last = points.at(-1)!, start = unit(minus(points[1]!, first)), end = unit(minus(last, points.at(-2)!));
    const at = (p: Vec3, r: number): Loop => loop(p, r, r, this.bone);
    const whole = minus(last, first);
    this.loft([at(minus(first, times(start, 0.7 * radius)), 0.65 * radius), ...points.map((p) => at(p, radius)), at(plus(last, times(end, 0.7 * radius)), 0.65 * radius)],
      segments, Math.abs(whole[1]) < 0.7 * length(whole) ? [0, 1, 0.13] : [0.13, 0.1, 1]);
  }

  private count(segments: number): number {
    return Math.max(4, Math.round(segments * this.fineness));
  }

  private grid(rows: readonly (readonly Vec3[])[], skins: readonly By[], lights: readonly number[]): void {
    const mesh = this.made.mesh, base = mesh.count, count = rows.length, around = rows[0]!.length;
    const isPoint = (row: readonly Vec3[]): boolean => length(minus(row[0]!, row[Math.floor(around / 2)]!)) < 1e-4;
    for (let r = 0; r < count; ++r) {
      const row = rows[r]!, near = rows[r === 0 ? 1 : r - 1]!, point = isPoint(row) && (r === 0 || r + 1 === count);
      for (let s = 0; s <= around; ++s) {
        const here = s % around, next = (here + 1) % around, last = (here + around - 1) % around;
        let across = minus(row[next]!, row[last]!);
        if (length(across) < 1e-5) across = minus(near[next]!, near[last]!);
        let normal = unit(cross(across, minus(rows[Math.min(r + 1, count - 1)]![here]!, rows[Math.max(r - 1, 0)]![here]!)));
        if (point) {
          const middle = times(near.reduce<Vec3>((sum, p) => plus(sum, p), [0, 0, 0]), 1 / around), away = minus(row[0]!, middle);
          normal = length(away) > 1e-4 ? unit(away) : unit(minus(row[0]!, rows[r === 0 ? count - 1 : 0]![0]!));
        }
        this.vertex(plus(this.place.place, rotate(this.place.turn, row[here]!)), rotate(this.place.turn, normal), skins[r]!, lights[r]!);
      }
    }
    const width = around + 1;
    for (let r = 0; r + 1 < count; ++r) {
      for (let s = 0; s < around; ++s) {
        const a = base + r * width + s;
        mesh.quad(a, a + 1, a + width + 1, a + width);
      }
    }
  }

  private vertex(at: Vec3, normal: Vec3, skin: By, light: number): void {
    // The picture of cloths has four by four cells; a border keeps neighbours out of coarse levels.
    const cell = this.cloth as number, share = (value: number, index: number): number => (index + 0.06 + 0.88 * clamp(value, 0, 1)) / 4;
    this.made.mesh.vertex(at, normal, share((at[0] + 0.6 * at[2] + 1) / 2, cell % 4), share(1 - (at[1] + 0.25 * at[2]) / 1.85, Math.floor(cell / 4)),
      this.cloth === Cloth.Team ? 0 : 1, this.light * light, GLOSS[this.cloth] ?? 0);
    this.made.bones.push(skin.bone, skin.other, 0, 0);
    this.made.shares.push(skin.share, 1 - skin.share, 0, 0);
  }
}
