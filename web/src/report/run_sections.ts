// SPDX-License-Identifier: BSD-2-Clause
import { icon } from "../app/icons";
import { button, h, patch, type Child, type View } from "../dom/view";
import { seconds } from "./chart";
import { wayOf, type CheckReport, type RunReport, type Way } from "./data";
import { mapFigure } from "./map";
import { legend, plotFigure, timelineFigure } from "./run_charts";
import { manifestOf, section } from "./section";
import { fold, table, type TableCell } from "./table";
import type { Time } from "./time";

const MARKS = { passed: { kind: "passed", sign: "check" }, failed: { kind: "failed", sign: "cross" }, moment: { kind: "open", sign: "follow" }, "over seeds": { kind: "open", sign: "open" } } as const;
const MOST_PLOTTED = 24;

/** A text that moves the run to its moment. */
function jump(time: Time, to: number, words: string): View {
  return button(words, () => {
    time.play(false);
    time.go(to);
  }, { attributes: { title: `Go to ${seconds(to)}` } }, "button.link");
}

function reasons(lines: readonly string[]): Child {
  return lines.length > 0 && h("details.why", null, h("summary", null, "Why"), h("pre.source", { attributes: { tabindex: 0 } }, lines.join("\n")));
}

function checks(run: RunReport, time: Time): Child {
  const row = (check: CheckReport): Child => {
    const { kind, sign } = MARKS[check.mark] ?? MARKS["over seeds"];
    return h(`li.check.${kind}`, null, icon(sign), h("div.text", null, h("span.mark", null, check.mark, ": "), jump(time, check.time, check.text), " ", h("span.quiet.time", null, check.time_text), reasons(check.reasons)));
  };
  return run.checks.length > 0 && section("checks", "Checks", h("ul.checks", null, run.checks.map(row)));
}

function moments(run: RunReport, time: Time): Child {
  return run.moments.length > 0 && section("moments", "Key moments", h("ul.plain.moments", null, run.moments.map((one) => h("li", null, h("span.quiet.time", null, one.time_text), h("div.text", null, jump(time, one.time, one.text), reasons(one.reasons))))));
}

function timeline(run: RunReport, time: Time): Child {
  const operators = (): TableCell[][] => run.spans.map(([agent, from, to, name]) => [run.agents[agent]!.name, name, jump(time, from, seconds(from)), seconds(to)]);
  const events = (): TableCell[][] => run.events.map((event) => [jump(time, event.t, seconds(event.t)), event.a, event.k, event.text]);
  return section("timeline", "Timeline", timelineFigure(run, time), run.thinned.map((told) => h("p.quiet", null, told)),
    fold("Operators as table", () => table(["agent", "operator", "from", "to"], operators(), "Operators")),
    fold("Events as table", () => table(["time", "agent", "kind", "what"], events(), "Events")));
}

function numbers(run: RunReport, ways: readonly (Way | null)[], time: Time): Child {
  const rows = run.agents.map((agent) => [agent.name, agent.team, agent.distance, agent.health, agent.damage, agent.rounds, agent.alive ? "yes" : "no"]);
  return section("numbers", "Numbers", h("div.even", null, plotFigure(run, ways, "speed", "Speed, m/s", time), plotFigure(run, ways, "health", "Health", time)), run.agents.length <= MOST_PLOTTED && legend(run),
    table(["agent", "team", "metres walked", "health", "health lost", "rounds", "alive"], rows, "Each agent at the end"));
}

/** With a run in 3D, only for paper: its panels have them. */
function messages(run: RunReport, time: Time, hasScene: boolean): Child {
  const said = run.events.filter((event) => event.k === "message" || event.k === "print");
  const all = (): Child => table(["time", "agent", "what"], said.map((event) => [jump(time, event.t, seconds(event.t)), event.a, event.text]), "What agents said and printed");
  const onPaper = (place: HTMLElement): void => addEventListener("beforeprint", () => patch(place, [all()]), { once: true });
  return said.length > 0 && section("messages", "Messages", hasScene ? h("div", { foreign: true, mounted: onPaper }) : all());
}

function rules(run: RunReport): Child {
  const rows = run.agents.flatMap((agent) => agent.rules.map((rule) => [agent.name, rule.name, rule.firings, rule.firings > 0 ? "" : `never fired${rule.stops === undefined ? "" : `; stops at ${rule.stops}`}`, rule.file ?? ""]));
  return rows.length > 0 && section("rules", "Rules", table(["agent", "rule", "fired", "why never", "where"], rows, "What each agent's rules did"));
}

function files(run: RunReport): Child {
  return run.files.length > 0 && section("files", "Files", run.files.map((file) => fold(file.name, () => h("pre.source", { attributes: { tabindex: 0, "aria-label": file.name } }, file.text))));
}

function about(run: RunReport): Child {
  const lines = [`Scenario ${run.scenario}, seed ${run.seed}, ${seconds(run.seconds)}, build ${run.build}.`,
    run.same ? "The run was simulated again for this page and reached the recorded state." : "The run was simulated again for this page and did NOT reach the recorded state: files or the program have changed.", ...run.warnings];
  return section("about", "About", lines.map((words) => h(`p.quiet${words.includes(" NOT ") ? ".warn" : ""}`, null, words)), manifestOf(run));
}

/** The sections about a run, below its 3D view if it has one. */
export function runSections(run: RunReport, time: Time, hasScene: boolean): Child {
  const ways = run.agents.map(wayOf), lists = [checks(run, time), moments(run, time)].filter((one) => one !== false);
  return [
    h(`div${lists.length > 0 ? ".two" : ""}`, null, lists.length > 0 && h("div", null, lists), section("map", "Map", mapFigure(run, ways, time))),
    timeline(run, time), numbers(run, ways, time), messages(run, time, hasScene), rules(run), files(run), about(run),
  ];
}
