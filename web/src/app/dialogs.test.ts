// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { View } from "../dom/view";
import { qrView } from "./dialogs";

/** The dark places of a code, and the width of its picture. */
function read(view: View): { size: number; isDark: (x: number, y: number) => boolean } {
  const size = Number(String(view.props.attributes?.["viewBox"]).split(" ")[2]), path = view.children.map((one) => (one as View)).find((one) => one.tag === "path")!;
  const dark = new Set(String(path.props.attributes?.["d"]).match(/M\d+ \d+/g));
  return { size, isDark: (x, y) => dark.has(`M${x} ${y}`) };
}

test("a QR code has three finder patterns inside a light edge", () => {
  const { size, isDark } = read(qrView("http://localhost/p/abcdefgh")!);
  assert.equal(size, 29 + 8, "version 3: 27 bytes at level M");
  for (let i = 0; i < size; ++i) for (let edge = 0; edge < 4; ++edge)
    assert.ok(![isDark(i, edge), isDark(edge, i), isDark(i, size - 1 - edge), isDark(size - 1 - edge, i)].includes(true));
  for (const [x, y] of [[4, 4], [size - 11, 4], [4, size - 11]] as const) {
    for (let i = 0; i < 7; ++i) assert.ok(isDark(x + i, y) && isDark(x, y + i) && isDark(x + i, y + 6) && isDark(x + 6, y + i));
    assert.ok(isDark(x + 3, y + 3) && !isDark(x + 1, y + 1) && !isDark(x + 5, y + 5));
  }
  for (let i = 12; i < size - 12; ++i) assert.equal(isDark(i, 10), i % 2 === 0);
});

test("a text that is too long has no QR code", () => {
  assert.notEqual(qrView("x".repeat(2000)), null);
  assert.equal(qrView("x".repeat(3000)), null);
});
