// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { PanelContext } from "./panel";

/** Parts that several panels share. */

/** A note in an empty panel: what it will show. */
export function empty(text: string, ...more: Child[]): View {
  return h("div.empty", null, h("p", null, text), more);
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
    value, attributes: { type: "search", placeholder: label, "aria-label": label, spellcheck: false, autocomplete: "off" },
    on: { input: (event) => changed((event.target as HTMLInputElement).value) },
  });
}

/** Whether a text contains all words of a filter. */
export function passes(filter: string, text: string): boolean {
  const lower = text.toLowerCase();
  return filter.toLowerCase().split(/\s+/).every((word) => lower.includes(word));
}
