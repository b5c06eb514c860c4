// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { EditorState } from "@codemirror/state";
import { lineStops, showing, stopLines } from "./line_stops";

const begin = (): EditorState => EditorState.create({ doc: "one\ntwo\nthree\nfour", extensions: lineStops(() => {}) });

test("stops are shown in the order of lines, and only those inside the text", () => {
  const state = begin().update({ effects: showing({ can: true, lines: [3, 2, 3, 40, 0], stoppedLine: 4 }) }).state;
  assert.deepEqual(stopLines(state), [2, 3]);
});

test("a stop moves with its line while the text changes", () => {
  const state = begin().update({ effects: showing({ can: true, lines: [2, 3], stoppedLine: 3 }) }).state;
  assert.deepEqual(stopLines(state.update({ changes: { from: 0, insert: "zero\n" } }).state), [3, 4]);
  assert.deepEqual(stopLines(state.update({ changes: { from: 0, to: 4 } }).state), [1, 2]);
});

test("rules have no stops", () => {
  const state = begin().update({ effects: showing({ can: false, lines: [2], stoppedLine: 2 }) }).state;
  assert.deepEqual(stopLines(state), []);
});
