// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { Shape, type Agent, type Drawable } from "../format/scene";
import { LabelLayout } from "./label_layout";
import { SPEECH_S, speechOpacity, threadFrom } from "./labels";
import { kindColor, lookOf, teamColor } from "./looks";
import { looksLikeABody, readShape, shapeKey, ShapeLibrary, withoutSmall } from "./shape_library";
import { parseMarkup } from "./script_ui";

const box = (more: Partial<Drawable> = {}): Drawable => ({
  owner: 1, ofAgent: false, visible: true, skeletonShown: false, shape: Shape.Box, mesh: "", material: "", size: [1, 2, 3], repeats: [1, 1, 1], scale: [1, 1, 1], place: [0, 0, 0], turn: [0, 0, 0, 1], bones: [], ...more,
});

/** A triangle as sent by the run; with a skin, its vertices belong to bones 0, 1 and 2. */
function triangle(hasSkin: boolean, indices: readonly number[] = [0, 1, 2]): ArrayBuffer {
  const bytes: number[] = [], little = (value: number, count: number): void => {
    for (let i = 0; i < count; ++i) bytes.push((value >> (8 * i)) & 255);
  };
  const float = (value: number): void => {
    const view = new DataView(new ArrayBuffer(4));
    view.setFloat32(0, value, true);
    for (let i = 0; i < 4; ++i) bytes.push(view.getUint8(i));
  };
  for (const value of [3, indices.length, hasSkin ? 1 : 0]) little(value, 4);
  indices.forEach((index, i) => little(index - (indices[i - 1] ?? 0), 4));
  const scaled = (low: number, high: number, values: readonly number[]): void => {
    float(low);
    float(high);
    values.forEach((value, i) => little((value - (values[i - 1] ?? 0)) & 0xffff, 2));
  };
  scaled(-1, 1, [0, 65535, 0]);
  scaled(0, 2, [0, 0, 65535]);
  scaled(5, 5, [0, 0, 0]);
  scaled(0, 1, [0, 65535, 0]);
  scaled(0, 0, [0, 0, 0]);
  scaled(0, 10, [65535, 0, 0]);
  for (const value of [0, 0, 0, 0, 0, 0, 127, 127, 129, 255, 0, 51, 0, 0, 255]) bytes.push(value);
  if (hasSkin) bytes.push(0, 1, 2, 0, 0, 1, 255, 255, 102);
  return Uint8Array.from(bytes).buffer;
}

test("a shape is decoded as it was sent", () => {
  const mesh = readShape(triangle(true), "White");
  assert.deepEqual([...mesh.positions], [-1, 0, 5, 1, 0, 5, -1, 2, 5]);
  assert.deepEqual([...mesh.normals], [0, 0, 1, 0, 0, 1, 0, 0, -1]);
  assert.deepEqual([...mesh.uvs], [0, 0, 1, 0, 0, 0]);
  assert.deepEqual([...mesh.paint], [1, 10, 0, 0, 0, 0, Math.fround(0.2), 0, 1]);
  assert.deepEqual([...mesh.indices], [0, 1, 2]);
  assert.deepEqual([...mesh.skin!.bones], [0, 0, 0, 0, 1, 0, 0, 0, 2, 1, 0, 0]);
  assert.deepEqual([...mesh.skin!.shares].map((one) => Math.round(one * 100)), [100, 0, 0, 0, 100, 0, 0, 0, 40, 60, 0, 0]);
});

test("degenerate triangles are not drawn, nor small ones of distant shapes", () => {
  const mesh = readShape(triangle(true, [0, 1, 2, 0, 0, 2, 2, 1, 2]), "White");
  assert.deepEqual([...mesh.indices], [0, 1, 2]);
  assert.deepEqual([...withoutSmall(mesh, 2.5).indices], [0, 1, 2]);
  assert.deepEqual([...withoutSmall(mesh, 3).indices], []);
});

test("truncated data, or an index without a corner, is not a shape", () => {
  assert.throws(() => readShape(triangle(false).slice(0, 50), "White"), /cut off/);
  assert.throws(() => readShape(triangle(false, [0, 1, 7]), "White"), /no such corner/);
});

test("a shape has the same name as in the run", () => {
  // src/app/shape_contents_test.cpp expects the same key.
  assert.equal(shapeKey(box(), false), "1.0.3f800000.40000000.40400000.3f800000.3f800000.");
  assert.equal(shapeKey(box({ shape: Shape.Capsule, size: [Math.fround(0.3), 1, 0], material: "Soarbox/Sheep" }), true), "2.1.3e99999a.3f800000.0.3f800000.3f800000.Soarbox/Sheep");
  assert.equal(shapeKey(box({ material: "White" }), false), shapeKey(box(), false));
  assert.equal(shapeKey(box({ shape: Shape.Mesh, mesh: "a.mesh" }), false), "mesh/a.mesh");
});

test("a capsule of an agent is its body unless it is much smaller", () => {
  const agent = { height: 1 } as Agent, capsule = (high: number): Drawable => box({ shape: Shape.Capsule, ofAgent: true, size: [0.3, high, 0] });
  assert.equal(looksLikeABody(capsule(0.61), agent), true);
  assert.equal(looksLikeABody(capsule(0.6), agent), false);
  assert.equal(looksLikeABody(capsule(1), undefined), false);
});

test("bodies are recognized by their meshes, and drawn as soon as these arrive", async () => {
  let changes = 0;
  const library = new ShapeLibrary(() => (changes += 1)), soldier = box({ shape: Shape.Mesh, mesh: "s.mesh" });
  assert.equal(library.bodyOf(soldier), null);
  await library.add("mesh/s.mesh", { body: "body/soldier" });
  assert.equal(library.bodyOf(soldier), "body/soldier");
  assert.equal(library.bodyOf({ ...soldier, material: "SF_Soldier_Body_Dark" }), "body/dark");
  assert.equal(library.mesh("body/soldier", 0), null);
  const packed = async (bytes: ArrayBuffer): Promise<string> => Buffer.from(await new Response(new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"))).arrayBuffer()).toString("base64");
  await library.add("body/soldier", { material: "Soarbox/Soldier", fine: await packed(triangle(true)), bones: [{ parent: -1, bind: [0, 1, 0, 0, 0, 0, 1], in_model: [0, 1, 0, 0, 0, 0, 1] }] });
  assert.equal(library.mesh("body/soldier", 1)?.count, 3);
  assert.deepEqual(library.bones("body/soldier"), [{ parent: -1, bind: { place: [0, 1, 0], turn: [0, 0, 0, 1] }, inModel: { place: [0, 1, 0], turn: [0, 0, 0, 1] } }]);
  assert.equal(changes, 2);
});

test("colours follow teams and kinds; unknown materials are conspicuous", () => {
  assert.deepEqual(teamColor("blue"), [0.05, 0.36, 0.88]);
  assert.deepEqual(kindColor("soar"), [0.5, 0.3, 0.72]);
  assert.equal(lookOf("__proto__").paint, "missing");
  assert.equal(lookOf("Ground2").paint, "ground");
});

test("labels do not cover each other", () => {
  const layout = new LabelLayout(800, 600), boxes = Array.from({ length: 6 }, () => layout.place(400, 300, 90, 40)).filter((one) => one !== null);
  assert.ok(boxes.length >= 4);
  for (const [i, a] of boxes.entries())
    for (const b of boxes.slice(i + 1)) assert.ok(a.left + a.width <= b.left || b.left + b.width <= a.left || a.top + a.height <= b.top || b.top + b.height <= a.top);
});

test("scripts' markup: colours, fonts, percent signs, and what is cut off", () => {
  assert.deepEqual(parseMarkup("a%1b%%%R\n%@24%c").map((line) => line.map((run) => [run.text, run.color, run.font])), [[["a", 0, 0], ["b%", 1, 0]], [["c", 0, 4]]]);
  assert.deepEqual(parseMarkup("<b>%").map((line) => line.map((run) => run.text)), [["<b>"]]);
  assert.deepEqual(parseMarkup("x%@24"), [[{ text: "x", color: 0, font: 0, mono: false }]]);
});

test("the line from a label to its agent begins at the edge that faces the agent", () => {
  const box = { left: 100, top: 100, width: 80, height: 40 };
  assert.deepEqual(threadFrom(box, { x: 140, y: 200 }), [140, 140]);
  assert.deepEqual(threadFrom(box, { x: 140, y: 50 }), [140, 100]);
  assert.deepEqual(threadFrom(box, { x: 10, y: 120 }), [100, 120]);
  assert.deepEqual(threadFrom(box, { x: 300, y: 120 }), [180, 120]);
  assert.deepEqual(threadFrom(box, { x: 300, y: 300 }), [172, 140]);
});

test("what an agent has said fades, and is gone before it is too faint to be read", () => {
  assert.equal(speechOpacity(0), 1);
  assert.ok(Math.abs(speechOpacity(SPEECH_S - 0.3) - 0.5) < 1e-9);
  assert.equal(speechOpacity(SPEECH_S - 0.1), 0);
  assert.equal(speechOpacity(SPEECH_S + 1), 0);
});
