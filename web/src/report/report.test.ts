// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { h, textOf } from "../dom/view";
import { cut, digits, labelOf, paints, ticks } from "./chart";
import { indexAt, positionAt, wayOf, type AgentReport, type EventReport } from "./data";
import { extentOf, placeNames } from "./map";
import { marksOf } from "./run_charts";
import { arranged, numberColumns } from "./table";
import { OwnTime } from "./time";

const AGENT: AgentReport = { name: "anna", team: "", distance: 0, health: 0, alive: true, rounds: 0, damage: 0, rules: [] };

test("series are sums of differences, in metres, points and metres per second", () => {
  const way = wayOf({ ...AGENT, from: 1, x: [100, 50, -25], z: [0, 0, 300], hp: [100, 0, -100], v: [15, 0, -15] });
  assert.deepEqual(way, { from: 1, x: [1, 1.5, 1.25], z: [0, 0, 3], health: [100, 100, 0], speed: [1.5, 1.5, 0] });
  assert.equal(wayOf(AGENT), null, "who has no body goes nowhere");
});

test("a position between two moments is interpolated; before the first and after the last it is clamped", () => {
  const times = [0, 1, 2, 3], way = wayOf({ ...AGENT, from: 1, x: [0, 200, 200], z: [0, 0, 0], hp: [100, 0, -100], v: [0, 0, 0] })!;
  assert.deepEqual(positionAt(way, times, 1.25), { x: 0.5, z: 0, isAlive: true });
  assert.deepEqual(positionAt(way, times, 0), { x: 0, z: 0, isAlive: true });
  assert.deepEqual(positionAt(way, times, 9), { x: 4, z: 0, isAlive: false });
  assert.deepEqual([indexAt(times, -1), indexAt(times, 1), indexAt(times, 1.9), indexAt(times, 99)], [0, 1, 1, 3]);
});

test("ticks are round numbers within the range, with different labels", () => {
  assert.deepEqual(ticks(0, 10, 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks(0.11, 0.13, 4), [0.11, 0.115, 0.12, 0.125, 0.13]);
  assert.deepEqual(ticks(-3, 3, 3), [-2, 0, 2]);
  assert.ok(ticks(7, 7, 5).length > 0, "a range without a width has a tick");
  const list = ticks(1_000_000, 1_000_001, 4);
  assert.equal(new Set(list.map((one) => labelOf(one, list))).size, list.length);
});

test("numbers have four digits, names are cut with dots", () => {
  assert.deepEqual([digits(1 / 3), digits(12345.6), digits(-2), digits(Number.NaN)], ["0.3333", "12350", "-2", ""]);
  assert.deepEqual([cut("short", 5), cut("longer", 5), cut("𝒜𝒷𝒸𝒹", 3)], ["short", "long…", "𝒜𝒷…"]);
});

test("a team has the colour in its name; its agents have different dashes", () => {
  const painted = paints([{ team: "red" }, { team: "blue" }, { team: "red" }, { team: "other" }]);
  assert.deepEqual(painted.map((one) => one.color), ["var(--c1)", "var(--c0)", "var(--c1)", "var(--c2)"]);
  assert.notEqual(painted[0]!.dash, painted[2]!.dash);
  const alone = paints(Array.from({ length: 12 }, () => ({ team: "" })));
  assert.equal(new Set(alone.map((one) => one.color + one.dash)).size, 12, "without teams everybody looks different");
});

test("names next to dots cover no other dot and no other name", () => {
  const dots = [{ x: 100, y: 100, name: "red-1" }, { x: 120, y: 100, name: "red-2" }, { x: 100, y: 118, name: "red-3" }], places = placeNames(dots, 400);
  const boxes = dots.map((dot, i) => {
    const { dx, dy, anchor } = places[i]!, left = dot.x + dx - (anchor === "end" ? 36 : 0);
    return { left, right: left + 36, top: dot.y + dy - 11, bottom: dot.y + dy + 3 };
  });
  boxes.forEach((one, i) => {
    dots.forEach((dot, k) => assert.ok(k === i || dot.x + 7 < one.left || dot.x - 7 > one.right || dot.y + 7 < one.top || dot.y - 7 > one.bottom, `${i} covers the dot ${k}`));
    boxes.forEach((two, k) => assert.ok(k === i || one.right < two.left || one.left > two.right || one.bottom < two.top || one.top > two.bottom, `${i} covers the name ${k}`));
  });
});

test("a name at the edge of a map stays inside", () => {
  assert.deepEqual(placeNames([{ x: 390, y: 200, name: "red-leader" }], 400)[0], { dx: -9, dy: 4, anchor: "end" });
  const crowded = placeNames(Array.from({ length: 30 }, (_, i) => ({ x: 395, y: 200, name: `agent-${i}` })), 400);
  assert.ok(crowded.every((one) => one.anchor === "end"), "even where there is no free place");
});

test("a map contains all paths and places; without any there is no map", () => {
  const way = wayOf({ ...AGENT, x: [0, 10000], z: [-500, 0], hp: [1, 0], v: [0, 0] }), extent = extentOf([way, null], [{ name: "mill", x: -20, z: 7, r: 1, hx: 0, hz: 0 }])!;
  assert.ok(extent.x < -20 && extent.z < -5 && extent.x + extent.side > 100 && extent.z + extent.side > 7);
  assert.equal(Math.round(extent.side), 137, "with room for names at its edges");
  assert.equal(extentOf([null], []), null);
});

test("only one of several equal triangles at a place is drawn, and none for very frequent events", () => {
  const event = (t: number, a: string, k: string): EventReport => ({ t, a, k, text: "" });
  const drawn = marksOf([event(1, "anna", "impasse"), event(1.01, "anna", "impasse"), event(1, "bert", "impasse"), event(2, "anna", "print"), event(2, "anna", "command"), event(2, "nobody", "news"), event(2, "anna", "news")], new Map([["anna", 0], ["bert", 1]]), (seconds) => 10 * seconds);
  assert.deepEqual(drawn.map((one) => `${one.t} ${one.a} ${one.k}`), ["1 anna impasse", "1 bert impasse", "2 anna news"]);
});

test("rows sort as numbers or as people sort texts, keep their order where they are equal, and are filtered by all words", () => {
  const rows = [["b10", 2, h("code", null, "x")], ["b9", 10, "y"], ["a", 2, "z"]] as const, first = (all: readonly (readonly unknown[])[]): unknown[] => all.map((row) => row[0]);
  assert.deepEqual(first(arranged(rows, 0, true, "")), ["a", "b9", "b10"]);
  assert.deepEqual(first(arranged(rows, 1, true, "")), ["b10", "a", "b9"]);
  assert.deepEqual(first(arranged(rows, 1, false, "")), ["b9", "b10", "a"]);
  assert.deepEqual(first(arranged(rows, -1, true, "B x")), ["b10"], "what a view says counts");
  assert.deepEqual(numberColumns(3, rows), [false, true, false]);
  assert.deepEqual(numberColumns(1, [[""], [""]]), [false]);
  assert.equal(textOf(h("td", null, h("b", null, "a"), 5)), "a5");
});

test("control characters for the direction of text are shown, and have no effect", () => {
  assert.equal(textOf(h("b", null, "anna\u202egnp.exe\u2066", h("i", null, "\u202d"))), "anna\ufffdgnp.exe\ufffd\ufffd");
  assert.equal(textOf(h("b", null, "שלום anna")), "שלום anna", "letters have their own direction");
});

test("time stops at its ends and notifies its followers", () => {
  const time = new OwnTime(4), told: number[] = [];
  time.on(() => told.push(time.now));
  time.go(9);
  time.go(-1);
  time.go(2.5);
  assert.deepEqual(told, [4, 0, 2.5]);
  time.play(true);
  assert.ok(time.isPlaying);
  time.play(false);
  assert.ok(!time.isPlaying);
});
