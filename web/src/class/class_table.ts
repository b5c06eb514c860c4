// SPDX-License-Identifier: BSD-2-Clause
import { button, h, patch, type Child, type View } from "../dom/view";
import type { Api, ArenaInfo, ClassInfo, Learner, ScoreInfo } from "../app/api";
import { icon } from "../app/icons";
import { isDark, switchTheme } from "../app/theme";
import { arenaView } from "./arena_view";

const EVERY_MS = 5000;

/** A learner's progress in a lesson, in a few words. */
export function standing(learner: Learner, lesson: string): { text: string; says: string; kind: "done" | "begun" | "none" } {
  const done = learner.done[lesson];
  if (done === undefined) return { text: "", says: "not begun", kind: "none" };
  const tries = done.tries ?? 0, hints = done.hints ?? 0, of = done.of ?? 0, passed = done.passed ?? 0;
  const says = [done.is_done ? "passed" : "not passed", of > 0 ? `${passed} of ${of} checks` : "", tries === 1 ? "1 try" : `${tries} tries`, hints === 1 ? "1 hint" : `${hints} hints`].filter((one) => one !== "").join(", ");
  if (done.is_done) return { text: "✓", says, kind: "done" };
  if (tries === 0 && hints === 0 && passed === 0) return { text: "", says: "not begun", kind: "none" };
  return { text: of > 0 ? `${passed}/${of}` : tries === 0 ? "·" : `${tries}×`, says, kind: "begun" };
}

/** A duration: "40 s", "4 min", "2 h". */
export function duration(seconds: number): string {
  if (seconds < 90) return `${Math.round(seconds)} s`;
  return seconds < 5400 ? `${Math.round(seconds / 60)} min` : `${Math.round(seconds / 3600)} h`;
}

/** The learner's present state and its cause. */
export function now(learner: Learner, titleOf: (lesson: string) => string): { what: string; state: string; isStuck: boolean } {
  const doing = learner.doing ?? "", name = doing.replace(/^\w+:/, ""), what = doing.startsWith("lesson:") ? titleOf(name) : doing.startsWith("match:") ? "a replay of the arena" : name;
  const { standing: kind = "works", trouble = "", lasts_s: lasts = 0 } = learner;
  if (kind === "stuck") return { what, state: `Stuck for ${duration(lasts)}: ${trouble}`, isStuck: true };
  if (kind === "mistake") return { what, state: `${trouble} (for ${duration(lasts)})`, isStuck: false };
  if (kind === "idle") return { what, state: `Nothing done for ${duration(lasts)}`, isStuck: false };
  return { what, state: "", isStuck: false };
}

/** The state of scores for a learning platform; empty: all were sent, or there are none. */
export function scoreText(scores: ScoreInfo | undefined): string {
  if (scores === undefined || scores.waiting + scores.refused === 0) return "";
  const counts = [scores.waiting > 0 ? `${scores.waiting} not sent yet` : "", scores.refused > 0 ? `${scores.refused} refused` : ""].filter((one) => one !== "").join(", ");
  return `Scores for your learning platform: ${counts}.${scores.trouble === "" ? "" : ` ${scores.trouble}.`}`;
}

interface Course { name: string; title: string; lessons: ClassInfo["lessons"] }

/** Lessons by course, in their order. */
export function coursesOf(info: ClassInfo): Course[] {
  const names = [...new Set(info.lessons.map((one) => one.course ?? ""))];
  return names.map((name) => ({ name, title: name === "" ? "Lessons" : name[0]!.toUpperCase() + name.slice(1), lessons: info.lessons.filter((one) => (one.course ?? "") === name) }));
}

/** The teacher's page: learners by courses that unfold into lessons, messages, and the arena. */
export class ClassTable {
  private readonly element = document.createElement("div");
  private info: ClassInfo | null = null;
  private arena: ArenaInfo | null = null;
  private trouble = "";
  private told = "";
  private readonly open = new Set<string>();
  /** Receiver of the message that is being written: a place, "all", or none. */
  private writesTo = "";
  private message = "";
  private seeds = 3;

  constructor(root: HTMLElement, private readonly api: Api, private readonly key: string) {
    this.element.className = "class-page";
    root.replaceChildren(this.element);
    addEventListener("soarbox-theme", () => this.draw());
    void this.load();
  }

  private get path(): string {
    return `/api/class/${encodeURIComponent(this.key)}`;
  }

  private async load(): Promise<void> {
    try {
      [this.info, this.arena] = await Promise.all([this.api.json<ClassInfo>(this.path), this.api.json<ArenaInfo>(`${this.path}/arena`)]);
      this.trouble = "";
    } catch (error) {
      this.fail(error);
    }
    this.draw();
    setTimeout(() => void this.load(), EVERY_MS);
  }

  private fail(error: unknown): void {
    const told = error as { message: string; hint?: string };
    this.trouble = [told.message, told.hint ?? ""].join(" ").trim();
    this.draw();
  }

  /** Posts a request, shows its result, and updates the table. */
  private post(path: string, body: unknown, said: string): void {
    void this.api.json<unknown>(this.path + path, { method: "POST", body: JSON.stringify(body), headers: { "Content-Type": "application/json" } }).then(async () => {
      [this.info, this.arena] = await Promise.all([this.api.json<ClassInfo>(this.path), this.api.json<ArenaInfo>(`${this.path}/arena`)]);
      this.told = said;
      this.trouble = "";
      this.draw();
    }).catch((error: unknown) => this.fail(error));
  }

  private download(ending: string, name: string): void {
    void this.api.download(this.path + ending, name).catch((error: unknown) => this.fail(error));
  }

  private draw(): void {
    document.title = "Class - Soarbox";
    patch(this.element, [
      h("header.head", null, h("span.brand", null, "Soarbox"), h("h1.run-title", null, "Your class"), h("span.space"),
        button("Write to all", () => this.write("all")),
        button("Table as CSV", () => this.download(".csv", "class.csv"), { attributes: { title: "A row for each learner, a column for each lesson" } }),
        button("Long form", () => this.download("-long.csv", "class-long.csv"), { attributes: { title: "CSV with a row for each learner and lesson: passed, tries, hints" } }),
        button(icon("sun"), switchTheme, { attributes: { "aria-label": isDark() ? "Light colours" : "Dark colours" } }, "button.tool")),
      this.trouble !== "" && h("p.warn.trouble", { attributes: { role: "alert" } }, this.trouble),
      h("p.good.trouble", { attributes: { role: "status" } }, this.told),
      scoreText(this.info?.scores) !== "" && h("p.warn.trouble", { attributes: { role: "status" } }, scoreText(this.info?.scores)),
      this.writesTo !== "" && this.writer(),
      h("main", { attributes: { tabindex: 0, "aria-label": "Learners by lessons" } }, this.table(),
        this.arena !== null && this.info !== null && this.info.learners.length > 0 && arenaView(this.arena, this.seeds, (seeds) => {
          this.seeds = seeds;
          this.draw();
        }, { play: (game, seeds) => this.post(`/arena/${game}`, { seeds }, "The tournament is being played."), replay: (match) => void window.open(`/#match=${match}`, "_blank") })),
    ]);
  }

  private write(to: string): void {
    this.writesTo = this.writesTo === to ? "" : to;
    this.told = "";
    this.draw();
  }

  private writer(): View {
    const name = this.info?.learners.find((one) => one.place === this.writesTo)?.name ?? "all";
    const send = (): void => {
      const to = this.writesTo === "all" ? "" : this.writesTo;
      this.post("/message", { to, text: this.message }, `Sent to ${name}.`);
      this.writesTo = this.message = "";
      this.draw();
    };
    return h("form.row.writer", { key: "writer", on: { submit: (event) => {
      event.preventDefault();
      send();
    } } }, h("label.row", null, `Message to ${name}`, h("input", { value: this.message, attributes: { type: "text", maxlength: 500, autocomplete: "off" }, mounted: (element) => element.focus(), on: { input: (event) => (this.message = (event.target as HTMLInputElement).value) } })),
      h("button.primary", { attributes: { type: "submit" } }, "Send"), button("Cancel", () => this.write(this.writesTo)));
  }

  private table(): Child {
    const info = this.info;
    if (info === null) return this.trouble === "" && h("div.empty", null, h("p", null, "The table is loaded …"));
    if (info.learners.length === 0) return h("div.empty", null, h("p", null, "Nobody is here yet. Learners of a learning platform appear when they open a lesson from the course. A class of your own has a file with one name on each line: soarbox serve --class."));
    const courses = coursesOf(info);
    return h("table.class", null, h("thead", null, h("tr", null, h("th", { attributes: { scope: "col" } }, "Learner"), h("th.now", { attributes: { scope: "col" } }, "Now"), courses.map((one) => this.headings(one)))),
      h("tbody", null, info.learners.map((learner) => this.row(learner, courses))));
  }

  private headings(course: Course): Child {
    const isOpen = this.open.has(course.name);
    const fold = button(`${isOpen ? "▾" : "▸"} ${course.title}`, () => {
      isOpen ? this.open.delete(course.name) : this.open.add(course.name);
      this.draw();
    }, { attributes: { "aria-expanded": isOpen, title: isOpen ? "Fold the lessons of this course" : "Show each lesson of this course" } }, "button.link");
    return [h("th.number", { key: `course ${course.name}`, attributes: { scope: "col" } }, fold), isOpen && course.lessons.map((one) => h("th.lesson", { key: one.name, attributes: { scope: "col", title: one.title } }, h("span", null, one.title)))];
  }

  private row(learner: Learner, courses: readonly Course[]): View {
    const titleOf = (name: string): string => this.info?.lessons.find((one) => one.name === name)?.title ?? name;
    const { what, state, isStuck } = now(learner, titleOf), hand = learner.hand_s ?? null, unread = (learner.notes ?? []).filter((one) => !one.is_read).length;
    return h(`tr${hand !== null ? ".hand" : ""}${isStuck ? ".stuck" : ""}`, { key: learner.place_link },
      h("th", { attributes: { scope: "row" } }, h(`i.here${learner.is_here ? ".yes" : ""}`, { attributes: { title: learner.is_here ? "is here now" : "is not here" } }), h("span.hidden", null, learner.is_here ? "here: " : "not here: "), learner.name,
        hand !== null && h("div.raised", null, button(`Hand up: ${duration(hand)}`, () => this.post("/hand", { place: learner.place }, `The hand of ${learner.name} is down.`), { attributes: { title: "The hand is up. Click when you have helped.", "aria-label": `${learner.name} has raised a hand for ${duration(hand)}. Take it down` } }, "button.small")),
        h("div.do", null, h("a", { attributes: { href: this.here(learner.watch_link) } }, "Watch"), " ", button("Message", () => this.write(learner.place), { attributes: { "aria-label": `Message to ${learner.name}`, title: unread > 0 ? `${unread} not read yet` : "Write to this learner" } }, "button.link"), " ",
        h("a", { attributes: { href: this.here(learner.place_link), title: "The learner's own link, with all rights" } }, "Their link"))),
      h("td.now", null, what !== "" && h("div", null, what), state !== "" && h(`div.state${isStuck ? ".warn" : ".quiet"}`, null, state), learner.last_hint !== undefined && learner.last_hint !== "" && h("details.quiet", null, h("summary", null, "last hint"), learner.last_hint)),
      courses.map((course) => {
        const done = course.lessons.filter((one) => learner.done[one.name]?.is_done === true).length;
        return [
          h("td.number", { key: `course ${course.name}`, attributes: { title: `${course.title}: ${done} of ${course.lessons.length} passed` } }, `${done}/${course.lessons.length}`),
          this.open.has(course.name) && course.lessons.map((lesson) => {
            const { text, says, kind } = standing(learner, lesson.name);
            return h(`td.number.lesson.${kind}`, { key: lesson.name, attributes: { title: `${lesson.title}: ${says}` } }, text, h("span.hidden", null, ` ${says}`));
          })];
      }));
  }

  /** Accepts only links to this server. */
  private here(link: string): string {
    return link.startsWith("/") && !link.startsWith("//") ? link : "#";
  }
}
