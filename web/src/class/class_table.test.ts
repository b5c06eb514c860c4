// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { standing } from "./class_table";

const learner = { name: "Ada", place_link: "/p/x/", watch_link: "/p/x/", is_here: true, done: { a: { is_done: true, tries: 3, hints: 1 }, b: { is_done: false, tries: 2, hints: 0 }, c: { is_done: false, tries: 0, hints: 0 }, d: { is_done: false, passed: 2, of: 3, tries: 1 } } };

test("a learner's standing is a sign and a sentence", () => {
  assert.deepEqual(standing(learner, "a"), { text: "✓", says: "passed, 3 tries, 1 hint", kind: "done" });
  assert.deepEqual(standing(learner, "b"), { text: "2×", says: "not passed, 2 tries, 0 hints", kind: "begun" });
  assert.equal(standing(learner, "c").kind, "none");
  assert.equal(standing(learner, "d").text, "2/3");
  assert.equal(standing(learner, "nobody").kind, "none");
});
