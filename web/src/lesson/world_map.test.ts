// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { existsSync, readdirSync } from "node:fs";
import { test } from "node:test";
import maps from "./maps.json";

test("each world, and nearly each lesson, has a map with somebody or something in it: python3 make_maps.py makes missing ones", () => {
  const folders = (path: string, file: string): string[] => readdirSync(path, { recursive: true }).map(String).filter((name) => name.endsWith(`/${file}`) || name === file).map((name) => name.split("/").at(-2)!);
  assert.ok(existsSync("../scenarios") && existsSync("../lessons"));
  const worlds = [...new Set([...folders("../scenarios", "scenario.toml"), ...folders("../scenarios", "Sandbox.lua")])].sort(), lessons = folders("../lessons", "lesson.toml");
  assert.ok(worlds.length > 25 && lessons.length > 35);
  const known = maps as Record<string, { things: unknown[]; agents: unknown[] }>;
  assert.deepEqual(worlds.filter((name) => known[name] === undefined), []);
  // A lesson that was just written has none yet.
  assert.ok(lessons.filter((name) => known[name] === undefined).length <= 6);
  assert.deepEqual(Object.keys(known).filter((name) => known[name]!.things.length + known[name]!.agents.length === 0), []);
});
