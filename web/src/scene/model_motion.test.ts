// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { Shape, type Drawable, type Movement } from "../format/scene";
import { JOINT_NUMBERS, moveCorners, poseJoints, readMotion, type Motion } from "./model_motion";
import type { ShapeMesh } from "./shape_library";

/** Writes numbers of four bytes, as MotionBytes of app/shape_contents.cpp does. */
class Bytes {
  private readonly parts: { value: number; isWhole: boolean }[] = [];

  wholes(...values: number[]): this {
    this.parts.push(...values.map((value) => ({ value, isWhole: true })));
    return this;
  }
  floats(...values: number[]): this {
    this.parts.push(...values.map((value) => ({ value, isWhole: false })));
    return this;
  }
  buffer(): ArrayBuffer {
    const made = new DataView(new ArrayBuffer(4 * this.parts.length));
    this.parts.forEach(({ value, isWhole }, i) => (isWhole ? made.setUint32(4 * i, value, true) : made.setFloat32(4 * i, value, true)));
    return made.buffer;
  }
}

const STILL = [0, 0, 0, 1] as const;
/** A shoulder at the origin and an elbow a metre along x. "bend" turns the elbow by 90 degrees about z within a second, "grow" doubles the shoulder at 1 s. */
function arm(): ArrayBuffer {
  return new Bytes()
    .wholes(2, 0).floats(0, 0, 0, ...STILL, 1, 1, 1).wholes(1).floats(1, 0, 0, ...STILL, 1, 1, 1)
    .wholes(3, 1).floats(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0).wholes(2).floats(1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0, 0).wholes(0).floats(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 5)
    .wholes(2)
    .floats(1).wholes(1, 1).wholes(0, 0).wholes(2, 0).floats(0, 1, ...STILL, 0, 0, Math.SQRT1_2, Math.SQRT1_2).wholes(0, 0)
    .floats(1).wholes(1, 0).wholes(0, 0).wholes(0, 0).wholes(2, 1).floats(0, 1, 1, 1, 1, 2, 2, 2)
    .buffer();
}
/** Corners at the shoulder, between the two, beyond the elbow, and one that never moves. */
const ARM: ShapeMesh = {
  number: 0, count: 4, positions: Float32Array.from([0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 0]), normals: Float32Array.from([0, 0, 1, 0, 0, 1, 0, 1, 0, 1, 0, 0]), uvs: new Float32Array(8), paint: new Float32Array(12),
  indices: Uint32Array.from([0, 1, 2]), material: "",
  skin: { bones: Uint16Array.from([0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]), shares: Float32Array.from([1, 0, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]) },
};
const model = (movements: Movement[], more: Partial<Drawable> = {}): Drawable => ({
  owner: 1, ofAgent: false, visible: true, skeletonShown: false, shape: Shape.Mesh, mesh: "", material: "", size: [0, 0, 0], repeats: [1, 1, 1], scale: [1, 1, 1], place: [0, 0, 0], turn: STILL, bones: [], movements, ...more,
});
const play = (clip: number, time: number, weight = 1): Movement => ({ clip, time, weight });

function corners(motion: Motion, now: Drawable, old?: Drawable, share = 1): { places: number[]; normals: number[] } {
  const joints = new Float32Array(JOINT_NUMBERS * motion.joints.length), places = new Float32Array(12), normals = new Int8Array(16);
  poseJoints(motion, now, old, share, joints);
  moveCorners(ARM, joints, places, normals);
  return { places: [...places].map((one) => Math.round(one * 100) / 100 + 0), normals: [...normals] };
}

test("a model has the pose of its file, and animations move its corners by weight", () => {
  const motion = readMotion(arm());
  assert.deepEqual(corners(motion, model([])).places, [0, 0, 0, 1, 0, 0, 2, 0, 0, 1, 0, 5]);
  assert.deepEqual(corners(motion, model([play(0, 1)])).places, [0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 0, 5]);
  assert.deepEqual(corners(motion, model([play(0, 1)])).normals.slice(8, 11).map((part) => Math.round(part / 127)), [-1, 0, 0]);
  assert.deepEqual(corners(motion, model([play(0, 0.5)])).places.slice(6, 9), [1.71, 0.71, 0]);
  // In steps; and the scale of a bone moves its children.
  assert.deepEqual(corners(motion, model([play(1, 0.9)])).places.slice(6, 9), [2, 0, 0]);
  assert.deepEqual(corners(motion, model([play(1, 1)])).places.slice(3, 9), [2, 0, 0, 4, 0, 0]);
});

test("animations are blended by weight, with each other or with the pose of the file", () => {
  const motion = readMotion(arm());
  assert.deepEqual(corners(motion, model([play(0, 1, 0.5)])).places.slice(6, 9), [1.71, 0.71, 0]);
  assert.deepEqual(corners(motion, model([play(0, 1, 3), play(0, 0, 3)])).places.slice(6, 9), [1.71, 0.71, 0]);
  // An animation that this page does not know has no effect.
  assert.deepEqual(corners(motion, model([play(7, 1)])).places.slice(6, 9), [2, 0, 0]);
});

test("between two moments the bones and the place are interpolated", () => {
  const motion = readMotion(arm()), old = model([play(0, 0)]), now = model([play(0, 1)], { place: [0, 4, 0] });
  assert.deepEqual(corners(motion, now, old, 0.5).places.slice(0, 9), [0, 2, 0, 1, 2, 0, 1.71, 2.71, 0]);
  assert.deepEqual(corners(motion, model([], { scale: [2, 1, 1] })).places.slice(3, 9), [2, 0, 0, 4, 0, 0]);
});

test("animations that are cut off are refused", () => {
  assert.throws(() => readMotion(arm().slice(0, 200)), /cut off/);
});
