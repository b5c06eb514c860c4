// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { NO_DRAWABLES } from "../format/drawables";
import type { Scene } from "../format/scene";
import { Playout } from "./playout";

function at(time: number): Scene {
  return {
    tick: Math.round(time * 30), time, surroundings: null, camera: null, drawables: NO_DRAWABLES, agents: new Map(), lines: { lines: [], circles: [], triangles: [] },
    overlayLines: { lines: [], circles: [], triangles: [] }, minds: new Map(), shots: [], speech: [], places: [], components: [], particles: [],
  };
}

test("moments that arrive at regular intervals are played smoothly", () => {
  const playout = new Playout();
  let last = -1, steps = 0;
  for (let frame = 0; frame < 180; ++frame) {
    const now = frame / 60;
    if (frame % 4 === 0) playout.add(at(now), now);
    const between = playout.advance(1 / 60, false)!;
    assert.ok(between.share >= 0 && between.share <= 1);
    assert.ok(playout.time >= last, "time goes back");
    if (frame > 60 && playout.time - last > 0.004) steps += 1;
    last = playout.time;
  }
  assert.ok(steps > 110, `${steps} of 119 pictures moved`);
  assert.ok(last > 2.8 && last < 3);
});

test("paused, the newest moment is shown", () => {
  const playout = new Playout();
  playout.add(at(1), 0);
  playout.add(at(1.1), 0.1);
  for (let frame = 0; frame < 200; ++frame) playout.advance(1 / 60, true);
  assert.equal(playout.time, 1.1);
  assert.equal(playout.advance(1 / 60, true)!.share, 1);
});

test("after a jump back or far ahead, it restarts there", () => {
  const playout = new Playout();
  playout.add(at(10), 0);
  playout.add(at(10.1), 0.1);
  playout.add(at(4), 0.2);
  assert.equal(playout.advance(0.01, false)!.after.time, 4);
  playout.add(at(60), 0.3);
  assert.equal(playout.advance(0.01, false)!.after.time, 60);
});

test("there is nothing to show before the first moment", () => {
  assert.equal(new Playout().advance(0.1, false), null);
});
