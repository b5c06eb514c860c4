// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { changesOf, edited, pathOf } from "./text_edits";

const edit = (line: number, from: number, to: number, newText: string) => ({ range: { start: { line, character: from }, end: { line, character: to } }, newText });

test("several changes use positions of the text before all changes", () => {
  assert.equal(edited("sp {a\n<s> <s>\n}", [edit(1, 4, 7, "<state>"), edit(1, 0, 3, "<state>")]), "sp {a\n<state> <state>\n}");
  assert.equal(edited("a\nb", [{ range: { start: { line: 0, character: 0 }, end: { line: 9, character: 0 } }, newText: "c\n" }]), "c\n");
  assert.deepEqual(changesOf("ab\ncd", [edit(0, 1, 99, "x")]), [{ from: 1, to: 2, insert: "x" }]);
});

test("a file's address is a path", () => {
  assert.equal(pathOf("file:///place/home/a%20b.soar"), "/place/home/a b.soar");
});
