// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { formatAddress, NOWHERE, packFiles, packText, parseAddress, unpackFiles, unpackText } from "./address";

const NEEDS_DEFLATE = { skip: process.versions.node.startsWith("18.") && "Node.js 18 has no deflate-raw, which browsers have" };

test("lessons, worlds, recordings, moments and files have addresses that can be read again", () => {
  for (const address of [
    { ...NOWHERE, what: "lesson:02-operators" }, { ...NOWHERE, what: "scenario:soar_evade", seconds: 4.3, file: "hare.soar" }, { ...NOWHERE, what: "recording:run-0001.soarrec", seconds: 0 },
    { ...NOWHERE, what: "scenario:a b&c=#/ü", file: "x+y.soar" }, { ...NOWHERE, what: "lesson:1", file: "a", text: "abc-_" },
    { ...NOWHERE, what: "scenario:soar_evade", seconds: 12, seed: 0, agent: "hare", rules: "abc-_" },
  ]) assert.deepEqual(parseAddress(formatAddress(address)), address);
  assert.equal(formatAddress({ ...NOWHERE, what: "scenario:eaters", seconds: 1 / 3 }), "#world=eaters&t=0.333");
});

test("an address without contents means the start page", () => {
  for (const hash of ["", "#", "#watch=abc", "#lesson=", "#nonsense"]) assert.equal(parseAddress(hash).what, "");
  assert.equal(formatAddress(NOWHERE), "");
  for (const seed of ["-1", "x", "", "1e9", "1234567890123456"]) assert.equal(parseAddress(`#world=a&seed=${seed}`).seed, null);
  for (const t of ["-1", "x", "", "1e9", "NaN"]) assert.equal(parseAddress(`#world=a&t=${t}`).seconds, t === "" ? 0 : null);
});

test("an address can contain rules; damaged ones are refused", NEEDS_DEFLATE, async () => {
  const rules = "sp {größe\n   (state <s> ^superstate nil)\n-->\n   (write |hä|)}\n".repeat(20), packed = await packText(rules);
  assert.match(packed, /^[\w-]+$/);
  assert.ok(packed.length < rules.length / 4);
  assert.equal(await unpackText(packed), rules);
  assert.equal(await unpackText(packed.slice(0, 20)), null);
  assert.equal(await unpackText("%%%"), null);
  assert.equal(await unpackText(await packText("x".repeat(600_000))), null);
});

test("the files of an experiment travel in an address; names that lead elsewhere are refused", NEEDS_DEFLATE, async () => {
  const files = { "hare.soar": "sp {größe}\n", "maps/field.toml": "" };
  assert.deepEqual(await unpackFiles(await packFiles(files)), files);
  assert.deepEqual(await unpackFiles(await packFiles({})), {});
  for (const name of ["../a", "/a", "a//b", "a/", "", ".hidden", "a\\b", "a/../b"]) assert.equal(await unpackFiles(await packFiles({ [name]: "" })), null, name);
  for (const told of ["[]", "null", "7", '{"a.soar": 7}', "{"]) assert.equal(await unpackFiles(await packText(told)), null, told);
  assert.equal(await unpackFiles("abc"), null);
  assert.equal(await unpackFiles(await packFiles(Object.fromEntries(Array.from({ length: 101 }, (_, i) => [`${i}.soar`, ""])))), null);
});
