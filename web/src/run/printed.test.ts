// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Timeline } from "./contents";
import { Printed } from "./printed";

const of = (...marks: [number, string, string][]): Timeline => ({ timeline: [{ agent: "porter", spans: [], marks: marks.map(([tick, kind, text]) => ({ tick, kind, text })) }] });

test("printed text is reported once, and kept after the timeline has dropped it", () => {
  const printed = new Printed();
  assert.deepEqual(printed.note(of([0, "event", "soar, porter.soar"], [5, "event", "Good day, anna"], [6, "command", "move"], [7, "event", "takes crate-1"]), 10).map((one) => one.text), ["Good day, anna"]);
  assert.deepEqual(printed.note(of([5, "event", "Good day, anna"]), 11), []);
  assert.deepEqual(printed.note(of([1000, "event", "Good day, anna"], [1001, "event", "it has done nothing for 1 s"]), 1002).map((one) => one.tick), [1000]);
  assert.deepEqual(printed.lines.map((one) => [one.tick, one.text, one.isPrinted]), [[5, "Good day, anna", true], [7, "takes crate-1", false], [1000, "Good day, anna", true]]);
});

test("after continuing from the past, the printed text of the old future is gone", () => {
  const printed = new Printed();
  printed.note(of([5, "event", "a"], [90, "event", "b"]), 100);
  printed.note(of([5, "event", "a"]), 50);
  assert.deepEqual(printed.lines.map((one) => one.text), ["a"]);
  assert.deepEqual(printed.note(of([60, "event", "c"]), 61).map((one) => one.text), ["c"]);
});
