// SPDX-License-Identifier: BSD-2-Clause
import type { Drawable, Movement, Quat, Vec3 } from "../format/scene";
import type { ShapeMesh } from "./shape_library";

/** A scale, then a rotation, then a translation. */
export interface BoneState { place: Vec3; turn: Quat; scale: Vec3 }
/** Values of one property of a bone at ascending times; between two times it is interpolated, or the earlier value holds. */
interface Track { times: Float32Array; values: Float32Array; holds: boolean }
interface Tracks { place: Track; turn: Track; scale: Track }
interface Clip { lengthS: number; bones: ReadonlyMap<number, Tracks> }
/** The bones, joints and animations of a model from a file, as `MotionBytes` of app/shape_contents.cpp writes them. */
export interface Motion {
  /** Parents are before their children; -1: no parent. */
  bones: readonly { parent: number; bind: BoneState }[];
  /** `bone` -1: it never moves. `inverse`: three rows of four numbers. */
  joints: readonly { bone: number; inverse: Float32Array }[];
  clips: readonly Clip[];
}

/** The transformation of each joint into the world: three rows of four numbers. */
export const JOINT_NUMBERS = 12;

/** Reads numbers of four bytes. */
class Numbers {
  private at = 0;
  constructor(private readonly view: DataView) {}

  private room(bytes: number): number {
    const at = this.at;
    if (at + bytes > this.view.byteLength) throw new Error("the animations of a model are cut off");
    this.at += bytes;
    return at;
  }
  whole(): number {
    return this.view.getUint32(this.room(4), true);
  }
  floats(count: number): Float32Array {
    const at = this.room(4 * count), read = new Float32Array(count);
    for (let i = 0; i < count; ++i) read[i] = this.view.getFloat32(at + 4 * i, true);
    return read;
  }
}

function list<T>(count: number, one: () => T): T[] {
  const made: T[] = [];
  for (let i = 0; i < count; ++i) made.push(one());
  return made;
}

export function readMotion(bytes: ArrayBuffer): Motion {
  const input = new Numbers(new DataView(bytes));
  const bones = list(input.whole(), () => {
    const parent = input.whole() - 1, [x, y, z, qx, qy, qz, qw, sx, sy, sz] = input.floats(10) as unknown as number[];
    return { parent, bind: { place: [x!, y!, z!] as Vec3, turn: [qx!, qy!, qz!, qw!] as Quat, scale: [sx!, sy!, sz!] as Vec3 } };
  });
  const joints = list(input.whole(), () => {
    const bone = input.whole() - 1, columns = input.floats(JOINT_NUMBERS), inverse = new Float32Array(JOINT_NUMBERS);
    for (let row = 0; row < 3; ++row) for (let column = 0; column < 4; ++column) inverse[4 * row + column] = columns[3 * column + row]!;
    return { bone, inverse };
  });
  const track = (width: number): Track => {
    const count = input.whole(), holds = input.whole() !== 0;
    return { times: input.floats(count), values: input.floats(width * count), holds };
  };
  const clips = list(input.whole(), () => {
    const lengthS = input.floats(1)[0]!, moved = new Map<number, Tracks>();
    for (let left = input.whole(); left > 0; --left) moved.set(input.whole(), { place: track(3), turn: track(4), scale: track(3) });
    return { lengthS, bones: moved };
  });
  return { bones, joints, clips };
}

/** Writes the value at a time; `otherwise` if the track has none. */
function valueAt({ times, values, holds }: Track, timeS: number, otherwise: readonly number[], into: number[]): void {
  const width = otherwise.length;
  if (times.length === 0) {
    for (let i = 0; i < width; ++i) into[i] = otherwise[i]!;
    return;
  }
  let next = 0;
  for (let end = times.length; next < end;) {
    const middle = (next + end) >> 1;
    if (times[middle]! > timeS) end = middle;
    else next = middle + 1;
  }
  const before = Math.max(next - 1, 0), after = Math.min(next, times.length - 1), gap = times[after]! - times[before]!;
  const share = holds || gap <= 0 ? 0 : (timeS - times[before]!) / gap;
  let side = share;
  if (width === 4) {
    let dot = 0;
    for (let i = 0; i < 4; ++i) dot += values[4 * before + i]! * values[4 * after + i]!;
    if (dot < 0) side = -share;
  }
  for (let i = 0; i < width; ++i) into[i] = values[width * before + i]! * (1 - share) + values[width * after + i]! * side;
  if (width === 4) unit(into);
}

function unit(turn: number[]): void {
  const size = Math.hypot(turn[0]!, turn[1]!, turn[2]!, turn[3]!);
  for (let i = 0; i < 4; ++i) turn[i] = size > 1e-12 ? turn[i]! / size : i === 3 ? 1 : 0;
}

/** A weighted sum of states, as world::Pose computes it. */
class Mix {
  readonly place = [0, 0, 0];
  readonly turn = [0, 0, 0, 0];
  readonly scale = [0, 0, 0];
  sum = 0;

  clear(): void {
    this.place.fill(0), this.turn.fill(0), this.scale.fill(0);
    this.sum = 0;
  }
  add(place: readonly number[], turn: readonly number[], scale: readonly number[], weight: number): void {
    let dot = 0;
    for (let i = 0; i < 4; ++i) dot += this.turn[i]! * turn[i]!;
    for (let i = 0; i < 4; ++i) this.turn[i]! += turn[i]! * (dot < 0 ? -weight : weight);
    for (let i = 0; i < 3; ++i) {
      this.place[i]! += place[i]! * weight;
      this.scale[i]! += scale[i]! * weight;
    }
    this.sum += weight;
  }
  finish(): void {
    for (let i = 0; i < 3; ++i) {
      this.place[i]! /= this.sum;
      this.scale[i]! /= this.sum;
    }
    unit(this.turn);
  }
}

const mixed = new Mix(), place = [0, 0, 0], turn = [0, 0, 0, 1], scale = [1, 1, 1];

/** Writes the states of all bones relative to their parents into `into`, ten numbers for each. */
function localBones({ bones, clips }: Motion, movements: readonly Movement[], into: Float32Array): void {
  bones.forEach(({ bind }, bone) => {
    mixed.clear();
    for (const { clip, time, weight } of movements) {
      const played = clips[clip], tracks = played?.bones.get(bone);
      if (played === undefined || !(weight > 0)) continue;
      const at = Math.min(Math.max(time, 0), played.lengthS);
      if (tracks === undefined) {
        mixed.add(bind.place, bind.turn, bind.scale, weight);
        continue;
      }
      valueAt(tracks.place, at, bind.place, place);
      valueAt(tracks.turn, at, bind.turn, turn);
      valueAt(tracks.scale, at, bind.scale, scale);
      mixed.add(place, turn, scale, weight);
    }
    if (mixed.sum < 1) mixed.add(bind.place, bind.turn, bind.scale, 1 - mixed.sum);
    mixed.finish();
    into.set(mixed.place, 10 * bone);
    into.set(mixed.turn, 10 * bone + 3);
    into.set(mixed.scale, 10 * bone + 7);
  });
}

/** Interpolates between two states of equal size, along the shorter rotation. */
function blend(from: Float32Array, to: Float32Array, share: number): void {
  for (let at = 0; at < to.length; at += 10) {
    let dot = 0;
    for (let i = 3; i < 7; ++i) dot += from[at + i]! * to[at + i]!;
    for (let i = 0; i < 10; ++i) {
      const side = dot < 0 && i >= 3 && i < 7 ? -1 : 1;
      to[at + i] = from[at + i]! * (1 - share) * side + to[at + i]! * share;
    }
    const size = Math.hypot(to[at + 3]!, to[at + 4]!, to[at + 5]!, to[at + 6]!);
    if (size > 1e-12) for (let i = 3; i < 7; ++i) to[at + i]! /= size;
  }
}

function rotate(q: Float32Array, at: number, v: readonly number[]): Vec3 {
  const x = q[at]!, y = q[at + 1]!, z = q[at + 2]!, w = q[at + 3]!;
  const tx = 2 * (y * v[2]! - z * v[1]!), ty = 2 * (z * v[0]! - x * v[2]!), tz = 2 * (x * v[1]! - y * v[0]!);
  return [v[0]! + w * tx + y * tz - z * ty, v[1]! + w * ty + z * tx - x * tz, v[2]! + w * tz + x * ty - y * tx];
}

/** `into` = a · b, of ten numbers each. Scales are multiplied axis by axis, without shear. */
function compose(a: Float32Array, aAt: number, b: Float32Array, bAt: number, into: Float32Array, at: number): void {
  const moved = rotate(a, aAt + 3, [b[bAt]! * a[aAt + 7]!, b[bAt + 1]! * a[aAt + 8]!, b[bAt + 2]! * a[aAt + 9]!]);
  const ax = a[aAt + 3]!, ay = a[aAt + 4]!, az = a[aAt + 5]!, aw = a[aAt + 6]!, bx = b[bAt + 3]!, by = b[bAt + 4]!, bz = b[bAt + 5]!, bw = b[bAt + 6]!;
  for (let i = 0; i < 3; ++i) into[at + i] = a[aAt + i]! + moved[i]!;
  into[at + 3] = aw * bx + ax * bw + ay * bz - az * by;
  into[at + 4] = aw * by - ax * bz + ay * bw + az * bx;
  into[at + 5] = aw * bz + ax * by - ay * bx + az * bw;
  into[at + 6] = aw * bw - ax * bx - ay * by - az * bz;
  for (let i = 7; i < 10; ++i) into[at + i] = a[aAt + i]! * b[bAt + i]!;
}

/** Writes a state as rows. */
function setRows(state: Float32Array, at: number, into: Float32Array): void {
  for (let column = 0; column < 3; ++column) {
    const axis = rotate(state, at + 3, [column === 0 ? 1 : 0, column === 1 ? 1 : 0, column === 2 ? 1 : 0]);
    for (let row = 0; row < 3; ++row) into[4 * row + column] = axis[row]! * state[at + 7 + column]!;
  }
  for (let row = 0; row < 3; ++row) into[4 * row + 3] = state[at + row]!;
}

/** `into` = a · b, of three rows each; `into` may not overlap the others. */
function multiply(a: Float32Array, b: Float32Array, into: Float32Array, at: number): void {
  for (let row = 0; row < 3; ++row) {
    for (let column = 0; column < 4; ++column) {
      let sum = column === 3 ? a[4 * row + 3]! : 0;
      for (let k = 0; k < 3; ++k) sum += a[4 * row + k]! * b[4 * k + column]!;
      into[at + 4 * row + column] = sum;
    }
  }
}

const body = new Float32Array(10), earlier = new Float32Array(10), bodyRows = new Float32Array(JOINT_NUMBERS), boneRows = new Float32Array(JOINT_NUMBERS), bothRows = new Float32Array(JOINT_NUMBERS);

/** The interpolated joints of a model between two moments, as transformations from the space of its skin into the world. */
export function poseJoints(motion: Motion, now: Drawable, old: Drawable | undefined, share: number, into: Float32Array): void {
  const { bones, joints } = motion, local = new Float32Array(10 * bones.length), whole = new Float32Array(10 * bones.length);
  localBones(motion, now.movements ?? [], local);
  body.set([...now.place, ...now.turn, ...now.scale]);
  if (old !== undefined && share < 1) {
    const before = new Float32Array(10 * bones.length);
    localBones(motion, old.movements ?? [], before);
    blend(before, local, share);
    earlier.set([...old.place, ...old.turn, ...now.scale]);
    blend(earlier, body, share);
  }
  bones.forEach(({ parent }, i) => {
    if (parent >= 0) compose(whole, 10 * parent, local, 10 * i, whole, 10 * i);
    else whole.set(local.subarray(10 * i, 10 * i + 10), 10 * i);
  });
  setRows(body, 0, bodyRows);
  joints.forEach(({ bone, inverse }, i) => {
    if (bone < 0) {
      multiply(bodyRows, inverse, into, JOINT_NUMBERS * i);
      return;
    }
    setRows(whole, 10 * bone, boneRows);
    multiply(boneRows, inverse, bothRows, 0);
    multiply(bodyRows, bothRows, into, JOINT_NUMBERS * i);
  });
}

const sum = new Float32Array(JOINT_NUMBERS);

/** Moves the corners of a model. Normals are bytes (127 is 1), four for each corner. */
export function moveCorners({ positions, normals, count, skin }: ShapeMesh, joints: Float32Array, places: Float32Array, facing: Int8Array): void {
  if (skin === null) return;
  for (let i = 0; i < count; ++i) {
    sum.fill(0);
    for (let k = 4 * i; k < 4 * i + 4; ++k) {
      const share = skin.shares[k]!, at = JOINT_NUMBERS * skin.bones[k]!;
      if (share > 0) for (let n = 0; n < JOINT_NUMBERS; ++n) sum[n]! += share * joints[at + n]!;
    }
    const [a, b, c, p, d, e, f, q, g, h, j, r] = sum as unknown as [number, number, number, number, number, number, number, number, number, number, number, number];
    const x = positions[3 * i]!, y = positions[3 * i + 1]!, z = positions[3 * i + 2]!, nx = normals[3 * i]!, ny = normals[3 * i + 1]!, nz = normals[3 * i + 2]!;
    places[3 * i] = a * x + b * y + c * z + p;
    places[3 * i + 1] = d * x + e * y + f * z + q;
    places[3 * i + 2] = g * x + h * y + j * z + r;
    // Under uneven scales, normals require the cofactors.
    const X = (e * j - f * h) * nx + (f * g - d * j) * ny + (d * h - e * g) * nz;
    const Y = (c * h - b * j) * nx + (a * j - c * g) * ny + (b * g - a * h) * nz;
    const Z = (b * f - c * e) * nx + (c * d - a * f) * ny + (a * e - b * d) * nz;
    const size = 127 / Math.max(Math.hypot(X, Y, Z), 1e-12);
    facing[4 * i] = X * size;
    facing[4 * i + 1] = Y * size;
    facing[4 * i + 2] = Z * size;
  }
}
