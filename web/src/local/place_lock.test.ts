// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { takePlaceLock, type LockSurroundings } from "./place_lock";

const aborted = (): Error => Object.assign(new Error("aborted"), { name: "AbortError" });

/** A lock of the browser. `isRefused`: it refuses the request. */
function fakeLocks(isRefused = false): NonNullable<LockSurroundings["locks"]> {
  let isTaken = false;
  return {
    request: async (_name, { signal }, call) => {
      if (isRefused) throw Object.assign(new Error("denied"), { name: "SecurityError" });
      if (isTaken) return new Promise((_, failed) => signal.addEventListener("abort", () => failed(aborted())));
      isTaken = true;
      return call();
    },
  };
}

/** Channels between tabs. */
function fakeChannels(): LockSurroundings["makeChannel"] {
  const all: NonNullable<ReturnType<LockSurroundings["makeChannel"]>>[] = [];
  return () => {
    const one: (typeof all)[number] = { onmessage: null, postMessage: (data) => setTimeout(() => all.forEach((other) => other !== one && other.onmessage?.({ data })), 1) };
    all.push(one);
    return one;
  };
}

test("the first tab gets the place, the second does not", async () => {
  const locks = fakeLocks(), tab = { locks, makeChannel: () => null };
  assert.equal(await takePlaceLock(tab, 20), true);
  assert.equal(await takePlaceLock(tab, 20), false);
});

test("without locks, tabs ask each other, also at the same time", async () => {
  for (const locks of [null, fakeLocks(true)]) {
    const tab = { locks, makeChannel: fakeChannels() };
    assert.equal((await Promise.all([takePlaceLock(tab, 30), takePlaceLock(tab, 30)])).filter(Boolean).length, 1);
    assert.equal(await takePlaceLock(tab, 30), false);
  }
  assert.equal(await takePlaceLock({ locks: null, makeChannel: () => null }), true);
});
