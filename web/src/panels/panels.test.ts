// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Check, Mission } from "../run/contents";
import { sizeText } from "../lesson/start_page";
import { protagonist } from "../app/protagonist";
import { clock, passes } from "./parts";
import { lineOf, namesOf, placeTracks, type BarName } from "./timeline";

const check = (name: string, state: string, isMarker = false): Check => ({ name, expected: "", was: "", agent: "porter", is_marker: isMarker, state, tick: 30, time_s: 1 });

test("the agent with the most checks is the protagonist", () => {
  const of = (...expected: string[]): Mission => ({ checks: expected.map((one) => ({ ...check(one, "open"), agent: "", expected: one })), lesson: null, lessons: [] });
  assert.equal(protagonist(of("hare should give evade by 20 s", "hare should never be at most 1 m from bear"), ["bear", "hare"]), "hare");
  assert.equal(protagonist(of("leader should walk", "follower-* should give follow", "follower-* should see leader"), ["leader", "follower-1", "follower-2"]), "follower-1");
  assert.equal(protagonist(of("hider should select operator hide", "searcher should see hider"), ["searcher", "hider"]), "hider", "of equals the first");
  assert.equal(protagonist(of("the run should reach 'blue wins'"), ["a", "b"]), "a");
  assert.equal(protagonist(of(), []), "");
});

test("spans lie on the lines of their level", () => {
  assert.deepEqual([lineOf({ kind: "operator", level: 1 }), lineOf({ kind: "state", level: 2 }), lineOf({ kind: "operator", level: 2 })], [0, 1, 2]);
  const placed = placeTracks([{ agent: "a", marks: [], spans: [{ kind: "state", level: 3, id: "S9", text: "tie", first_tick: 1, last_tick: 2, open: false }] }, { agent: "b", marks: [], spans: [] }], 1200, 500);
  assert.equal(placed.first, 300);
  assert.equal(placed.rows[0]!.lines, 5);
  assert.ok(placed.rows[1]!.top > placed.rows[0]!.top + 5 * 16);
});

test("times, filters and sizes", () => {
  assert.deepEqual([clock(0), clock(61.239), clock(3599.999), clock(-1)], ["0:00.00", "1:01.24", "60:00.00", "0:00.00"]);
  assert.ok(passes("AN be", "anna, bert") && !passes("cy", "anna") && passes("", "x"));
  assert.deepEqual([sizeText(999), sizeText(5400), sizeText(2_340_000)], ["999 bytes", "5 kB", "2.3 MB"]);
});

test("narrow bars of one operator share a name; wide ones have their own", () => {
  const bar = (text: string, left: number, right: number, level = 1): BarName => ({ text, kind: "operator", level, left, right });
  const names = (...bars: BarName[]): string[] => namesOf(bars).map((one) => `${one.text} ${one.left}-${one.right}`);
  assert.deepEqual(names(bar("follow", 0, 10), bar("follow", 10, 20), bar("follow", 21, 40)), ["follow 0-40"]);
  assert.deepEqual(names(bar("follow", 0, 20), bar("flee", 20, 25), bar("follow", 25, 40)), []);
  assert.deepEqual(names(bar("follow", 0, 20), bar("follow", 30, 60)), ["follow 30-60"]);
  assert.deepEqual(names(bar("step", 0, 30), bar("step", 30, 60)), ["step 0-30", "step 30-60"]);
  // Levels of the stack are separate lines.
  assert.deepEqual(names(bar("go", 0, 15), bar("in", 0, 15, 2), bar("go", 15, 30), bar("in", 15, 30, 2)), ["go 0-30", "in 0-30"]);
});
