// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { ByteReader } from "./byte_reader";
import { DrawableTable, type Drawables } from "./drawables";

const number = (value: number): number[] => (value < 0x80 ? [value] : [(value & 0x7f) | 0x80, ...number(Math.floor(value / 128))]);
const signed = (value: number): number[] => number(value < 0 ? -2 * value - 1 : 2 * value);
const floats = (...values: number[]): number[] => [...new Uint8Array(Float32Array.from(values).buffer)];
const description = (material: number): number[] => {
  const bytes = [...number(0), 2, 1, 0, material, ...floats(1, 1, 1, 1, 1, 1, 1, 1, 1)];
  return [...number(bytes.length), ...bytes];
};

interface Told { id: number; material?: number; place?: readonly number[] }
/** A section of drawables: docs/dev/stream.md. Places are differences, in mm. */
function section(told: readonly Told[], gone: readonly number[] = []): ByteReader {
  const bytes = number(gone.length);
  let last = 0;
  for (const id of gone) bytes.push(...number(id - last)), (last = id);
  last = 0;
  for (const { id, material, place } of told) {
    bytes.push(...number(id - last), (material !== undefined ? 1 : 0) + (place !== undefined ? 2 : 0), ...(material !== undefined ? description(material) : []), ...(place ?? []).flatMap(signed));
    last = id;
  }
  return new ByteReader(Uint8Array.from(bytes));
}

const WORDS = ["", "Red", "Blue"];
/** Words are read from the bytes, as the reader of scenes does. */
function read(table: DrawableTable, isFull: boolean, told: readonly Told[], gone: readonly number[] = []): Drawables {
  const input = section(told, gone);
  return table.read(input, isFull, () => WORDS[input.number()]!);
}

test("a full block that repeats everything changes no version, no description and no slot", () => {
  const table = new DrawableTable(), all = [{ id: 3, material: 1, place: [1000, 0, 0] }, { id: 8, material: 2 }];
  const first = read(table, true, all), second = read(table, true, all);
  assert.equal(second.structure, first.structure);
  assert.deepEqual(second.versions, first.versions);
  assert.deepEqual(second.get(3)!.place, [1, 0, 0]);
});

test("what a full block leaves out is gone, and what it leaves at zero is at zero", () => {
  const table = new DrawableTable();
  const first = read(table, true, [{ id: 3, material: 1, place: [1000, 0, 0] }, { id: 8, material: 2, place: [5, 5, 5] }]);
  const second = read(table, true, [{ id: 3, material: 1 }]);
  assert.equal(second.size, 1);
  assert.equal(second.get(8), undefined);
  assert.deepEqual(second.get(3)!.place, [0, 0, 0]);
  assert.deepEqual(first.get(3)!.place, [1, 0, 0]);
  assert.equal(first.size, 2);
});

test("only the version of a drawable that moved changes", () => {
  const table = new DrawableTable();
  const first = read(table, true, [{ id: 3, material: 1 }, { id: 8, material: 2 }]), second = read(table, false, [{ id: 8, place: [0, 250, 0] }]);
  const [still, moved] = [3, 8].map((id) => second.structure.slotOf(id)!) as [number, number];
  assert.equal(second.structure, first.structure);
  assert.equal(second.versions[still], first.versions[still]);
  assert.notEqual(second.versions[moved], first.versions[moved]);
  assert.deepEqual(second.at(moved).place, [0, 0.25, 0]);
});

test("another drawable in the same slot is not the same one", () => {
  const table = new DrawableTable(), first = read(table, true, [{ id: 3, material: 1 }]), second = read(table, false, [{ id: 9, material: 1 }], [3]);
  const slot = second.structure.slotOf(9)!;
  assert.equal(slot, first.structure.slotOf(3));
  assert.equal(second.hasSame(slot, first), false);
  assert.equal(second.hasSame(slot, read(table, false, [{ id: 9, place: [1, 0, 0] }])), true);
  assert.equal(second.hasSame(slot, read(new DrawableTable(), true, [{ id: 9, material: 1 }])), false);
});

test("a new description of one drawable leaves the objects of the others", () => {
  const table = new DrawableTable(), first = read(table, true, [{ id: 3, material: 1 }, { id: 8, material: 2 }]), second = read(table, false, [{ id: 8, material: 1 }]);
  const [a, b] = [first, second].map((one) => one.structure.descriptions);
  assert.notEqual(first.structure, second.structure);
  assert.equal(a![0], b![0]);
  assert.deepEqual([a![1]!.material, b![1]!.material], ["Blue", "Red"]);
});

test("a full block without a description is refused", () => {
  const table = new DrawableTable();
  read(table, true, [{ id: 3, material: 1 }]);
  assert.throws(() => read(table, true, [{ id: 3, place: [1, 1, 1] }]), /no description/);
});
