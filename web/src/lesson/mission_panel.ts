// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import { FLOWS } from "../app/flow_table";
import { icon } from "../app/icons";
import type { Check, Contents, Lesson, LessonOffer, Time } from "../run/contents";
import { infoOf, type MakePanel, type PanelContext } from "../panels/panel";
import { clock, empty } from "../panels/parts";
import { passedOf, standingOf, whyOpen, type Standing } from "./attempt";

const SIGNS: Readonly<Record<Standing, { sign: "check" | "cross" | "open"; says: string }>> = {
  passed: { sign: "check", says: "passed" }, failed: { sign: "cross", says: "failed" }, open: { sign: "open", says: "not decided yet" },
};
const OPEN: Readonly<Record<string, string>> = { untested: "nothing to test yet", undecided: "undecided" };

function checkView(context: PanelContext, check: Check, time: Time | undefined, step: number): View {
  const standing = standingOf(check, time, context.attempt), { sign, says } = SIGNS[standing];
  return h(`li.check.${sign}${standing === "passed" ? ".is-passed" : ""}`, { key: check.name, attributes: { title: check.expected } }, icon(sign), h("span.hidden", null, `${standing === "open" ? (OPEN[check.state] ?? says) : says}: `),
    h("span.text", null, h("b", null, check.name), standing === "failed" && check.was !== "" && h("span.was", null, check.was)),
    standing !== "open" && check.tick > 0 && button(clock(check.tick * step), () => context.run.ask("seek", { tick: check.tick }), { attributes: { title: "Go to that moment" } }, "button.link.time"));
}

/** A line of a grade without the command that shows the run in a window, and without the folders of the server. */
export function gradeText(line: string): string {
  return withoutFolders(line.replace(/: soarbox run .*$/, ""));
}

/** Files by their names alone, without the folders of the server. */
export function withoutFolders(text: string): string {
  return text.replace(/(^|[\s"'(])\/(?:[^\s:"'/]+\/)+([^\s:"'/]+)/g, "$1$2");
}

const GRADE_CHECK = /^\s*(yes|no)\s{2,}(.*)$/;
const PASSED = /^Passed with all/;

/** The contents of a grade: the headline, and the lines below it; lines about checks have a sign. */
export function gradeLines(grade: readonly string[]): { headline: string; isPass: boolean; lines: { sign: "" | "check" | "cross"; text: string }[] } {
  const [headline = "", ...rest] = grade.map(gradeText);
  const lines = rest.filter((one) => one.trim() !== "").map((text) => {
    const found = GRADE_CHECK.exec(text);
    return found === null ? { sign: "" as const, text: text.trimEnd() } : { sign: found[1] === "yes" ? ("check" as const) : ("cross" as const), text: found[2]! };
  });
  return { headline, isPass: PASSED.test(headline), lines };
}

function titleOf(name: string, lessons: readonly LessonOffer[]): string {
  return lessons.find((one) => one.name === name)?.title ?? name;
}

/** Shows progress during grading, then the headline and its reasons. A pass leads to the next lesson. */
function gradeView(context: PanelContext, lesson: Lesson, lessons: readonly LessonOffer[], isWatching: boolean, arrived: (element: HTMLElement, text: string) => void): Child {
  if (!lesson.is_graded && lesson.grade.length === 0) return false;
  const { headline, isPass, lines } = gradeLines(lesson.grade), text = lesson.is_graded ? "grading" : lesson.grade.join("\n"), show = (element: HTMLElement): void => arrived(element, text);
  const passed = lessons.filter((one) => one.is_passed).length;
  return h(`section.grade${lesson.is_graded ? "" : isPass ? ".pass" : ".fail"}`, { key: "grade", attributes: { "aria-live": "polite", tabindex: -1, "aria-label": "Grade" }, mounted: show, patched: show }, h("h3", null, "Grade"),
    lesson.is_graded
      ? h("div.row", null, h("span", null, headline === "" ? "Grading …" : `Grading: ${headline}`), !isWatching && button("Cancel", () => context.run.ask("lesson", { what: "cancel" }), { attributes: { title: "Stop grading. There is no verdict then." } }))
      : [
        isPass && h("p.praise", null, icon("check"), h("span", null, `You have passed “${lesson.title}”.`)),
        h("p.headline", null, headline),
        isPass && !isWatching && h("div.row", null, lesson.next !== "" ? button(`Next lesson: ${titleOf(lesson.next, lessons)}`, () => context.openWhat(`lesson:${lesson.next}`), {}, "button.primary.large") : button("That was the last lesson: see all", () => context.goHome(), {}, "button.primary"),
          lessons.length > 0 && h("span.quiet", null, `${passed} of ${lessons.length} lessons passed`)),
        lines.map((one) => h(`p${one.sign === "" ? "" : `.line.${one.sign}`}`, null, one.sign !== "" && [icon(one.sign), h("span.hidden", null, one.sign === "check" ? "yes: " : "no: ")], h("span", null, one.text))),
      ]);
}

/** The learner's present actions, at the lower edge of the panel; always visible. */
function actions(context: PanelContext, lesson: Lesson, isCelebrated: boolean): View {
  return h("div.row.actions", { key: "actions" },
    button(lesson.is_graded ? "Grading …" : "Grade", () => context.grade(), { attributes: { disabled: lesson.is_graded, title: "Runs your rules with ten seeds and reports the result" } }, "button.primary"),
    lesson.hint_count > 0 && button(lesson.hints.length >= lesson.hint_count ? "No more hints" : `Hint ${lesson.hints.length + 1} of ${lesson.hint_count}`, () => context.run.ask("lesson", { what: "hint" }), { attributes: { disabled: lesson.hints.length >= lesson.hint_count } }),
    lesson.next !== "" && !isCelebrated && button("Next lesson", () => context.openWhat(`lesson:${lesson.next}`)));
}

/** The learner's panel: task, checks that tick off, hints, grade, what comes next. */
export const missionPanel: MakePanel = (context) => {
  let lessonName = "", shownGrade = "", shownHints = 0;
  /** Scrolls to a new answer, and focuses it unless the user is typing. Later patches do not scroll. */
  const bring = (element: HTMLElement): void => {
    element.scrollIntoView({ block: "nearest" });
    if (element.getBoundingClientRect().height > (element.closest<HTMLElement>(".panel")?.clientHeight ?? Infinity)) element.scrollIntoView({ block: "start" });
    const now = document.activeElement;
    if (now === null || now === document.body || now.closest(".panel.mission") !== null) element.focus({ preventScroll: true });
  };
  const gradeArrived = (element: HTMLElement, text: string): void => {
    if (text === shownGrade) return;
    const isAnswer = text !== "grading" && shownGrade === "grading";
    shownGrade = text;
    if (text === "grading" || isAnswer) {
      context.reveal("mission");
      bring(element);
    }
  };
  const hintsArrived = (element: HTMLElement, count: number): void => {
    const isNew = count > shownHints && shownHints >= 0;
    shownHints = count;
    if (isNew) bring(element);
  };
  const lessonView = (lesson: Lesson, lessons: readonly LessonOffer[]): Child[] => {
    if (lesson.name !== lessonName) {
      lessonName = lesson.name;
      shownGrade = lesson.grade.join("\n");
      shownHints = lesson.hints.length;
    }
    const isWatching = context.run.hello?.may_edit === false;
    return [
      h("h2.title", null, lesson.title), gradeView(context, lesson, lessons, isWatching, gradeArrived), lesson.is_passed && h("p.passed", null, icon("check"), "You have passed this lesson."),
      lesson.hints.length > 0 && h("section.hint-box", { key: "hints", attributes: { "aria-live": "polite", tabindex: -1, "aria-label": "Hints" }, mounted: (element) => hintsArrived(element, lesson.hints.length), patched: (element) => hintsArrived(element, lesson.hints.length) },
        h("h3", null, "Hints"), h("ol.hints", null, lesson.hints.map((one) => h("li", null, one)))),
      h("section", null, h("h3", null, "Idea"), h("p", null, lesson.idea)), h("section.task", null, h("h3", null, "Task"), h("p", null, lesson.task)),
      lesson.new_panels.length > 0 && h("p.quiet", null, "New here: ", lesson.new_panels.map((word, i) => [i > 0 && ", ", button(context.titleOf(word), () => context.reveal(word), { attributes: { title: "Show this panel" } }, "button.link")])),
    ];
  };
  const checksView = (contents: Contents): View => {
    const mission = contents.mission!, time = contents.moment?.time, step = time?.step_s ?? 1 / 30, { passed, of } = passedOf(mission, time, context.attempt), why = whyOpen(time, context.attempt), mayAsk = context.run.hello?.may_edit !== false;
    const counted = mission.checks.filter((one) => !one.is_marker);
    return h("section", { key: "checks" }, h("div.row", null, h("h3", null, "Checks"), h("span.quiet", null, `${passed} of ${of}`), h("progress", { attributes: { max: Math.max(of, 1), value: passed, "aria-label": `${passed} of ${of} checks passed` } })),
      why !== "" && mayAsk && h("div.row.note", { attributes: { role: "status" } }, h("span", null, why), button(FLOWS["begin-again"].button, () => context.run.ask("flow", { what: "begin-again" }), {}, "button.small")),
      h("ul.checks", null, counted.map((one) => checkView(context, one, time, step))),
      mission.lesson !== null && [
        h("p.quiet", null, "The checks follow this one run. The grade runs your rules from the beginning, with several seeds."),
        mayAsk && h("label.choice", { attributes: { title: "A running world begins again when you apply rules, so that the checks follow your new rules" } }, h("input", { checked: context.attempt.restarts, attributes: { type: "checkbox" }, on: { change: (event) => {
          context.attempt.restarts = (event.target as HTMLInputElement).checked;
        } } }), `${FLOWS["begin-again"].button} with each Apply`),
      ]);
  };
  return {
    ...infoOf("mission"), uses: ["mission", "moment"],
    badge: (contents) => {
      if (contents.mission === undefined || contents.mission.checks.length === 0) return "";
      const { passed, of } = passedOf(contents.mission, contents.moment?.time, context.attempt);
      return `${passed}/${of}`;
    },
    view: (contents) => {
      const { mission } = contents;
      if (mission === undefined) return empty("The task and its checks come when the world runs.");
      if (mission.lesson === null && mission.checks.every((one) => one.is_marker)) return empty("Nothing is checked in this world. A scenario's file mission.toml can say what its agents are to do; worlds of Lua scripts alone are checked by soarbox test.");
      const { lesson } = mission, mayAsk = context.run.hello?.may_edit !== false;
      return [lesson === null && h("h2.hidden", { key: "heading" }, infoOf("mission").title), lesson !== null && lessonView(lesson, mission.lessons), checksView(contents), lesson !== null && mayAsk && actions(context, lesson, !lesson.is_graded && gradeLines(lesson.grade).isPass)];
    },
  };
};
