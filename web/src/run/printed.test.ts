// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Timeline } from "./contents";
import { Printed } from "./printed";

const of = (...marks: [number, string, string][]): Timeline => ({ timeline: [{ agent: "porter", spans: [], marks: marks.map(([tick, kind, text]) => ({ tick, kind, text })) }] });

test("what an agent prints is told once, and kept when the timeline forgets it", () => {
  const printed = new Printed();
  assert.deepEqual(printed.note(of([0, "event", "soar, porter.soar"], [5, "event", "Good day, anna"], [6, "command", "move"], [7, "event", "takes crate-1"]), 10).map((one) => one.text), ["Good day, anna"]);
  assert.deepEqual(printed.note(of([5, "event", "Good day, anna"]), 11), []);
  assert.deepEqual(printed.note(of([1000, "event", "Good day, anna"], [1001, "event", "it has done nothing for 1 s"]), 1002).map((one) => one.tick), [1000]);
  assert.deepEqual(printed.lines.map((one) => [one.tick, one.text, one.isPrinted]), [[5, "Good day, anna", true], [7, "takes crate-1", false], [1000, "Good day, anna", true]]);
});

test("after going on from the past, what the old future printed is gone", () => {
  const printed = new Printed();
  printed.note(of([5, "event", "a"], [90, "event", "b"]), 100);
  printed.note(of([5, "event", "a"]), 50);
  assert.deepEqual(printed.lines.map((one) => one.text), ["a"]);
  assert.deepEqual(printed.note(of([60, "event", "c"]), 61).map((one) => one.text), ["c"]);
});
