// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { frameAddress } from "./embed";

const SERVER = "https://soar.example/embed.js";

test("a world of a course page leads to its frame on the server", () => {
  assert.equal(frameAddress("https://soar.example/#world=soar_evade", "", SERVER), "https://soar.example/embed#world=soar_evade");
  assert.equal(frameAddress("#lesson=02-operators&t=4", "mind why nonsense", SERVER), "https://soar.example/embed#lesson=02-operators&t=4&panels=mind%2Cwhy");
});

test("an address without a world or a server is refused", () => {
  for (const src of ["", "https://soar.example/", "javascript:alert(1)#world=a", "#world=", "http://[", "#recording=run-0001.soarrec"]) assert.equal(frameAddress(src, "", SERVER), null, src);
});
