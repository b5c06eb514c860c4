// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { WantedTick } from "./flow_bar";

test("a slider that is moved faster than answers arrive keeps its last position", () => {
  const wanted = new WantedTick();
  for (const tick of [99, 98, 97]) wanted.ask(tick, () => assert.fail("the answers came in time"));
  wanted.shown(99);
  wanted.shown(undefined);
  assert.equal(wanted.tick, 97);
  wanted.shown(97);
  assert.equal(wanted.tick, null);
});

const NEEDS_TIMERS = { skip: process.versions.node.startsWith("18.") && "Node.js 18 mocks timers in another way" };
test("a slider without an answer returns to the actual position", NEEDS_TIMERS, async (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const wanted = new WantedTick();
  let told = 0;
  wanted.ask(5, () => (told += 1));
  context.mock.timers.tick(4_999);
  assert.equal(wanted.tick, 5);
  context.mock.timers.tick(1);
  assert.deepEqual([wanted.tick, told], [null, 1]);
});
