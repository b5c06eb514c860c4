// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Check, Mission, Time } from "../run/contents";
import { Attempt, passedOf, standingOf, whyOpen } from "./attempt";

const shelf = (): { getItem(key: string): string | null; setItem(key: string, value: string): void } => {
  const all = new Map<string, string>();
  return { getItem: (key) => all.get(key) ?? null, setItem: (key, value) => void all.set(key, value) };
};
const check = (state: string, tick: number): Check => ({ name: "n", expected: "", was: "it never did", agent: "a", is_marker: false, state, tick, time_s: tick / 30 });
const time = (more: Partial<Time> = {}): Time => ({
  first_tick: 0, shown_tick: 300, last_tick: 300, step_s: 1 / 30, is_recording: false, is_live: true, can_go_back: true, can_resume: false, resume_refusal: "", branch_tick: null, branches: 0, ...more,
});

test("no check is shown as failed before the learner has done anything, also after a reload", () => {
  const kept = shelf(), attempt = new Attempt(kept);
  attempt.begin("lesson:02-operators");
  assert.equal(standingOf(check("false", 31), time(), attempt), "open");
  assert.equal(standingOf(check("true", 31), time(), attempt), "passed");
  attempt.note();
  const again = new Attempt(kept);
  again.begin("lesson:02-operators");
  assert.equal(standingOf(check("false", 31), time(), again), "failed");
  again.begin("lesson:03-choices");
  assert.equal(standingOf(check("false", 31), time(), again), "open");
  again.begin("scenario:eaters");
  assert.equal(standingOf(check("false", 31), time(), again), "failed", "worlds have nothing to wait for");
});

test("checks restart with each Apply", () => {
  const attempt = new Attempt(shelf());
  assert.equal(attempt.begin("lesson:02-operators"), false);
  attempt.applied(100);
  assert.equal(standingOf(check("false", 31), time(), attempt), "open");
  assert.equal(standingOf(check("true", 31), time(), attempt), "open");
  assert.equal(standingOf(check("false", 101), time(), attempt), "failed");
  assert.match(whyOpen(time(), attempt), /rules changed/);
  assert.equal(attempt.begin("lesson:02-operators"), true);
  assert.equal(standingOf(check("false", 31), time(), attempt), "failed");
  assert.equal(whyOpen(time(), attempt), "");
});

test("at an earlier moment checks show their state at that moment", () => {
  const attempt = new Attempt(shelf()), past = time({ is_live: false, shown_tick: 50 }), mission: Mission = { checks: [check("true", 40), check("true", 60), check("open", 0)], lesson: null, lessons: [] };
  attempt.begin("scenario:x");
  assert.deepEqual(passedOf(mission, past, attempt), { passed: 1, of: 3 });
  assert.deepEqual(passedOf(mission, time(), attempt), { passed: 2, of: 3 });
});

test("after continuing from the past, no tick of the discarded future remains", () => {
  const attempt = new Attempt(shelf()), gone = time({ branch_tick: 50, branches: 1, shown_tick: 70, last_tick: 70 });
  attempt.begin("scenario:x");
  assert.equal(standingOf(check("true", 60), gone, attempt), "open");
  assert.equal(standingOf(check("true", 45), gone, attempt), "passed");
  assert.match(whyOpen(gone, attempt), /earlier moment/);
});

test("the learner's choice whether a run begins again with Apply is stored", () => {
  const kept = shelf(), attempt = new Attempt(kept);
  assert.equal(attempt.restarts, true);
  attempt.restarts = false;
  assert.equal(new Attempt(kept).restarts, false);
});
