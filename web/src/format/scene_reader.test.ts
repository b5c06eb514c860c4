// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { deflateSync } from "node:zlib";
import { BadBytes } from "./byte_reader";
import { SceneReader, isFull, unpack } from "./scene_reader";

/** The bytes that tests/stream/scene_stream_test.cpp expects from the engine. */
const blocks = readFileSync("../tests/stream/scene_blocks.hex", "utf8").trim().split("\n").map((line) => Uint8Array.from(Buffer.from(line, "hex")));
const [full, difference] = [blocks[0]!, blocks[1]!];

const near = (a: readonly number[], b: readonly number[]): void => {
  assert.equal(a.length, b.length);
  a.forEach((value, i) => assert.ok(Math.abs(value - b[i]!) < 0.003, `${a.join()} is not ${b.join()}`));
};

test("a full block contains the complete moment", async () => {
  const scene = new SceneReader().read(await unpack(full), isFull(full))!;
  assert.equal(scene.tick, 300);
  assert.equal(scene.time, 10);
  assert.equal(scene.surroundings!.sky, "Evening");
  const box = scene.drawables.get(4)!;
  assert.equal(box.material, "Soarbox/Crate");
  assert.deepEqual(box.size, [1, 2, 3]);
  assert.deepEqual(box.place, [1.5, -2.25, 1000]);
  const body = scene.drawables.get(9)!;
  near(body.turn, [0, Math.SQRT1_2, 0, Math.SQRT1_2]);
  near(body.bones[1]!.place, [0.5, 1, 0]);
  near(body.bones[1]!.turn, [1, 0, 0, 0]);
  const agent = scene.agents.get(2)!;
  assert.equal(agent.name, "<b>zoë</b>");
  assert.equal(agent.health, 62.5);
  assert.deepEqual(agent.place, [-3, 0, 0.001]);
  assert.deepEqual(scene.lines.lines[0]!.to, [1, 0, -1]);
  assert.equal(scene.minds.get(2)!.operator, "wander");
  assert.deepEqual(scene.minds.get(2)!.path, [[1, 0, 1], [2, 0, 1]]);
  assert.deepEqual(scene.speech, [{ from: 2, to: 0, text: "hello", time: 9.5 }]);
  const [button, plain] = scene.components;
  assert.deepEqual([button!.text, button!.button, button!.material, button!.bar], ["Go", "go", "badge.png#0123456789abcdef", { share: 0.25, color: [1, 0, 0, 1] }]);
  assert.deepEqual([plain!.text, plain!.button, plain!.bar], ["plain", "", null]);
  assert.deepEqual(scene.sounds, [{ id: 7, file: "bell.wav#0123456789abcdef", volume: 0.5, place: [1, 2, 3] }]);
  assert.deepEqual(scene.places, [{ kind: "item", name: "medkit", place: [1, 0.5, 2] }]);
});

test("a difference changes the named values and leaves the previous moment unchanged", async () => {
  const reader = new SceneReader();
  const first = reader.read(await unpack(full), true)!;
  const second = reader.read(await unpack(difference), isFull(difference))!;
  assert.equal(isFull(difference), false);
  assert.equal(second.tick, 301);
  assert.equal(second.drawables.size, 1);
  assert.equal(second.drawables.get(4), undefined);
  near(second.drawables.get(9)!.place, [0.25, 0, 0]);
  near(second.drawables.get(9)!.bones[0]!.place, [0, 1, 0]);
  assert.equal(second.agents.get(2)!.alive, false);
  assert.equal(second.agents.get(2)!.name, "<b>zoë</b>");
  assert.equal(second.lines.lines.length, 0);
  assert.equal(second.speech.length, 0);
  assert.equal(second.sounds.length, 0);
  assert.equal(second.minds.get(2)!.operator, "wander");
  assert.equal(first.drawables.get(4)!.material, "Soarbox/Crate");
  assert.deepEqual(first.drawables.get(9)!.place, [0, 0, 0]);
  assert.equal(first.agents.get(2)!.alive, true);
});

test("a difference before the first full block is skipped", async () => {
  assert.equal(new SceneReader().read(await unpack(difference), false), null);
});

test("a compressed block has the same contents", async () => {
  const packed = Uint8Array.from([full[0]!, full[1]!, full[2]! | 2, ...deflateSync(full.slice(3))]);
  assert.deepEqual(await unpack(packed), await unpack(full));
});

test("a block that is cut anywhere is refused, and the next full one is read", async () => {
  const payload = await unpack(full);
  const reader = new SceneReader();
  for (let size = 0; size < payload.length; ++size) assert.throws(() => reader.read(payload.slice(0, size), true), BadBytes);
  assert.equal(reader.read(payload, true)!.tick, 300);
});

test("data that is not a block, or has another version, is refused", async () => {
  await assert.rejects(unpack(Uint8Array.from([1, 2, 3, 4])), BadBytes);
  await assert.rejects(unpack(Uint8Array.from([0x53, 99, 1, 0])), /load the page again/);
});

/** A block of a drawable with the given parts, as the engine writes it. */
function blockOf(time: number, parts: number, data: readonly number[]): Uint8Array {
  const moment = Buffer.alloc(8);
  moment.writeDoubleLE(time);
  const section = [0, 5, parts, ...data];
  return Uint8Array.from([1, ...moment, 0, 3, section.length, ...section, 0]);
}
const float = (value: number): number[] => {
  const bytes = Buffer.alloc(4);
  bytes.writeFloatLE(value);
  return [...bytes];
};

test("the animations of a model continue until a block changes them", () => {
  const reader = new SceneReader(), description = [1, 0, 0, 0, 0, ...Array<number[]>(9).fill(float(1)).flat()];
  const first = reader.read(blockOf(10, 1 | 16, [description.length, ...description, 1, 3, ...float(0.25), ...float(0.5), ...float(2), ...float(1)]), true)!;
  assert.deepEqual(first.drawables.get(5)!.movements, [{ clip: 3, time: 0.25, weight: 0.5 }]);
  const empty = Buffer.alloc(8);
  empty.writeDoubleLE(10.25);
  const second = reader.read(Uint8Array.from([2, ...empty, 0, 0]), false)!;
  assert.deepEqual(second.drawables.get(5)!.movements, [{ clip: 3, time: 0.75, weight: 0.75 }]);
  assert.deepEqual(first.drawables.get(5)!.movements, [{ clip: 3, time: 0.25, weight: 0.5 }]);
  const third = reader.read(blockOf(11, 16, [0]), false)!;
  assert.equal(third.drawables.get(5)!.movements, undefined);
});
