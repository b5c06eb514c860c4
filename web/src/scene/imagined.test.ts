// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { paintImagined } from "./imagined";
import type { LineBatch } from "./line_batch";

/** Counts the drawn lines and bodies. */
function paper(): { out: LineBatch; lines: unknown[][]; fills: unknown[][] } {
  const lines: unknown[][] = [], fills: unknown[][] = [];
  return { lines, fills, out: { line: (...all: unknown[]) => lines.push(all), fill: (...all: unknown[]) => fills.push(all) } as unknown as LineBatch };
}

test("shapes are drawn as wire and surface, with a name over nodes that the world does not update", () => {
  const { out, lines, fills } = paper(), box = { state: "S1", points: [0, 0, 0, 2, 0, 0, 0, 3, 0], edges: [0, 1, 1, 2], faces: [0, 1, 2] };
  const shown = paintImagined(out, { ghosts: [], shapes: [{ ...box, name: "lair", kind: "made-up" }, { ...box, name: "wall", kind: "sensed" }], answer: { text: "", lines: [] } });
  assert.equal(lines.length, 4);
  assert.equal(fills.length, 2);
  assert.deepEqual(shown.map((one) => one.name), ["lair · S1"]);
  assert.deepEqual(shown[0]!.place, [1, 1.5, 0]);
});

test("an answer is a line with its value in the middle, and red where something crosses it", () => {
  const { out, lines } = paper();
  const shown = paintImagined(out, { ghosts: [], shapes: [], answer: { text: "1.4", lines: [{ from: [0, 1, 0], to: [4, 1, 0], is_crossed: false }, { from: [0, 1, 0], to: [4, 2, 0], is_crossed: true }] } });
  assert.equal(lines.length, 2 * 7);
  assert.notDeepEqual(lines[0]![2], lines[7]![2]);
  assert.deepEqual(shown.map((one) => [one.name, ...one.place]), [["1.4", 2, 1, 0]]);
});

test("figures of another future keep the colour of their team", () => {
  const shown = paintImagined(paper().out, { ghosts: [{ name: "scout before", agent_id: 3, kind: "soldier", team: "red", position: [1, 1, 1], forward: [0, 0, 1], radius_m: 0.4, height_m: 1.8 }], shapes: [], answer: { text: "", lines: [] } });
  assert.equal(shown[0]!.name, "scout before");
  assert.ok(shown[0]!.color[0] > shown[0]!.color[2]);
});
