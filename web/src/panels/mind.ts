// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { OperatorRow, Operators, ShownRow, Stack } from "../run/contents";
import type { MakePanel, PanelContext } from "./panel";
import { makerView, lacksMind, noMind, short } from "./parts";

const PHASES = ["input", "propose", "decide", "apply", "output"] as const;

export function stackView(stack: Stack, shownState: string, choose?: (state: string) => void): View {
  return h("ol.stack", null, stack.states.map((one) => {
    const text: Child[] = [
      h("b", null, one.state), one.impasse !== "" && h("span.warn", null, ` ${one.impasse}`),
      one.operator === "" ? h("span.quiet", null, " no operator") : h("span.good", null, ` ${one.name} (${one.operator})`),
    ];
    return h(`li${one.state === shownState ? ".chosen" : ""}`, { style: { "--level": String(one.level) } },
      choose === undefined ? text : button(text, () => choose(one.state), { attributes: { title: "Show the operators of this state" } }, "button.link"));
  }));
}

function operatorView(context: PanelContext, one: OperatorRow): View {
  return h(`details.operator${one.selected ? ".selected" : ""}`, { key: one.id }, h("summary", null,
    h("b", null, `${one.selected ? "✓ " : ""}${one.name}`), h("span.quiet", null, ` ${one.id}`), one.about !== undefined && ` ${one.about}`,
    h("span.verdict", null, one.verdict), one.value !== undefined && h("span.quiet", null, ` value ${short(one.value)}`),
    one.probability !== undefined && h("span.quiet", null, ` ${Math.round(one.probability * 100)} %`)),
    h("div.row", null, button("Why?", () => context.why("operator", one.name), { attributes: { "aria-label": `Why ${one.name}?` } }, "button.small")),
    h("ul.plain", null, one.preferences.map((preference) => h("li", null, h("code", null, preference.sign), ` ${preference.type}`,
      preference.referent !== undefined && ` ${preference.referent}`, makerView(context, preference.maker)))));
}

export function operatorsView(context: PanelContext, operators: Operators): Child[] {
  return [
    h("h3", null, `Operators of ${operators.state === "" ? "the lowest state" : operators.state}`),
    operators.why !== "" && h(`p.${operators.selected === "" ? "warn" : "good"}`, null, operators.why),
    operators.note !== undefined && h("p.quiet", null, operators.note),
    operators.operators.map((one) => operatorView(context, one)),
  ];
}

/** What the agent's script shows: each value with since when it holds, and the active path. */
export function shownView(rows: readonly ShownRow[]): Child[] {
  if (rows.length === 0) return [];
  return [h("h3", null, "State"), h("ol.stack", { attributes: { "aria-label": "State" } }, rows.map((row, place) =>
    h(`li${row.active ? ".chosen" : ""}`, { key: String(place), style: { "--level": String(row.depth + 1) }, attributes: { title: `since ${row.since.toFixed(2)} s` } },
      row.active ? h("b", null, row.name) : row.name, row.value !== "" && h("code", null, ` ${row.value}`))))];
}

export const mindPanel: MakePanel = (context) => ({
  word: "mind", title: "Mind", about: "The goal stack, the operators that compete in it, and why the winner won.", uses: ["mind", "moment"],
  view: (contents) => {
    const mind = contents.mind, moment = contents.moment, rows = mind?.shown?.rows ?? [];
    if (rows.length > 0 && moment !== undefined && !moment.has_mind) return shownView(rows);
    if (mind === undefined || lacksMind(context, contents) || (moment !== undefined && moment.agent === "")) return noMind(context, contents, moment?.agent === "" ? "Select an agent: click it in the picture or in the list of agents." : "The goal stack and the operators come when the world runs.");
    const stack = mind.stack, phase = stack.phase;
    return [
      ...shownView(rows),
      h("ol.phases", { attributes: { "aria-label": "Phases" } }, PHASES.map((name) => h(`li${phase === name ? ".now" : ""}`, { attributes: { "aria-current": phase === name ? "step" : undefined } }, name))),
      h("p.quiet", null, `decision ${stack.decisions}, ${stack.elements} elements, ${stack.rules} rules, ${stack.firings} firings`),
      stack.halted && h("p.warn", null, "The agent has halted."), stack.breakdown !== undefined && h("p.warn", null, stack.breakdown), stack.note !== undefined && h("p.quiet", null, stack.note),
      moment?.not_recorded !== undefined && moment.not_recorded !== "" && h("p.quiet", null, moment.not_recorded),
      h("h3", null, "Goal stack"),
      stackView(stack, mind.operators.state, (state) => context.run.ask("state", { state })),
      operatorsView(context, mind.operators),
    ];
  },
});
