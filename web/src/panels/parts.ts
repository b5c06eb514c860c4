// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { Contents } from "../run/contents";
import type { PanelContext } from "./panel";

/** Parts that several panels share. */

/** A note in an empty panel: what it will show. */
export function empty(text: string, ...more: Child[]): View {
  return h("div.empty", null, h("p", null, text), more);
}

/** Why a panel about a mind has nothing to show, and what to do; `otherwise`: the text in all other cases. */
export function noMind(context: PanelContext, contents: Contents, otherwise: string): View {
  const { hello } = context.run, agent = contents.moment?.agent ?? "";
  if (hello !== null && hello.minds.length === 0 && hello.agents.length === 0)
    return empty("Nobody is in this world yet. Some worlds wait for a key: click the picture, and press what the world names in the panel Output.");
  if (hello !== null && hello.minds.length === 0)
    return empty("No agent of this world has a Soar mind: Lua scripts decide for them. Read the scripts in the panel Edit, and watch what happens in Timeline and Trace.");
  if (agent === "") return empty(otherwise);
  if (hello !== null && !hello.minds.includes(agent) && contents.moment?.has_mind === false)
    return empty(`${agent} has no Soar mind: a script decides for it. Select one of those who have one:`, h("div.row", null, hello.minds.slice(0, 12).map((one) => button(one, () => context.run.ask("select", { agent: one }), { key: one }, "button.small"))));
  return empty(contents.moment?.not_available || otherwise);
}

/** 12.3 s as "0:12.30"; hours are minutes. */
export function clock(seconds: number): string {
  const hundredths = Math.round(Math.max(0, seconds) * 100), minutes = Math.floor(hundredths / 6000), rest = hundredths % 6000;
  return `${minutes}:${String(Math.floor(rest / 100)).padStart(2, "0")}.${String(rest % 100).padStart(2, "0")}`;
}

/** A number with at most three digits after the decimal point. */
export function short(value: number): string {
  return Number.isFinite(value) ? String(Math.round(value * 1000) / 1000) : "?";
}

/** A time, as a button that goes to that moment. */
export function moment(context: PanelContext, tick: number, seconds: number): View {
  return button(clock(seconds), () => context.run.ask("seek", { tick }), { attributes: { title: `Go to tick ${tick}` } }, "button.link.time");
}

export function agentLink(context: PanelContext, name: string): View {
  return button(name === "" ? "world" : name, () => context.run.ask("select", { agent: name }), {}, "button.link");
}

/** A table with a head for each column. */
export function table(heads: readonly (string | View)[], rows: Child, { caption, what = "table" }: { caption?: string; what?: string } = {}): View {
  return h(what, null, caption !== undefined && h("caption", null, caption),
    h("thead", null, h("tr", null, heads.map((head) => (typeof head === "string" ? h("th", { attributes: { scope: "col" } }, head) : head)))), h("tbody", null, rows));
}

/** A button that is on or off. */
export function toggle(label: Child, isOn: boolean, press: () => void, title?: string): View {
  return button(label, press, { attributes: { "aria-pressed": String(isOn), title } }, "button.small.toggle");
}

/** A field that filters as one types. */
export function filterField(label: string, value: string, changed: (text: string) => void): View {
  return h("input.filter", {
    value, attributes: { type: "search", placeholder: label, "aria-label": label, spellcheck: "false", autocomplete: "off" },
    on: { input: (event) => changed((event.target as HTMLInputElement).value) },
  });
}

/** Whether a text contains all words of a filter. */
export function passes(filter: string, text: string): boolean {
  const lower = text.toLowerCase();
  return filter.toLowerCase().split(/\s+/).every((word) => lower.includes(word));
}
