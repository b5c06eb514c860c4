// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import { textOf, type Child, type View } from "../dom/view";
import type { Check, Contents, Mission, Stack } from "../run/contents";
import { agentsPanel } from "./agents";
import { exercisePanel } from "./exercise";
import { imageryPanel } from "./imagery";
import { Attempt } from "../lesson/attempt";
import { gradeLines, gradeText, missionPanel } from "../lesson/mission_panel";
import { sizeText } from "../lesson/start_page";
import { memoryPanel } from "./memory";
import { messagesPanel } from "./messages";
import { mindPanel } from "./mind";
import type { MakePanel, PanelContext } from "./panel";
import { protagonist } from "../app/protagonist";
import { clock, passes } from "./parts";
import { lineOf, placeTracks } from "./timeline";
import { problemsPanel } from "./problems";
import { whyPanel } from "./why";

const MARKUP = "<img onerror=alert(1)>";
const STACK: Stack = { decisions: 7, phase: "decide", halted: false, elaborations: 0, firings: 3, elements: 40, rules: 5, states: [{ level: 1, state: "S1", impasse: "", operator: "O3", name: MARKUP }] };
const MOMENT = { agent: MARKUP, has_mind: true, not_available: "", past_note: "", not_recorded: "", time: { first_tick: 0, shown_tick: 90, last_tick: 90, step_s: 1 / 30, is_recording: false, is_live: true, can_go_back: true, can_resume: true, resume_refusal: "", branch_tick: null, branches: 0 } };

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

test("every panel says what would fill it", () => {
  for (const make of [agentsPanel, exercisePanel, imageryPanel, whyPanel, mindPanel, memoryPanel, messagesPanel, problemsPanel, missionPanel]) {
    const { panel } = made(make);
    assert.ok(textOf(panel.view({})).length > 20, panel.word);
  }
});

test("names with markup are text and nothing else", () => {
  const contents: Contents = {
    moment: MOMENT, agents: { agents: [{ name: MARKUP, kind: "soar", team: "", script: "", mind: true, alive: true, failed: false, health: 80, state: "S1", operator: "wait", last_operator: "", command: "", decisions: 1, errors: 0 }], activities: {} },
    why: { question: MARKUP, answer: { text: MARKUP, kind: "agent" } }, messages: { messages: [{ tick: 3, time_s: 0.1, from: MARKUP, to: "all", about: "x", text: MARKUP }] },
    mind: { stack: STACK, operators: { state: "S1", selected: "O3", impasse: "", why: MARKUP, operators: [] } },
  };
  for (const make of [agentsPanel, whyPanel, messagesPanel, mindPanel]) {
    const { panel } = made(make), view = panel.view(contents);
    assert.ok(textOf(view).includes(MARKUP), panel.word);
    assert.ok(all(view).every((one) => !one.tag.includes("img")));
  }
});

test("a reason of then goes to its moment", () => {
  const asked: [string, unknown][] = [];
  const answer = { text: "command move-to", kind: "command", below: [{ text: "given by rule go", kind: "rule", time: 1.5 }] };
  const contents: Contents = { moment: MOMENT, why: { question: "Why?", answer } };
  const run = { ask: (request: string, fields: unknown) => (asked.push([request, fields]), true), contents };
  const view = whyPanel({ run, why: () => {} } as unknown as PanelContext).view(contents);
  const time = all(view).find((one) => one.props.attributes?.["title"] === "Go to tick 45");
  assert.ok(time);
  time.props.on!.click!({} as MouseEvent);
  assert.deepEqual(asked, [["seek", { tick: 45 }]]);
});

test("an agent without a Soar mind shows what its script shows of its state", () => {
  const { panel } = made(mindPanel);
  const rows = [{ depth: 0, name: "tree", value: "", active: false, since: 0 }, { depth: 1, name: MARKUP, value: "yes", active: true, since: 1.5 }];
  const operators = { state: "", selected: "", impasse: "", why: "", operators: [] };
  const view = panel.view({ moment: { ...MOMENT, has_mind: false }, mind: { stack: STACK, operators, shown: { agent: "guard", rows } } });
  const chosen = all(view).find((one) => one.tag === "li" && one.classes === "chosen");
  assert.equal(textOf(chosen!), `${MARKUP} yes`);
  assert.equal(chosen!.props.attributes?.["title"], "since 1.50 s");
  assert.ok(!textOf(view).includes("Goal stack"));
});

test("imagery is told state by state, and an answer is drawn when it is pressed", () => {
  const { panel, asked } = made(imageryPanel);
  const answer = { record: "R5", value: "1.400000", why: { text: "1.4: distance", kind: "imagined", link: "R5" }, nodes: ["self", MARKUP], lines: [] };
  const imagery = { note: "", scenes: [{
    state: "S1", nodes: [{ name: "world", parent: "", depth: 0, shape: "group", at: [0, 0, 0], tags: {} }, { name: MARKUP, parent: "world", depth: 1, shape: "ball", at: [1, 0, 2.5], tags: { kind: "box" } }],
    extracts: [{ id: "X7", command: "extract", rule: "ask", filter: "distance", status: "success", count: 3, values: [answer] }, { id: "X8", command: "extract", rule: "", filter: "", status: "", problem: "there is no node wal", hint: "did you mean wall?", count: 0, values: [] }],
  }] };
  const view = panel.view({ moment: MOMENT, imagery: { imagery, state: "", record: "" } }), text = textOf(view);
  for (const part of ["all of S1", "distance", "X7", "ask", "1.4", `self, ${MARKUP}`, "and 2 more", "did you mean wall?", "2 nodes", "1.00, 0.00, 2.50", "ball ^kind box"]) assert.ok(text.includes(part), `${part} in ${text}`);
  press(view, "all of S1");
  press(view, `1.4 self, ${MARKUP}`);
  assert.deepEqual(asked, [["imagine", { state: "S1", record: "" }], ["imagine", { state: "", record: "R5" }]]);
  const shown = panel.view({ moment: MOMENT, imagery: { imagery, state: "S1", record: "R5" } });
  assert.ok(textOf(shown).includes("1.4: distance"));
  press(shown, `1.4 self, ${MARKUP}`);
  assert.deepEqual(asked.at(-1), ["imagine", { state: "S1", record: "" }]);
  assert.match(textOf(panel.view({ moment: MOMENT, imagery: { imagery: { note: "It imagines nothing.", scenes: [] }, state: "", record: "" } })), /imagines nothing/);
});

test("an exercise is told with who is there, and what was dropped", () => {
  const { panel, asked } = made(exercisePanel);
  const entities = [{ id: "7:8:9", agent: "visitor", marking: "visitor", team: "red", body: "soldier", type: "3.1.225.1.1.0.0", silent_s: 0 }, { id: "7:8:10", agent: "", marking: MARKUP, team: "blue", body: "walker", type: "1.2.225.1.1.0.0", silent_s: 9 }];
  const view = panel.view({ moment: MOMENT, exercise: { exercise: {
    number: 3, address: "239.1.2.3:3000", this_machine_only: true, as: "1:7", listens_only: false, takes_orders: true, is_frozen: true, sent: 120, sent_per_s: 4.5, not_sent: 0, received: 80, received_per_s: 2,
    dropped: [{ why: "too short", count: 12 }], entity_count: 300, entities,
  } } });
  assert.match(textOf(view), /Exercise 3.*Frozen.*239\.1\.2\.3:3000.*this machine only.*1:7, and take orders.*120 PDUs, 4\.5 per second.*12 too short.*300 entities of others.*The first 2/s);
  assert.ok(textOf(view).includes(MARKUP));
  press(view, "visitor");
  assert.deepEqual(asked, [["select", { agent: "visitor" }]]);
  assert.match(textOf(panel.view({ exercise: { exercise: null } })), /no exercise/);
});

test("whom another simulation moves is marked", () => {
  const { panel } = made(agentsPanel);
  const row = { kind: "foreign", team: "red", script: "", mind: false, alive: true, failed: false, health: 80, state: "", operator: "", last_operator: "", command: "", decisions: 0, errors: 0 };
  const view = panel.view({ moment: MOMENT, agents: { agents: [{ name: "visitor", ...row }], activities: {} } });
  assert.match(textOf(view), /visitor.*foreign/s);
  assert.ok(all(view).some((one) => one.classes.includes("foreign")));
});

test("an agent's name selects it", () => {
  const { panel, asked } = made(agentsPanel);
  const row = { kind: "soar", team: "red", script: "", mind: true, alive: true, failed: false, health: 80, state: "S1", operator: "wait", last_operator: "", command: "", decisions: 1, errors: 0 };
  press(panel.view({ moment: MOMENT, agents: { agents: [{ name: "anna", ...row }, { name: "bert", ...row }], activities: {} } }), "bert");
  assert.deepEqual(asked, [["select", { agent: "bert" }]]);
});

test("an object of memory unfolds by a request, and what changed is marked", () => {
  const { panel, asked } = made(memoryPanel);
  const contents: Contents = { moment: MOMENT, memory: { stack: STACK, found: [], element: null, objects: { S1: { id: "S1", about: "", exists: true, elements: [{ timetag: 9, id: "S1", attribute: "io", value: "I1", object: true, change: "added" }] } } } };
  const view = panel.view(contents), unfold = all(view).find((one) => one.props.attributes?.["aria-label"] === "Unfold I1")!;
  unfold.props.on!.click!({} as MouseEvent);
  assert.deepEqual(asked, [["object", { id: "I1", is_open: true }]]);
  assert.ok(all(view).some((one) => one.classes === "added"));
});

test("a loop in memory ends", () => {
  const { panel } = made(memoryPanel), row = { timetag: 9, id: "S1", attribute: "self", value: "S1", object: true };
  assert.match(textOf(panel.view({ moment: MOMENT, memory: { stack: STACK, found: [], element: null, objects: { S1: { id: "S1", about: "", exists: true, elements: [row] } } } })), /\^self S1/);
});

const check = (name: string, state: string, isMarker = false): Check => ({ name, expected: "", was: "", agent: "porter", is_marker: isMarker, state, tick: 30, time_s: 1 });

test("checks tick off; marks do not count", () => {
  const mission: Mission = { checks: [check("a", "true"), check("b", "open"), check("m", "true", true)], lesson: null, lessons: [] };
  const { panel } = made(missionPanel);
  assert.equal(panel.badge!({ mission }), "1/2");
  assert.match(textOf(panel.view({ moment: MOMENT, mission })), /passed: a.*not decided yet: b/s);
});

test("the agent whom most checks are about is the protagonist", () => {
  const of = (...expected: string[]): Mission => ({ checks: expected.map((one) => ({ ...check(one, "open"), agent: "", expected: one })), lesson: null, lessons: [] });
  assert.equal(protagonist(of("hare should give evade by 20 s", "hare should never be at most 1 m from bear"), ["bear", "hare"]), "hare");
  assert.equal(protagonist(of("leader should walk", "follower-* should give follow", "follower-* should see leader"), ["leader", "follower-1", "follower-2"]), "follower-1");
  assert.equal(protagonist(of("hider should select operator hide", "searcher should see hider"), ["searcher", "hider"]), "hider", "of equals the first");
  assert.equal(protagonist(of("the run should reach 'blue wins'"), ["a", "b"]), "a");
  assert.equal(protagonist(of(), []), "");
});

test("hints, grade and the next lesson are asked for", () => {
  const { panel, asked } = made(missionPanel);
  const lesson = { name: "01", title: "One", idea: "i", task: "t", panel: "Memory", new_panels: ["memory", "edit"], hints: ["first"], hint_count: 3, is_passed: true, is_graded: false, grade: ["all passed"], next: "02" };
  const view = panel.view({ moment: MOMENT, mission: { checks: [], lesson, lessons: [] } });
  press(view, "Hint 2 of 3");
  press(view, "Grade");
  assert.deepEqual(asked, [["lesson", { what: "hint" }], ["lesson", { what: "grade" }]]);
  assert.match(textOf(view), /all passed.*New here: memory, edit/s, "the grade comes first");
});

test("a pass is celebrated and leads to the next lesson; a server's folders are not told", () => {
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
