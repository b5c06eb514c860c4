// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { wordAt } from "./soar_words";

const told = (line: string, word: string, offset = 1): string => wordAt(line, line.indexOf(word) + offset)?.about ?? "";

test("state, write, --> and ^superstate are explained to a beginner", () => {
  const line = "   (state <s> ^superstate nil ^io.input-link <in>)";
  assert.match(told(line, "state"), /^\*\*state\*\* says that the first condition/);
  assert.match(told(line, "^superstate"), /top state/);
  assert.match(told(line, "superstate", 4), /top state/);
  assert.match(told(line, "^io"), /leads out of the mind/);
  assert.match(told(line, "input-link"), /perceives now/);
  assert.match(told("-->", "-->"), /between conditions and actions/);
  assert.match(told("   (write |Good day, | <name>)", "write"), /panel Output/);
  assert.match(told("   (<s> ^operator <o> + =)", "+", 0), /proposes/);
  assert.match(told("sp {porter*greet", "sp", 0), /soar production/);
});

test("names, variables, comments and texts are not explained words", () => {
  for (const [line, word] of [["sp {state*write", "state*write"], ["   (<state> ^color red)", "<state>"], ["# write a state", "write"], ["   (write |the state|)", "the state"]] as const) assert.equal(told(line, word, 2), "", line);
});
