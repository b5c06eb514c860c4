// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Problem } from "../run/contents";
import { meantBy, placeOf, remedyOf } from "./problem_place";

const TEXT = "sp {a\n   (state <s> ^io.input-link.agnet <a>)\n   (<a> ^rnage <r>)\n-->\n   (<s> ^x <t>)\n}\n";
const problem = (line: number, column: number, more: Partial<Problem> = {}): Problem => ({ severity: "error", message: "m", line, column, ...more });
const marked = (one: Problem, text = TEXT): string => {
  const { from, to } = placeOf(one, text);
  return text.slice(from, to);
};

test("a hint contains the suggested word", () => {
  assert.equal(meantBy("did you mean ^range?"), "range");
  assert.equal(meantBy("no such rule: did you mean 'porter*greet'?"), "porter*greet");
  assert.equal(meantBy("did you mean <s>?"), "<s>");
  assert.equal(meantBy("did you mean one, or two?"), "");
  assert.equal(meantBy("it is one of a, b"), "");
});

test("a problem is marked at its word, or as far as its excerpt underlines", () => {
  assert.equal(marked(problem(3, 9)), "^rnage");
  assert.equal(marked(problem(5, 12, { excerpt: "   (<s> ^x <t>)\n           ^~~" })), "<t>");
  assert.equal(marked({ severity: "error", message: "m", line: 5 }), "(<s> ^x <t>)");
});

test("columns are bytes", () => {
  const text = "# äöü\n(<s> ^nämE |x|)";
  assert.equal(marked(problem(2, 13), text), "|x|");
});

test("positions beyond the text are clamped", () => {
  assert.equal(marked(problem(99, 99)), "");
  assert.equal(marked(problem(1, 99)), "");
});

test("a fix changes only the wrong part", () => {
  const fixed = (one: Problem): string => {
    const remedy = remedyOf(one, TEXT);
    return remedy === null ? "none" : `${TEXT.slice(0, remedy.from)}[${remedy.insert}]${TEXT.slice(remedy.to)}`.split("\n")[one.line! - 1]!;
  };
  assert.equal(fixed(problem(3, 9, { hint: "did you mean ^range?" })), "   (<a> ^[range] <r>)");
  assert.equal(fixed(problem(2, 15, { hint: "did you mean ^agent?" })), "   (state <s> ^io.input-link.[agent] <a>)");
  assert.equal(fixed(problem(5, 12, { hint: "did you mean <a>?" })), "   (<s> ^x [<a>])");
  assert.equal(fixed(problem(5, 12, { hint: "bind it first" })), "none");
});
