// SPDX-License-Identifier: BSD-2-Clause
import assert from "node:assert/strict";
import { test } from "node:test";
import type { GameInfo } from "../app/api";
import { textOf } from "../dom/view";
import { recordingText } from "../lesson/start_page";
import { worldMap } from "../lesson/world_map";
import { learnersArena, tournamentView } from "./arena_view";
import { coursesOf, duration, now, scoreText, standing } from "./class_table";

const learner = { name: "Ada", place: "x", place_link: "/p/x/", watch_link: "/p/x/", is_here: true, done: { a: { is_done: true, tries: 3, hints: 1 }, b: { is_done: false, tries: 2, hints: 0 }, c: { is_done: false, tries: 0, hints: 0 }, d: { is_done: false, passed: 2, of: 3, tries: 1 } } };

test("a learner's state is shown as a sign and a sentence", () => {
  assert.deepEqual(standing(learner, "a"), { text: "✓", says: "passed, 3 tries, 1 hint", kind: "done" });
  assert.deepEqual(standing(learner, "b"), { text: "2×", says: "not passed, 2 tries, 0 hints", kind: "begun" });
  assert.equal(standing(learner, "c").kind, "none");
  assert.equal(standing(learner, "d").text, "2/3");
  assert.equal(standing(learner, "nobody").kind, "none");
});

test("a stuck learner is shown with cause and duration, and the lesson with its title", () => {
  const titleOf = (name: string): string => (name === "01-a-rule" ? "A rule" : name);
  assert.deepEqual(now({ ...learner, doing: "lesson:01-a-rule", standing: "stuck", trouble: "error in porter.soar, line 4: a ( is open", lasts_s: 250 }, titleOf), { what: "A rule", state: "Stuck for 4 min: error in porter.soar, line 4: a ( is open", isStuck: true });
  assert.deepEqual(now({ ...learner, doing: "scenario:eaters", standing: "works", trouble: "" }, titleOf), { what: "eaters", state: "", isStuck: false });
  assert.equal(now({ ...learner, doing: "", standing: "idle", lasts_s: 7300 }, titleOf).state, "Nothing done for 2 h");
  assert.deepEqual([0, 89, 90, 5399, 5400].map(duration), ["0 s", "89 s", "2 min", "90 min", "2 h"]);
});

test("lessons are in columns of their courses", () => {
  const courses = coursesOf({ lessons: [{ name: "01", title: "One", course: "" }, { name: "e1", title: "Hello", course: "eaters" }, { name: "02", title: "Two" }], learners: [] });
  assert.deepEqual(courses.map((one) => [one.title, one.lessons.map((lesson) => lesson.name)]), [["Lessons", ["01", "02"]], ["Eaters", ["e1"]]]);
});

test("the teacher sees which scores did not reach the learning platform", () => {
  assert.equal(scoreText(undefined) + scoreText({ sent: 3, waiting: 0, refused: 0, trouble: "" }), "");
  assert.equal(scoreText({ sent: 0, waiting: 2, refused: 1, trouble: "Moodle did not take a score: status 503" }), "Scores for your learning platform: 2 not sent yet, 1 refused. Moodle did not take a score: status 503.");
});

const game: GameInfo = {
  name: "eaters", title: "Eaters", seconds: 120, entries: [{ learner: "Ada", file: "a.soar", when: 1 }], mine: null,
  tournament: {
    is_playing: true, played: 1, seeds: 2, ladder: [{ learner: "Ada", points: 2, won: 1, drawn: 0, lost: 0, scored: 30, conceded: 10 }],
    matches: [{ learners: ["Ada", "Bob"], seed: 1, scores: [30, 10], trouble: "", replay: "m1" }, { learners: ["Bob", "Ada"], seed: 2, scores: null, trouble: "", replay: null }, { learners: ["Bob", "Cy"], seed: 1, scores: null, trouble: "a ( is open", replay: null }],
  },
};

test("a tournament is a ladder with its seeds, and matches with a replay or the reason why there is none", () => {
  const text = textOf(tournamentView(game, { replay: () => {} }));
  assert.match(text, /1 of 3 matches played/);
  assert.match(text, /seeds 1 to 2/);
  assert.match(text, /Ada against Bobseed 130 : 10Replay/);
  assert.match(text, /Bob against Adaseed 2not played yet/);
  assert.match(text, /Bob against Cyseed 1a \( is open$/);
});

test("a learner hands in rules of the copied world, and is told how to get one", () => {
  const files = [{ path: "worlds/eaters/mine.soar" }, { path: "worlds/eaters/scenario.toml" }, { path: "worlds/tanksoar/x.soar" }];
  assert.match(textOf(learnersArena({ games: [game] }, files, () => {}, {})), /Hand in mine\.soar(?!.*x\.soar)/);
  assert.match(textOf(learnersArena({ games: [game] }, [], () => {}, {})), /Open the world eaters/);
});

test("a recording has world, length and time; a map shows who is where", () => {
  const { title, about } = recordingText({ name: "run-0001.soarrec", bytes: 1_200_000, when: 1_700_000_000, world: "soar_evade", seconds: 83.4 }, "en-GB");
  assert.equal(title, "soar_evade");
  assert.match(about, /^1:23\.4\d* long, \d+ Nov 2023, .*, 1\.2 MB$/);
  assert.equal(recordingText({ name: "odd.soarrec", bytes: 10, when: 0, world: "" }).title, "odd.soarrec");
  assert.equal(worldMap(undefined), null);
  const map = worldMap({ things: [[50, 50, 20, 0, 0], [100, 20, 80, 4, 30]], agents: [[10, 10]] });
  assert.equal(map?.children.flat().length, 3);
});
