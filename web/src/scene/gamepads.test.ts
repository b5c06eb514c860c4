// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { axisValue, Gamepads } from "./gamepads";
import type { WorldEvent } from "./world_input";

function pad(pressed: readonly number[], axes: readonly number[]): { index: number; connected: boolean; buttons: { pressed: boolean; value: number }[]; axes: readonly number[] } {
  return { index: 0, connected: true, buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: pressed.includes(i), value: pressed.includes(i) ? 1 : 0 })), axes };
}

test("only changes at a gamepad are reported", () => {
  const told: WorldEvent[] = [], pads = new Gamepads((event) => told.push(event));
  pads.look([null, pad([], [0, 0.05, 0, 0])]);
  assert.deepEqual(told, []);
  pads.look([pad([0], [0, -0.5012, 0, 0])]);
  pads.look([pad([0], [0, -0.5014, 0, 0])]);
  assert.deepEqual(told, [{ kind: "pad", pad: 1, name: "a_button", value: 1 }, { kind: "pad", pad: 1, name: "left_y", value: -0.5 }]);
});

test("a disconnected gamepad releases all buttons", () => {
  const told: WorldEvent[] = [], pads = new Gamepads((event) => told.push(event));
  pads.look([pad([9, 7], [1, 0, 0, 0])]);
  told.length = 0;
  pads.look([]);
  assert.deepEqual(told.map((one) => `${String(one["name"])} ${String(one["value"])}`).sort(), ["left_x 0", "right_trigger 0", "start_button 0"]);
});

test("axes rest at 0 and have two digits", () => {
  assert.deepEqual([0.1, -0.11, 0.567, -2, NaN].map(axisValue), [0, 0, 0.57, -1, 0]);
});
