// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { dataPlaces, MASKS, power, product, qrCode, type QrCode } from "./qr";

/** Reads a code as a phone does: format, mask, blocks, checks, text. Blocks by version: check words, then data words of each. */
const BLOCKS: Readonly<Record<number, readonly [number, readonly number[]]>> = { 1: [10, [16]], 3: [26, [44]], 4: [18, [32, 32]], 8: [22, [38, 38, 39, 39]], 10: [26, [43, 43, 43, 43, 44]] };

function read(code: QrCode): string {
  const { size, dark, version } = code, version4 = (size - 17) / 4;
  assert.equal(version4, version);
  const format = [...[0, 1, 2, 3, 4, 5, 7, 8].map((row) => dark[row]![8]!), ...[7, 5, 4, 3, 2, 1, 0].map((column) => dark[8]![column]!)].reduce((sum, bit, i) => sum | (bit ? 1 << i : 0), 0) ^ 0x5412;
  assert.equal(format >> 13, 0, "level M");
  const mask = (format >> 10) & 7, bits = dataPlaces(size, code.isFixed).map(([row, column]) => dark[row]![column] !== MASKS[mask]!(row, column));
  const words: number[] = [];
  for (let i = 0; i + 8 <= bits.length; i += 8) words.push(bits.slice(i, i + 8).reduce((sum, bit) => sum * 2 + (bit ? 1 : 0), 0));
  const [checks, sizes] = BLOCKS[version]!, blocks: number[][] = sizes.map(() => []);
  let at = 0;
  for (let i = 0; i < Math.max(...sizes); ++i) sizes.forEach((room, b) => i < room && blocks[b]!.push(words[at++]!));
  for (let i = 0; i < checks; ++i) sizes.forEach((_room, b) => blocks[b]!.push(words[at++]!));
  for (const block of blocks)
    for (let i = 0; i < checks; ++i) assert.equal(block.reduce((sum, word) => product(sum, power(i)) ^ word, 0), 0, "the check words fit the data");
  const data = blocks.flatMap((block, b) => block.slice(0, sizes[b])), all = data.flatMap((word) => [7, 6, 5, 4, 3, 2, 1, 0].map((i) => (word >> i) & 1));
  const number = (from: number, count: number): number => all.slice(from, from + count).reduce((sum, bit) => sum * 2 + bit, 0);
  assert.equal(number(0, 4), 4);
  const lengthBits = version < 10 ? 8 : 16, length = number(4, lengthBits);
  return new TextDecoder().decode(Uint8Array.from({ length }, (_none, i) => number(4 + lengthBits + 8 * i, 8)));
}

test("a link can be read again from its code", () => {
  for (const [text, version] of [["soarbox", 1], ["http://localhost/p/abcdefgh", 3], ["http://127.0.0.1:8080/p/1wfw3fkq9jq77an03set775r2e/", 4], [`https://learn.example/${"x".repeat(120)}`, 8], ["é".repeat(100), 10]] as const) {
    const code = qrCode(text)!;
    assert.equal(code.version, version);
    assert.equal(read(code), text);
  }
});

test("the corners have finder patterns, with alternating lines between them", () => {
  const { dark, size } = qrCode("http://localhost/")!;
  for (const [row, column] of [[0, 0], [0, size - 7], [size - 7, 0]] as const) {
    assert.ok(dark[row]![column] && dark[row + 6]![column + 6] && dark[row + 3]![column + 3]);
    assert.ok(!dark[row + 1]![column + 1]);
  }
  for (let i = 8; i < size - 8; ++i) assert.equal(dark[6]![i], i % 2 === 0);
});

test("a text that is too long has no code", () => {
  assert.equal(qrCode("x".repeat(214)), null);
});
