// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import { icon } from "../app/icons";
import type { Check, Lesson, Mission } from "../run/contents";
import type { MakePanel, PanelContext } from "../panels/panel";
import { clock, empty } from "../panels/parts";

const SIGNS: Readonly<Record<string, { sign: "check" | "cross" | "open"; says: string }>> = {
  true: { sign: "check", says: "passed" }, false: { sign: "cross", says: "failed" }, open: { sign: "open", says: "not decided yet" },
  untested: { sign: "open", says: "nothing to test yet" }, undecided: { sign: "open", says: "undecided" },
};

function checkView(context: PanelContext, check: Check, step: number): View {
  const { sign, says } = SIGNS[check.state] ?? SIGNS["open"]!;
  return h(`li.check.${sign}${check.state === "true" ? ".is-passed" : ""}`, { key: check.name, attributes: { title: check.expected } }, icon(sign), h("span.hidden", null, `${says}: `),
    h("span.text", null, h("b", null, check.name), check.state === "false" && check.was !== "" && h("span.was", null, check.was)),
    (check.state === "true" || check.state === "false") && check.tick > 0 && button(clock(check.tick * step), () => context.run.ask("seek", { tick: check.tick }), { attributes: { title: "Go to that moment" } }, "button.link.time"));
}

/** How many of the checks that count are passed. */
export function passedOf(mission: Mission): { passed: number; of: number } {
  const counted = mission.checks.filter((one) => !one.is_marker);
  return { passed: counted.filter((one) => one.state === "true").length, of: counted.length };
}

/** A line of a grade without the command that shows the run in a window. */
export function gradeText(line: string): string {
  return line.replace(/: soarbox run .*$/, "");
}

/** The text of the grade that was last scrolled to. */
let shownGrade = "";

/** A new grade comes into view by itself; later patches leave the reader where they are. */
function showGrade(element: HTMLElement, text: string): void {
  if (text === shownGrade) return;
  shownGrade = text;
  element.scrollIntoView({ block: "start" });
}

/** Progress while the rules are graded; then the headline, and below it what led to it. */
function gradeView(context: PanelContext, lesson: Lesson, isWatching: boolean): Child {
  if (!lesson.is_graded && lesson.grade.length === 0) return false;
  const text = lesson.grade.map(gradeText), [headline = "", ...rest] = text;
  return h("section.grade", { key: "grade", attributes: { "aria-live": "polite" }, mounted: (element) => showGrade(element, lesson.is_graded ? "grading" : text.join("\n")) }, h("h3", null, "Grade"),
    lesson.is_graded
      ? h("div.row", null, h("span", null, headline === "" ? "Grading …" : `Grading: ${headline}`), !isWatching && button("Cancel", () => context.run.ask("lesson", { what: "cancel" }), { attributes: { title: "Stop grading. There is no verdict then." } }))
      : [h("p.headline", null, headline), rest.map((one) => h("p", null, one))]);
}

function lessonView(context: PanelContext, lesson: Lesson): Child[] {
  const isWatching = context.run.hello?.may_edit === false;
  return [
    h("h2.title", null, lesson.title), gradeView(context, lesson, isWatching), lesson.is_passed && h("p.passed", null, icon("check"), "You have passed this lesson."),
    h("section", null, h("h3", null, "Idea"), h("p", null, lesson.idea)), h("section.task", null, h("h3", null, "Task"), h("p", null, lesson.task)),
    lesson.new_panels.length > 0 && h("p.quiet", null, "New here: ", lesson.new_panels.map((word, i) => [i > 0 && ", ", button(context.titleOf(word), () => context.reveal(word), { attributes: { title: "Show this panel" } }, "button.link")])),
    !isWatching && h("div.row.actions", null,
      button(lesson.is_graded ? "Grading …" : "Grade", () => context.run.ask("lesson", { what: "grade" }), { attributes: { disabled: lesson.is_graded, title: "Runs your rules with ten seeds and says what came of it" } }, "button.primary"),
      lesson.hint_count > 0 && button(lesson.hints.length >= lesson.hint_count ? "No more hints" : `Hint ${lesson.hints.length + 1} of ${lesson.hint_count}`, () => context.run.ask("lesson", { what: "hint" }), { attributes: { disabled: lesson.hints.length >= lesson.hint_count } }),
      lesson.next !== "" && button("Next lesson", () => context.openWhat(`lesson:${lesson.next}`), {}, lesson.is_passed ? "button.primary" : "button")),
    lesson.hints.length > 0 && h("section", { attributes: { "aria-live": "polite" } }, h("h3", null, "Hints"), h("ol.hints", null, lesson.hints.map((one) => h("li", null, one)))),
  ];
}

/** The learner's panel: task, checks that tick off, hints, grade, what comes next. */
export const missionPanel: MakePanel = (context) => ({
  word: "mission", title: "Task", about: "What agents are to do: checks that tick off as they come true.", uses: ["mission", "moment"],
  badge: (contents) => {
    if (contents.mission === undefined || contents.mission.checks.length === 0) return "";
    const { passed, of } = passedOf(contents.mission);
    return `${passed}/${of}`;
  },
  view: (contents) => {
    const mission = contents.mission, step = contents.moment?.time.step_s ?? 1 / 30;
    if (mission === undefined) return empty("The task and its checks come when the world runs.");
    const { passed, of } = passedOf(mission), counted = mission.checks.filter((one) => !one.is_marker);
    if (mission.lesson === null && counted.length === 0) return empty("This world has no mission: nothing is checked. A scenario's file mission.toml says what its agents are to do.");
    return [
      mission.lesson !== null && lessonView(context, mission.lesson),
      h("section", null, h("div.row", null, h("h3", null, "Checks"), h("span.quiet", null, `${passed} of ${of}`), h("progress", { attributes: { max: Math.max(of, 1), value: passed, "aria-label": `${passed} of ${of} checks passed` } })),
        h("ul.checks", null, counted.map((one) => checkView(context, one, step))),
        mission.lesson !== null && h("p.quiet", null, "The checks follow this one run. The grade runs your rules from the beginning, with several seeds.")),
    ];
  },
});
