// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { FIRST_OF_PROCESSOR, Governor, QUALITIES } from "./governor";

const draw = (governor: Governor, pictures: number, seconds: number): number => {
  let changes = 0;
  for (let i = 0; i < pictures; ++i) changes += governor.note(seconds) ? 1 : 0;
  return changes;
};

test("slow pictures reduce the detail step by step, down to the cheapest", () => {
  const governor = new Governor(FIRST_OF_PROCESSOR);
  assert.equal(draw(governor, 19, 0.1), 0);
  assert.equal(draw(governor, 1, 0.1), 1);
  assert.ok(governor.quality.ratio < QUALITIES[FIRST_OF_PROCESSOR]!.ratio);
  draw(governor, 400, 0.1);
  assert.equal(governor.quality, QUALITIES.at(-1));
});

test("a graphics card that is too slow for the world is soon treated like a processor", () => {
  const governor = new Governor();
  assert.equal(draw(governor, 4, 0.2), 1);
  assert.equal(governor.quality, QUALITIES[FIRST_OF_PROCESSOR]);
});

test("with time to spare the detail grows again, but a processor never gets a card's detail", () => {
  const governor = new Governor(FIRST_OF_PROCESSOR);
  draw(governor, 60, 0.1);
  draw(governor, 2000, 0.066);
  assert.equal(governor.quality.ratio, 1);
  assert.ok(governor.quality.isSlow);
});

test("after a failed try, the next try waits longer", () => {
  const governor = new Governor(FIRST_OF_PROCESSOR), between: number[] = [];
  let pictures = 0;
  for (let tries = 0; tries < 3; pictures = 0) {
    while (!governor.note(0.066)) pictures += 1;
    draw(governor, 20, 0.1);
    between.push(pictures);
    tries += 1;
  }
  assert.ok(between[0]! < between[1]! && between[1]! < between[2]!, between.join());
});

test("now and then a slow picture changes nothing", () => {
  const governor = new Governor(FIRST_OF_PROCESSOR);
  for (let i = 0; i < 300; ++i) assert.equal(governor.note(i % 5 === 0 ? 0.5 : 0.072), false);
});

test("full detail is kept on request, however long pictures take", () => {
  const governor = new Governor(0, true);
  assert.equal(draw(governor, 200, 1), 0);
  assert.equal(governor.quality, QUALITIES[0]);
});
