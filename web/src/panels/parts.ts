// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { Contents, Element, Maker, MemoryRow } from "../run/contents";
import type { PanelContext } from "./panel";

/** What several panels show in the same way. */

/** Says what would fill an empty panel. */
export function empty(text: string, ...more: Child[]): View {
  return h("div.empty", null, h("p", null, text), more);
}

/** Whether the selected agent, or everybody in this world, has no Soar mind. */
export function lacksMind(context: PanelContext, { moment }: Contents): boolean {
  const { hello } = context.run;
  return hello !== null && moment !== undefined && !moment.has_mind && !hello.minds.includes(moment.agent);
}

/** Why a panel about a mind has nothing to show, and what to do; `otherwise`: if it is none of that. */
export function noMind(context: PanelContext, contents: Contents, otherwise: string): View {
  const { hello } = context.run, agent = contents.moment?.agent ?? "";
  if (hello !== null && hello.minds.length === 0 && (contents.agents?.agents ?? hello.agents).length === 0)
    return empty("Nobody is in this world yet. Some worlds wait for a key: click the picture, and press what the world names in the panel Output.");
  if (hello !== null && hello.minds.length === 0)
    return empty("No agent of this world has a Soar mind: Lua scripts decide for them. Read the scripts in the panel Rules' text, and watch what happens in Timeline and Trace.");
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

/** A number with at most three digits behind the point. */
export function short(value: number): string {
  return Number.isFinite(value) ? String(Math.round(value * 1000) / 1000) : "?";
}

export function elementText(element: Element): string {
  return `(${element.id} ^${element.attribute} ${element.value}${element.acceptable === true ? " +" : ""})`;
}

/** A time that goes to that moment when it is pressed. */
export function moment(context: PanelContext, tick: number, seconds: number): View {
  return button(clock(seconds), () => context.run.ask("seek", { tick }), { attributes: { title: `Go to tick ${tick}` } }, "button.link.time");
}

export function ruleLink(context: PanelContext, name: string): View {
  return button(name, () => {
    context.run.ask("rule", { rule: name });
    context.reveal("rules");
  }, { attributes: { title: "Look at this rule" } }, "button.link.rule");
}

export function elementLink(context: PanelContext, element: Element): View {
  return button(elementText(element), () => {
    context.run.ask("element", { timetag: element.timetag });
    context.reveal("memory");
  }, { attributes: { title: "Who made it, and who tests it" } }, "button.link.element");
}

export function agentLink(context: PanelContext, name: string): View {
  return button(name === "" ? "world" : name, () => context.run.ask("select", { agent: name }), {}, "button.link");
}

export function makerView(context: PanelContext, maker: Maker): View {
  if (maker.kind === "input") return h("div.quiet", null, "comes from the input link: the agent perceives it");
  if (maker.kind !== "rule") return h("div.quiet", null, "made by Soar itself");
  return h("div", null, "made by ", ruleLink(context, maker.rule ?? ""), h("span.quiet", null, maker.support === "o" ? ", stays until it is removed" : ", goes when its reasons go"),
    (maker.elements ?? []).length > 0 && h("ul.plain", null, (maker.elements ?? []).map((one) => h("li", null, elementLink(context, one)))));
}

/** The head of a column of numbers. */
export function numberHead(name: string): View {
  return h("th.number", { attributes: { scope: "col" } }, name);
}

/** A table with a head for each column. */
export function table(heads: readonly (string | View)[], rows: Child, { caption, what = "table" }: { caption?: string; what?: string } = {}): View {
  return h(what, null, caption !== undefined && h("caption", null, caption),
    h("thead", null, h("tr", null, heads.map((head) => (typeof head === "string" ? h("th", { attributes: { scope: "col" } }, head) : head)))), h("tbody", null, rows));
}

/** What somebody looks at in full, over a panel's list, with a button that closes it. */
export function story(title: string, name: string, close: () => void, tools: Child, ...more: Child[]): View {
  return h("section.story", null, h("div.row", null, h("h3", null, title), tools, button("Close", close, { attributes: { "aria-label": `Close the ${name}` } }, "button.small")), more);
}

/** An element of an object: what changed is marked; a press tells who made it. */
export function elementRow(row: MemoryRow, press: () => void): Child {
  return [row.change !== undefined && h("span.sign", { attributes: { title: row.change } }, row.change === "added" ? "+" : "−"),
    button([h("span.attribute", null, `^${row.attribute}`), " ", h("span.value", null, row.value), row.acceptable === true && " +"], press, { attributes: { title: "Who made it, and who tests it" } }, "button.link"),
    row.about !== undefined && h("span.quiet", null, ` ${row.about}`)];
}

/** A button that is on or off. */
export function toggle(label: Child, isOn: boolean, press: () => void, title?: string): View {
  return button(label, press, { attributes: { "aria-pressed": String(isOn), title } }, "button.small.toggle");
}

/** Which minds are shown side by side. */
export function besideToggles(context: PanelContext, isOn: (agent: string) => boolean): View[] {
  return (context.run.hello?.minds ?? []).map((agent) => toggle(agent, isOn(agent), () => context.run.ask("beside", { agent, is_on: !isOn(agent) })));
}

/** A line that one types. */
export function lineField(label: string, placeholder: string, value: string, changed: (text: string) => void, list?: string): View {
  return h("input", {
    value, attributes: { type: "text", "aria-label": label, placeholder, list, spellcheck: "false", autocomplete: "off" },
    on: { input: (event) => changed((event.target as HTMLInputElement).value) },
  });
}

/** Fields in a row that are sent together: by a button, or by Enter. */
export function rowForm(send: () => void, ...fields: Child[]): View {
  return h("form.row", { on: { submit: (event) => {
    event.preventDefault();
    send();
  } } }, fields);
}

/** A field that filters as one types. */
export function filterField(label: string, value: string, changed: (text: string) => void): View {
  return h("input.filter", {
    value, attributes: { type: "search", placeholder: label, "aria-label": label, spellcheck: "false", autocomplete: "off" },
    on: { input: (event) => changed((event.target as HTMLInputElement).value) },
  });
}

/** Texts that fit all words of a filter. */
export function passes(filter: string, text: string): boolean {
  const lower = text.toLowerCase();
  return filter.toLowerCase().split(/\s+/).every((word) => lower.includes(word));
}
