// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { lookOf } from "./looks";

/** The window's table of materials. Tests run in web/. */
const PALETTE = readFileSync("../src/viewer/palette.cpp", "utf8");

test("each of the window's materials looks the same here", () => {
  const materials = [...PALETTE.matchAll(/\{"([A-Za-z/0-9_]+)", \{(?:\{([\d.f, ]+)\}|k[A-Z]\w+), .*?Paint::k(\w+)/g)].filter(([, name]) => name!.startsWith("Soarbox/"));
  assert.ok(materials.length > 30, `${materials.length} materials are found in palette.cpp`);
  for (const [, name, base, paint] of materials) {
    const look = lookOf(name!);
    assert.equal(look.paint, paint!.toLowerCase(), name);
    if (base === undefined) continue;
    assert.deepEqual([...look.base], base.replaceAll("f", "").split(",").slice(0, 3).map(Number), name);
  }
});
