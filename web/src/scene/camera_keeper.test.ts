// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Camera, Vec3 } from "../format/scene";
import { RecentGround } from "./camera_keeper";
import { CameraRig, type Shown } from "./camera_rig";
import { ALL_FREE, eyeOf, framingView, freeOf, isInside, withPlaces, withinReach, type FramedBody, type Lens } from "./framing";
import { length, minus } from "./vectors";

const PICTURE_S = 1 / 30, LENS: Lens = { slope: Math.tan(Math.PI / 8), aspect: 1.25, free: ALL_FREE };
const body = (place: Vec3, velocity: Vec3 = [0, 0, 0]): FramedBody => ({ place, velocity, radius: 0.35, height: 1.75 });
const shown = (bodies: readonly FramedBody[], more: Partial<Shown> = {}): Shown => ({ bodies, places: [], scenery: [], isBoard: false, hasWalls: false, ...more });
/** As set by YardWorld.lua: behind a fence, looking away from all agents. */
const far: Camera = { moves: 1, place: [0, 36, 58], turn: [0, 0, 0, 1], fovDeg: 45 };

function rigWith(bodies: readonly FramedBody[], order: Camera | null = far): CameraRig {
  const rig = new CameraRig();
  rig.setSize(500, 400);
  rig.begin(order, shown(bodies));
  rig.update(PICTURE_S, null);
  return rig;
}
const placeOf = (rig: CameraRig): Vec3 => [rig.camera.position.x, rig.camera.position.y, rig.camera.position.z];
const sees = (rig: CameraRig, { place }: FramedBody): boolean => {
  const at = rig.camera.position.clone().set(...place).project(rig.camera);
  return Math.abs(at.x) < 1 && Math.abs(at.y) < 1 && at.z < 1;
};

test("a frame shows all bodies, and is no wider than it has to be", () => {
  const bodies = [body([-20, 0.9, 3]), body([15, 0.9, -8]), body([0, 4, 0])], view = framingView(bodies, 0.7, 0.6, LENS);
  for (const one of bodies) assert.ok(isInside(one, one.place, view, LENS, 0.93));
  assert.ok(bodies.some((one) => !isInside(one, one.place, view, LENS, 0.7)));
});

test("bodies are framed in the area that boxes over the picture leave free", () => {
  const free = freeOf([{ left: 10, top: 10, width: 300, height: 110 }], 500, 400), lens = { ...LENS, free };
  assert.deepEqual(free, { left: 1, right: 1, top: 1 - 2 * 0.3, bottom: 1 });
  const bodies = [body([-6, 0, -6]), body([6, 0, 6]), body([-6, 0, 6]), body([6, 0, -6])], view = framingView(bodies, 0, 1, lens);
  for (const one of bodies) assert.ok(isInside(one, one.place, view, lens, 0.93));
  assert.deepEqual(freeOf([{ left: 0, top: 0, width: 500, height: 400 }], 500, 400), ALL_FREE, "what covers everything wants it so");
});

test("everybody is in the picture from the beginning, wherever a script put the camera", () => {
  const all = Array.from({ length: 20 }, (_one, i) => body([i % 5, 0.9, -30 - i]));
  for (const turn of [[0, 0, 0, 1], [0, 1, 0, 0]] as const) {
    const rig = rigWith(all, { ...far, turn });
    assert.ok(rig.keeps);
    for (const one of all) assert.ok(sees(rig, one));
  }
});

test("the camera rests while no agent is about to leave the picture", () => {
  const rig = rigWith([body([-6, 0.9, 0]), body([6, 0.9, 0])]), before = placeOf(rig);
  for (let i = 0; i < 300; ++i) {
    rig.keep(shown([body([-6 + 0.4 * Math.sin(0.1 * i), 0.9, 0]), body([6, 0.9, 0])]), PICTURE_S);
    rig.update(PICTURE_S, null);
  }
  assert.deepEqual(placeOf(rig), before);
});

test("the camera follows a runner, and comes nearer again once all are together", () => {
  const other = body([1, 0.9, 0]), rig = rigWith([body([0, 0.9, 0]), other]), awayOf = (place: Vec3): number => length(minus(placeOf(rig), place)), near = awayOf([0, 0.9, 0]);
  let x = 0;
  for (let i = 0; i < 240; ++i) {
    x += 5 * PICTURE_S;
    const runner = body([x, 0.9, 0], [5, 0, 0]);
    rig.keep(shown([runner, other]), PICTURE_S);
    rig.update(PICTURE_S, null);
    assert.ok(sees(rig, runner) && sees(rig, other), `after ${i} pictures`);
  }
  assert.ok(awayOf([x, 0.9, 0]) > 1.5 * near);
  for (let i = 0; i < 300; ++i) {
    rig.keep(shown([body([x, 0.9, 0]), body([x + 1, 0.9, 0])]), PICTURE_S);
    rig.update(PICTURE_S, null);
  }
  assert.ok(awayOf([x, 0.9, 0]) < 1.3 * near);
});

test("the user controls the camera after moving it, until asking for the automatic one", () => {
  const all = shown([body([0, 0.9, 0])]), rig = rigWith(all.bodies);
  for (const move of [() => rig.turn(5, 0), () => rig.pan(5, 0), () => rig.zoom(0.9)]) {
    rig.frameAll(all);
    assert.ok(rig.keeps);
    move();
    assert.ok(!rig.keeps);
    for (let i = 0; i < 100; ++i) rig.update(PICTURE_S, null);
    const wanted = placeOf(rig);
    for (let i = 0; i < 100; ++i) {
      rig.keep(shown([body([500, 0.9, 0])]), PICTURE_S);
      rig.update(PICTURE_S, null);
    }
    assert.ok(length(minus(placeOf(rig), wanted)) < 0.001);
  }
  rig.frameAll(all);
  rig.obey({ ...far, moves: 2 });
  assert.ok(!rig.keeps, "a script has moved it");
});

test("a board is shown completely, in the middle of the free area, from its script's direction", () => {
  const corners = [[-8, -8], [8, -8], [-8, 8], [8, 8]].map(([x, z]): FramedBody => ({ place: [x!, 0, z!], velocity: [0, 0, 0], radius: 0, height: 0 })), rig = new CameraRig();
  rig.setSize(535, 430);
  rig.free = freeOf([{ left: 16, top: 16, width: 260, height: 60 }], 535, 430);
  rig.begin({ moves: 1, place: [-4, 20, 12], turn: [-0.5, 0, 0, Math.sqrt(0.75)], fovDeg: 45 }, shown(corners, { isBoard: true }));
  rig.update(PICTURE_S, null);
  const at = corners.map(({ place }) => rig.camera.position.clone().set(...place).project(rig.camera)), xs = at.map((one) => one.x), ys = at.map((one) => one.y);
  assert.ok(Math.abs(Math.min(...xs) + Math.max(...xs)) < 0.02, "left and right are equal");
  assert.ok(Math.max(...ys) < rig.free.top && Math.min(...ys) > -1 && Math.max(...xs) < 1);
});

test("in a fast world the camera stays if all recent positions are in the picture", () => {
  const ground = new RecentGround(), rig = rigWith([body([10, 0.9, 0])]);
  let settled: Vec3 = [0, 0, 0];
  for (let i = 0; i < 300; ++i) {
    // Once round in six pictures.
    const runner = body([10 * Math.cos(i), 0.9, 10 * Math.sin(i)]);
    ground.note([runner], PICTURE_S);
    rig.keep(shown([runner, ...ground.corners()]), PICTURE_S);
    rig.update(PICTURE_S, null);
    if (i === 150) settled = placeOf(rig);
    if (i <= 150) continue;
    assert.ok(length(minus(placeOf(rig), settled)) < 0.5);
    assert.ok(sees(rig, runner));
  }
});

test("places are included while agents stay large; distant agents are left out if all would be too small", () => {
  assert.equal(withPlaces([body([0, 0.9, 0])], [[0, 0, -12], [10, 0, 0], [0, 0, 400]], 0, 0.9, LENS).length, 3);
  const crowd = Array.from({ length: 20 }, (_one, i) => body([i, 0.9, 0])), kept = withinReach([...crowd, body([9000, 0.9, 0])], 0, 0.9, LENS);
  assert.equal(kept.length, 20);
  assert.ok(length(minus(eyeOf(framingView(kept, 0, 0.9, LENS)), [10, 0.9, 0])) < 40);
});
