// SPDX-License-Identifier: BSD-2-Clause
import type { Bone, Drawable, Quat, Vec3 } from "../format/scene";
import type { BoneAt, ShapeMesh } from "./shape_library";

/** A bone's transformation from the bind pose into the world: three rows of four numbers. */
export const BONE_NUMBERS = 12;

/**
 * The moved corners of several bodies, one body after the other. Normals are bytes (127 is 1), four for each corner.
 */
export interface Moved { positions: Float32Array<ArrayBuffer>; normals: Int8Array<ArrayBuffer> }

type Rows = Float32Array | number[];

/** Writes a rotation and a position as rows. */
function setPose(into: Rows, at: number, turn: Quat | readonly number[], place: Vec3 | readonly number[]): void {
  const x = turn[0]!, y = turn[1]!, z = turn[2]!, w = turn[3]!;
  into[at] = 1 - 2 * (y * y + z * z);
  into[at + 1] = 2 * (x * y - z * w);
  into[at + 2] = 2 * (x * z + y * w);
  into[at + 3] = place[0]!;
  into[at + 4] = 2 * (x * y + z * w);
  into[at + 5] = 1 - 2 * (x * x + z * z);
  into[at + 6] = 2 * (y * z - x * w);
  into[at + 7] = place[1]!;
  into[at + 8] = 2 * (x * z - y * w);
  into[at + 9] = 2 * (y * z + x * w);
  into[at + 10] = 1 - 2 * (x * x + y * y);
  into[at + 11] = place[2]!;
}

/** `into` = a · b; the three may not overlap. */
function multiply(a: Rows, aAt: number, b: Rows, bAt: number, into: Rows, at: number): void {
  for (let row = 0; row < 3; ++row) {
    const r = aAt + 4 * row, x = a[r]!, y = a[r + 1]!, z = a[r + 2]!, o = at + 4 * row;
    for (let column = 0; column < 4; ++column) into[o + column] = x * b[bAt + column]! + y * b[bAt + 4 + column]! + z * b[bAt + 8 + column]! + (column === 3 ? a[r + 3]! : 0);
  }
}

/** The inverse of each bone's bind pose in the model. */
const inverses = new WeakMap<readonly BoneAt[], Float32Array>();
function inversesOf(bones: readonly BoneAt[]): Float32Array {
  let known = inverses.get(bones);
  if (known !== undefined) return known;
  known = new Float32Array(bones.length * BONE_NUMBERS);
  const pose = new Float32Array(BONE_NUMBERS);
  bones.forEach(({ inModel }, i) => {
    setPose(pose, 0, inModel.turn, inModel.place);
    for (let row = 0; row < 3; ++row) {
      for (let column = 0; column < 3; ++column) known![i * BONE_NUMBERS + 4 * row + column] = pose[4 * column + row]!;
      known![i * BONE_NUMBERS + 4 * row + 3] = -(pose[row]! * pose[3]! + pose[4 + row]! * pose[7]! + pose[8 + row]! * pose[11]!);
    }
  });
  inverses.set(bones, known);
  return known;
}

const turn = [0, 0, 0, 1], place = [0, 0, 0], local = new Float32Array(BONE_NUMBERS), root = new Float32Array(BONE_NUMBERS);
let models = new Float32Array(0);

/** Interpolates between two poses that are near each other, along the shorter rotation. */
function blend(from: { turn: Quat; place: Vec3 }, to: { turn: Quat; place: Vec3 }, share: number): void {
  const a = from.turn, b = to.turn, side = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3] < 0 ? -share : share;
  let size = 0;
  for (let i = 0; i < 4; ++i) {
    turn[i] = a[i]! * (1 - share) + b[i]! * side;
    size += turn[i]! * turn[i]!;
  }
  size = size > 1e-12 ? 1 / Math.sqrt(size) : 0;
  for (let i = 0; i < 4; ++i) turn[i]! *= size;
  for (let i = 0; i < 3; ++i) place[i] = from.place[i]! + (to.place[i]! - from.place[i]!) * share;
}

/** The interpolated poses of a body's bones between two moments, as transformations from the bind pose into the world. */
export function poseBones(bones: readonly BoneAt[], now: Drawable, old: Drawable | undefined, share: number, into: Float32Array): void {
  const from = old !== undefined && share < 1 ? old : now, back = inversesOf(bones);
  if (models.length < bones.length * BONE_NUMBERS) models = new Float32Array(bones.length * BONE_NUMBERS);
  blend(from, now, share);
  setPose(root, 0, turn, place);
  for (let row = 0; row < 3; ++row) for (let column = 0; column < 3; ++column) root[4 * row + column]! *= now.scale[column]!;
  for (let i = 0; i < bones.length; ++i) {
    const bind = bones[i]!.bind, to: Bone = now.bones[i] ?? bind, at = i * BONE_NUMBERS, parent = bones[i]!.parent;
    blend(from.bones[i] ?? to, to, share);
    setPose(local, 0, turn, place);
    if (parent < 0) multiply(root, 0, local, 0, models, at);
    else multiply(models, parent * BONE_NUMBERS, local, 0, models, at);
    multiply(models, at, back, at, into, at);
  }
}

/** Moves the corners of one body. Writes them into `into`, from the corner `first` on. */
export function moveSkin(shape: ShapeMesh, bones: Float32Array, into: Moved, first: number): void {
  const { positions, normals, count, skin } = shape, to = into.positions, facing = into.normals;
  if (skin === null) return;
  const by = skin.bones, shares = skin.shares;
  for (let i = 0, p = 0, q = 0, o = 3 * first, f = 4 * first; i < count; ++i, p += 3, q += 4, o += 3, f += 4) {
    const x = positions[p]!, y = positions[p + 1]!, z = positions[p + 2]!, nx = normals[p]!, ny = normals[p + 1]!, nz = normals[p + 2]!, share = shares[q]!;
    let b = by[q]! * BONE_NUMBERS;
    let X = bones[b]! * x + bones[b + 1]! * y + bones[b + 2]! * z + bones[b + 3]!, Y = bones[b + 4]! * x + bones[b + 5]! * y + bones[b + 6]! * z + bones[b + 7]!;
    let Z = bones[b + 8]! * x + bones[b + 9]! * y + bones[b + 10]! * z + bones[b + 11]!;
    let NX = bones[b]! * nx + bones[b + 1]! * ny + bones[b + 2]! * nz, NY = bones[b + 4]! * nx + bones[b + 5]! * ny + bones[b + 6]! * nz, NZ = bones[b + 8]! * nx + bones[b + 9]! * ny + bones[b + 10]! * nz;
    if (share < 1) {
      const other = 1 - share;
      b = by[q + 1]! * BONE_NUMBERS;
      X = X * share + other * (bones[b]! * x + bones[b + 1]! * y + bones[b + 2]! * z + bones[b + 3]!);
      Y = Y * share + other * (bones[b + 4]! * x + bones[b + 5]! * y + bones[b + 6]! * z + bones[b + 7]!);
      Z = Z * share + other * (bones[b + 8]! * x + bones[b + 9]! * y + bones[b + 10]! * z + bones[b + 11]!);
      NX = NX * share + other * (bones[b]! * nx + bones[b + 1]! * ny + bones[b + 2]! * nz);
      NY = NY * share + other * (bones[b + 4]! * nx + bones[b + 5]! * ny + bones[b + 6]! * nz);
      NZ = NZ * share + other * (bones[b + 8]! * nx + bones[b + 9]! * ny + bones[b + 10]! * nz);
    }
    to[o] = X;
    to[o + 1] = Y;
    to[o + 2] = Z;
    const size = 127 / Math.max(Math.sqrt(NX * NX + NY * NY + NZ * NZ), 1e-6);
    facing[f] = NX * size;
    facing[f + 1] = NY * size;
    facing[f + 2] = NZ * size;
  }
}
