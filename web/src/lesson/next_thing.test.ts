// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { nextLesson, nextThings } from "./next_thing";

const info = (passed: number) => ({ lessons: ["01-a-rule", "02-operators", "03-choices"].map((name, i) => ({ name, title: name.slice(3), is_passed: i < passed })) });
const labels = (...of: Parameters<typeof nextThings>): string[] => nextThings(...of).map((one) => one.label);

test("the main button is the next thing to do", () => {
  assert.deepEqual(labels(info(0), null, ""), ["Begin with lesson 1"]);
  assert.deepEqual(labels(info(1), null, ""), ["Lesson 2: operators"]);
  assert.deepEqual(labels(info(1), { what: "lesson:01-a-rule", title: "A rule" }, ""), ["Lesson 2: operators", "Go on with A rule"], "what is passed is not what comes next");
  assert.deepEqual(labels(info(1), { what: "lesson:02-operators", title: "Operators" }, ""), ["Go on with Operators"]);
  assert.deepEqual(labels(info(0), null, "lesson:02-operators"), ["Go on with operators"], "after a restart of the server one is where one was");
  assert.deepEqual(labels(info(0), { what: "scenario:eaters", title: "eaters" }, ""), ["Go on with eaters", "Begin with lesson 1"]);
  assert.deepEqual(labels(info(3), null, ""), []);
});

test("the next lesson follows the last one; otherwise it is the first that is not passed", () => {
  assert.equal(nextLesson(info(1), "01-a-rule"), "02-operators");
  assert.equal(nextLesson(info(1), "03-choices"), "02-operators");
  assert.equal(nextLesson(info(3)), "");
});
