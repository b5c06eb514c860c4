// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { Shape, type Drawable } from "../format/scene";
import type { BoneAt, ShapeMesh } from "./shape_library";
import { BONE_NUMBERS, moveSkin, poseBones } from "./skinning";

const STILL = [0, 0, 0, 1] as const, QUARTER = [0, Math.SQRT1_2, 0, Math.SQRT1_2] as const;
/** A shoulder a metre up, and an elbow a metre further along x. */
const BONES: readonly BoneAt[] = [
  { parent: -1, inModel: { place: [0, 1, 0], turn: STILL }, bind: { place: [0, 1, 0], turn: STILL } },
  { parent: 0, inModel: { place: [1, 1, 0], turn: STILL }, bind: { place: [1, 0, 0], turn: STILL } },
];
/** Corners at the shoulder, between the two, and beyond the elbow. */
const ARM: ShapeMesh = {
  count: 3, positions: Float32Array.from([0, 1, 0, 1, 1, 0, 2, 1, 0]), normals: Float32Array.from([0, 0, 1, 0, 0, 1, 1, 0, 0]), uvs: new Float32Array(6), paint: new Float32Array(9),
  indices: Uint32Array.from([0, 1, 2]), material: "", skin: { bones: Uint16Array.from([0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0]), shares: Float32Array.from([1, 0, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 0]) },
};
const body = (more: Partial<Drawable>): Drawable => ({
  owner: 1, ofAgent: true, visible: true, skeletonShown: false, shape: Shape.Mesh, mesh: "", material: "", size: [0, 0, 0], repeats: [1, 1, 1], scale: [1, 1, 1], place: [0, 0, 0], turn: STILL,
  bones: BONES.map((one) => one.bind), ...more,
});

function corners(now: Drawable, old?: Drawable, share = 1): { places: number[]; normals: number[] } {
  const bones = new Float32Array(BONES.length * BONE_NUMBERS), moved = { positions: new Float32Array(18), normals: new Int8Array(24) };
  poseBones(BONES, now, old, share, bones);
  moveSkin(ARM, bones, moved, 3);
  const rounded = (all: Iterable<number>): number[] => [...all].map((one) => Math.round(one * 100) / 100 + 0);
  return { places: rounded(moved.positions.subarray(9)), normals: [...moved.normals.subarray(12)] };
}

test("in the bind pose, vertices are at the body's place", () => {
  assert.deepEqual(corners(body({ place: [5, 0, 2] })).places, [5, 1, 2, 6, 1, 2, 7, 1, 2]);
  assert.deepEqual(corners(body({ scale: [2, 2, 2] })).places, [0, 2, 0, 2, 2, 0, 4, 2, 0]);
});

test("a turning bone moves its vertices according to their weights", () => {
  const { places, normals } = corners(body({ bones: [BONES[0]!.bind, { place: [1, 0, 0], turn: QUARTER }] }));
  assert.deepEqual(places, [0, 1, 0, 1, 1, 0, 1, 1, -1]);
  assert.deepEqual(normals.slice(8, 11), [0, 0, -127]);
  // Between z and x.
  assert.deepEqual(normals.slice(4, 7), [89, 0, 89]);
});

test("a turning body turns all its bones, and children follow their parents", () => {
  assert.deepEqual(corners(body({ turn: QUARTER })).places, [0, 1, 0, 0, 1, -1, 0, 1, -2]);
  assert.deepEqual(corners(body({ bones: [{ place: [0, 1, 0], turn: QUARTER }, BONES[1]!.bind] })).places, [0, 1, 0, 0, 1, -1, 0, 1, -2]);
});

test("between two moments a body is interpolated, and bones without data keep their bind pose", () => {
  assert.deepEqual(corners(body({ place: [4, 0, 0] }), body({}), 0.25).places, [1, 1, 0, 2, 1, 0, 3, 1, 0]);
  assert.deepEqual(corners(body({ bones: [] })).places, [0, 1, 0, 1, 1, 0, 2, 1, 0]);
});
