// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { textOf, type Child, type View } from "../dom/view";
import type { Check, Mission } from "../run/contents";
import { Attempt } from "../lesson/attempt";
import { gradeLines, gradeText, missionPanel } from "../lesson/mission_panel";
import { sizeText } from "../lesson/start_page";
import type { MakePanel, PanelContext } from "./panel";
import { protagonist } from "../app/protagonist";
import { clock, passes } from "./parts";
import { lineOf, namesOf, placeTracks, type BarName } from "./timeline";

const MOMENT = { agent: "porter", has_mind: true, not_available: "", past_note: "", not_recorded: "", time: { first_tick: 0, shown_tick: 90, last_tick: 90, step_s: 1 / 30, is_recording: false, is_live: true, can_go_back: true, can_resume: true, resume_refusal: "", branch_tick: null, branches: 0 } };

function made(make: MakePanel): { panel: ReturnType<MakePanel>; asked: [string, unknown][] } {
  const asked: [string, unknown][] = [];
  const run = { ask: (request: string, fields: unknown) => (asked.push([request, fields]), true), hello: null };
  const context = { run, redraw: () => {}, reveal: () => {}, titleOf: (word: string) => word, why: (about: string, what?: string) => asked.push(["why", { about, what }]), edit: () => {}, openWhat: () => {}, goHome: () => {},
    grade: () => asked.push(["lesson", { what: "grade" }]), attempt: new Attempt({ getItem: () => null, setItem: () => {} }) };
  return { panel: make(context as unknown as PanelContext), asked };
}

function all(child: Child): View[] {
  if (Array.isArray(child)) return (child as readonly Child[]).flatMap(all);
  return typeof child === "object" && child !== null ? [child as View, ...all((child as View).children)] : [];
}
const press = (child: Child, text: string): void => {
  const found = all(child).find((one) => one.tag === "button" && textOf(one) === text);
  assert.ok(found, `there is no button ${text}`);
  found.props.on!.click!({} as MouseEvent);
};

test("the empty panel Mission says what would fill it", () => {
  assert.ok(textOf(made(missionPanel).panel.view({})).length > 20);
});

const check = (name: string, state: string, isMarker = false): Check => ({ name, expected: "", was: "", agent: "porter", is_marker: isMarker, state, tick: 30, time_s: 1 });

test("checks tick off; marks do not count", () => {
  const mission: Mission = { checks: [check("a", "true"), check("b", "open"), check("m", "true", true)], lesson: null, lessons: [] };
  const { panel } = made(missionPanel);
  assert.equal(panel.badge!({ mission }), "1/2");
  assert.match(textOf(panel.view({ moment: MOMENT, mission })), /passed: a.*not decided yet: b/s);
});

test("the agent with the most checks is the protagonist", () => {
  const of = (...expected: string[]): Mission => ({ checks: expected.map((one) => ({ ...check(one, "open"), agent: "", expected: one })), lesson: null, lessons: [] });
  assert.equal(protagonist(of("hare should give evade by 20 s", "hare should never be at most 1 m from bear"), ["bear", "hare"]), "hare");
  assert.equal(protagonist(of("leader should walk", "follower-* should give follow", "follower-* should see leader"), ["leader", "follower-1", "follower-2"]), "follower-1");
  assert.equal(protagonist(of("hider should select operator hide", "searcher should see hider"), ["searcher", "hider"]), "hider", "of equals the first");
  assert.equal(protagonist(of("the run should reach 'blue wins'"), ["a", "b"]), "a");
  assert.equal(protagonist(of(), []), "");
});

test("buttons request hints, the grade and the next lesson", () => {
  const { panel, asked } = made(missionPanel);
  const lesson = { name: "01", title: "One", idea: "i", task: "t", panel: "Memory", new_panels: ["memory", "edit"], hints: ["first"], hint_count: 3, is_passed: true, is_graded: false, grade: ["all passed"], next: "02" };
  const view = panel.view({ moment: MOMENT, mission: { checks: [], lesson, lessons: [] } });
  press(view, "Hint 2 of 3");
  press(view, "Grade");
  assert.deepEqual(asked, [["lesson", { what: "hint" }], ["lesson", { what: "grade" }]]);
  assert.match(textOf(view), /all passed.*New here: memory, edit/s, "the grade comes first");
});

test("a pass is celebrated and leads to the next lesson; the folders of a server are not shown", () => {
  const { panel } = made(missionPanel);
  const lesson = { name: "01", title: "One", idea: "i", task: "t", panel: "Memory", new_panels: [], hints: [], hint_count: 0, is_passed: true, is_graded: false, grade: ["Passed with all of 10 seeds.", "  yes  it greets"], next: "02" };
  const view = panel.view({ moment: MOMENT, mission: { checks: [], lesson, lessons: [{ name: "01", title: "One", is_passed: true }, { name: "02", title: "Two", is_passed: false }] } });
  assert.match(textOf(view), /You have passed “One”.*Next lesson: Two.*1 of 2 lessons passed.*yes: it greets/s);
  assert.equal(all(view).filter((one) => one.tag === "button" && /Next lesson/.test(textOf(one))).length, 1);
  assert.equal(gradeText("/var/state/places/abc/home/01/porter.soar:3:4: error: x"), "porter.soar:3:4: error: x");
  assert.deepEqual(gradeLines(["a cause", "", "  no   b", "3 of 10 seeds passed; this was seed 1: soarbox run /x --seed 1"]), { headline: "a cause", isPass: false, lines: [{ sign: "cross", text: "b" }, { sign: "", text: "3 of 10 seeds passed; this was seed 1" }] });
});

test("grading shows how far it is and can be cancelled", () => {
  const { panel, asked } = made(missionPanel);
  const lesson = { name: "01", title: "One", idea: "i", task: "t", panel: "Memory", new_panels: [], hints: [], hint_count: 0, is_passed: false, is_graded: true, grade: ["seed 3 of 10"], next: "" };
  const view = panel.view({ moment: MOMENT, mission: { checks: [], lesson, lessons: [] } });
  assert.match(textOf(view), /Grading: seed 3 of 10/);
  press(view, "Cancel");
  assert.deepEqual(asked, [["lesson", { what: "cancel" }]]);
});

test("spans lie on the lines of their level", () => {
  assert.deepEqual([lineOf({ kind: "operator", level: 1 }), lineOf({ kind: "state", level: 2 }), lineOf({ kind: "operator", level: 2 })], [0, 1, 2]);
  const placed = placeTracks([{ agent: "a", marks: [], spans: [{ kind: "state", level: 3, id: "S9", text: "tie", first_tick: 1, last_tick: 2, open: false }] }, { agent: "b", marks: [], spans: [] }], 1200, 500);
  assert.equal(placed.first, 300);
  assert.equal(placed.rows[0]!.lines, 5);
  assert.ok(placed.rows[1]!.top > placed.rows[0]!.top + 5 * 16);
});

test("times, filters and sizes", () => {
  assert.deepEqual([clock(0), clock(61.239), clock(3599.999), clock(-1)], ["0:00.00", "1:01.24", "60:00.00", "0:00.00"]);
  assert.ok(passes("AN be", "anna, bert") && !passes("cy", "anna") && passes("", "x"));
  assert.deepEqual([sizeText(999), sizeText(5400), sizeText(2_340_000)], ["999 bytes", "5 kB", "2.3 MB"]);
});

test("narrow bars of one operator share a name; wide ones have their own", () => {
  const bar = (text: string, left: number, right: number, level = 1): BarName => ({ text, kind: "operator", level, left, right });
  const names = (...bars: BarName[]): string[] => namesOf(bars).map((one) => `${one.text} ${one.left}-${one.right}`);
  assert.deepEqual(names(bar("follow", 0, 10), bar("follow", 10, 20), bar("follow", 21, 40)), ["follow 0-40"]);
  assert.deepEqual(names(bar("follow", 0, 20), bar("flee", 20, 25), bar("follow", 25, 40)), []);
  assert.deepEqual(names(bar("follow", 0, 20), bar("follow", 30, 60)), ["follow 30-60"]);
  assert.deepEqual(names(bar("step", 0, 30), bar("step", 30, 60)), ["step 0-30", "step 30-60"]);
  // Levels of the stack are separate lines.
  assert.deepEqual(names(bar("go", 0, 15), bar("in", 0, 15, 2), bar("go", 15, 30), bar("in", 15, 30, 2)), ["go 0-30", "in 0-30"]);
});
