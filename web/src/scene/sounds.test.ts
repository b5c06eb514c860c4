// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { heardAt } from "./sounds";

test("a sound without a place is equally loud on both sides", () => {
  assert.deepEqual(heardAt(0.5, null, [9, 9, 9], [1, 0, 0]), { left: 0.5, right: 0.5 });
});

test("a sound is softer from afar and comes from its side", () => {
  const near = heardAt(1, [0, 0, -5], [0, 0, 0], [1, 0, 0]), far = heardAt(1, [0, 0, -10], [0, 0, 0], [1, 0, 0]), right = heardAt(1, [4, 0, 0], [0, 0, 0], [1, 0, 0]);
  assert.deepEqual(near, { left: 1, right: 1 });
  assert.deepEqual(far, { left: 0.5, right: 0.5 });
  assert.deepEqual(right, { left: 0, right: 1 });
  assert.deepEqual(heardAt(1, [1, 1, 1], [1, 1, 1], [1, 0, 0]), { left: 1, right: 1 });
});
