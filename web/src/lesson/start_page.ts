// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import { icon } from "../app/icons";
import { LOCAL_PLACE, type PlaceInfo } from "../app/api";
import { clock } from "../panels/parts";
import { nextLesson, nextThings, numberOf } from "./next_thing";
import { worldMap, type WorldMaps } from "./world_map";

export interface StartEvents {
  open(what: string): void;
  goOn(): void;
  download(): void;
  upload(file: File): void;
  downloadRecording(name: string): void;
}

export function sizeText(bytes: number): string {
  return bytes < 1000 ? `${bytes} bytes` : bytes < 1_000_000 ? `${Math.round(bytes / 1000)} kB` : `${(bytes / 1_000_000).toFixed(1)} MB`;
}

/** The title of a recording on the page: its world, its length, and when it was made. */
export function recordingText(one: PlaceInfo["recordings"][number], locale?: string): { title: string; about: string } {
  const when = one.when > 0 ? new Date(one.when * 1000).toLocaleString(locale, { dateStyle: "medium", timeStyle: "short" }) : "";
  if (one.world === undefined || one.world === "") return { title: one.name, about: [when, sizeText(one.bytes)].filter((part) => part !== "").join(", ") };
  return { title: one.world, about: [`${clock(one.seconds ?? 0)} long`, when, sizeText(one.bytes)].filter((part) => part !== "").join(", ") };
}

function lessonCard(one: PlaceInfo["lessons"][number], isNext: boolean, maps: WorldMaps, events: StartEvents): View {
  return h("li", { key: one.name }, button([
    h("span.number", { attributes: { "aria-hidden": "true" } }, one.is_passed ? icon("check") : numberOf(one.name)),
    h("span.words", null, h("b", null, one.title), h("span.quiet", null, one.is_passed ? "passed" : isNext ? "next" : "not passed yet")),
    h("span.space"), worldMap(maps[one.name]),
  ], () => events.open(`lesson:${one.name}`), {}, `button.card.lesson${one.is_passed ? ".passed" : ""}${isNext ? ".next" : ""}`));
}

/** The lessons of one course, with the number of passed ones. */
function courseSection(title: string, lessons: PlaceInfo["lessons"], next: string, maps: WorldMaps, events: StartEvents): View {
  const passed = lessons.filter((one) => one.is_passed).length, text = `${passed} of ${lessons.length} passed`;
  return h("section", { key: title, attributes: { "aria-label": title } }, h("div.row", null, h("h2", null, title), h("progress", { attributes: { max: lessons.length, value: passed, "aria-label": `${title}: ${text}` } }), h("span.quiet", null, text)),
    h("ol.cards", null, lessons.map((one) => lessonCard(one, one.name === next, maps, events))));
}

/** Titles of the program's courses; others keep their names. Lessons of `guide` have the guide's project numbers. */
const COURSES: Readonly<Record<string, string>> = { eaters: "Eaters", guide: "projects of the Engineers' Guide to Soar", tanks: "TankSoar" };

function titleOfCourse(course: string): string {
  return course === "" ? "Lessons" : `Lessons: ${COURSES[course] ?? course}`;
}

/** The start page: lessons with progress, worlds, recordings, and the user's files. */
export function startPage(info: PlaceInfo, filter: string, running: { what: string; title: string } | null, last: string, maps: WorldMaps, arena: Child, folders: Child, events: StartEvents, setFilter: (text: string) => void): Child {
  const things = nextThings(info, running, last), next = things.find((one) => one.what.startsWith("lesson:"))?.what.slice("lesson:".length) ?? nextLesson(info);
  const worlds = info.scenarios.filter((one) => `${one.name} ${one.about}`.toLowerCase().includes(filter.toLowerCase()));
  return h("main.start", null,
    h("section.welcome", null, h("div", null, h("h1", null, info.learner === "" ? "Learn Soar in a world that you can see" : `Welcome, ${info.learner}`),
      h("p", null, "Soar agents decide by rules. Change a rule, and watch what they do, why they do it, and why not."),
      h("div.row", null,
        things.map((one, i) => button(one.label, () => (one.goesOn ? events.goOn() : events.open(one.what)), { key: one.what }, i === 0 ? "button.primary.large" : "button.large"))))),
    [...new Set(info.lessons.map((one) => one.course ?? ""))].map((course) => courseSection(titleOfCourse(course), info.lessons.filter((one) => (one.course ?? "") === course), next, maps, events)),
    arena,
    info.scenarios.length > 0 && h("section", { attributes: { "aria-label": "Worlds" } }, h("div.row", null, h("h2", null, "Worlds"), h("input.filter", {
      value: filter, attributes: { type: "search", placeholder: "Search", "aria-label": "Search worlds", spellcheck: false }, on: { input: (event) => setFilter((event.target as HTMLInputElement).value) },
    })), worlds.length === 0 ? h("p.quiet", null, "No world has this text.") : h("ul.cards", null, worlds.map((one) => h("li", { key: one.name }, button([worldMap(maps[one.name]), h("span.words", null, h("b", null, one.name), h("span.quiet", null, one.about))], () => events.open(`scenario:${one.name}`), {}, "button.card"))))),
    folders,
    h("section.kept", { attributes: { "aria-label": "Your place" } }, h("h2", null, "Your place"),
      info.place === LOCAL_PLACE ? h("p.quiet", null, "Your files, lessons and recordings are kept by this browser, on this machine. Nothing is sent anywhere. Save them now and then: a browser deletes what a page keeps when its data is cleared.")
        : h("p.quiet", null, `Your files, lessons and recordings are kept under this page's link. Keep the link: everybody who has it can work here. ${info.kept_days > 0 ? `Nobody needs to log in; what is not used for ${info.kept_days} days is deleted.` : ""}`),
      info.recordings.length > 0 && h("ul.plain", null, [...info.recordings].sort((a, b) => b.when - a.when).map((one) => h("li.row", { key: one.name }, button(recordingText(one).title, () => events.open(`recording:${one.name}`), { attributes: { title: `Watch ${one.name}` } }, "button.link"), h("span.quiet", null, recordingText(one).about),
        button("Download", () => events.downloadRecording(one.name), { attributes: { "aria-label": `Download ${one.name}` } }, "button.small")))),
      h("div.row", null, button("Download my folder", events.download, { attributes: { title: "All your files as a zip" } }),
        h("label.button", null, "Upload a folder (zip)", h("input.hidden", { attributes: { type: "file", accept: ".zip,application/zip" }, on: { change: (event) => {
          const field = event.target as HTMLInputElement, file = field.files?.[0];
          if (file !== undefined) events.upload(file);
          field.value = "";
        } } })))));
}
