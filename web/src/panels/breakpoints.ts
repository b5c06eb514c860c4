// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import type { MakePanel } from "./panel";
import { clock, empty, lineField, rowForm } from "./parts";

const KINDS: readonly (readonly [string, string, string])[] = [
  ["fire", "a rule fires", "my*rule"], ["match", "a rule matches", "my*rule"], ["element", "an element appears", "S1 ^name *"],
  ["removed", "an element is removed", "^danger *"], ["number", "a number passes a limit", "^health < 20"], ["operator", "an operator is selected", "move"],
  ["impasse", "an impasse occurs", "tie"], ["command", "a command is given", "move-to"], ["failed", "a command fails", "move-to"],
  ["death", "an agent dies", ""], ["check", "a check is decided", "the check's name"], ["time", "the world comes to a time", "12.5 (seconds)"],
];

export const breakpointsPanel: MakePanel = (context) => {
  let kind = "fire", what = "", isAny = false;
  return {
    word: "breakpoints", title: "Breakpoints", about: "Stop the world when a rule fires, an impasse occurs, and so on.", uses: ["breakpoints", "moment"],
    badge: (contents) => (contents.breakpoints !== undefined && contents.breakpoints.hits.length > 0 ? String(contents.breakpoints.hits.length) : ""),
    view: (contents) => {
      const all = contents.breakpoints, agent = contents.moment?.agent ?? "", step = contents.moment?.time.step_s ?? 1 / 30;
      return [
        rowForm(() => {
          context.run.ask("break", { kind, agent: isAny ? "" : agent, what: what.trim() === "" ? "*" : what.trim() });
        }, "Stop when ", h("select", { value: kind, attributes: { "aria-label": "What to wait for" }, on: { change: (event) => {
          kind = (event.target as HTMLSelectElement).value;
          context.redraw("breakpoints");
        } } }, KINDS.map(([word, title]) => h("option", { attributes: { value: word } }, title))),
        lineField("Which one", KINDS.find(([word]) => word === kind)?.[2] ?? "", what, (text) => (what = text)),
        h("label", null, h("input", { checked: isAny, attributes: { type: "checkbox" }, on: { change: (event) => (isAny = (event.target as HTMLInputElement).checked) } }), " in any mind"),
        h("button", { attributes: { type: "submit" } }, "Add")),
        (all?.hits ?? []).map((hit) => h("p.warn", null, `${clock(hit.tick * step)} ${hit.agent}: ${hit.why}`)),
        (all?.breakpoints ?? []).length === 0 ? empty("There are no breakpoints. Add one: the world stops when it is hit, and you can look around.")
          : h("table", null, h("tbody", null, all!.breakpoints.map((one) => h("tr", { key: String(one.number) },
            h("td", null, h("label", null, h("input", { checked: one.enabled, attributes: { type: "checkbox", "aria-label": "On" }, on: { change: () => context.run.ask("change-break", { number: one.number, what: one.enabled ? "disable" : "enable" }) } }))),
            h("td", null, `${one.kind} ${one.what}`), h("td", null, one.agent === "" ? "any mind" : one.agent), h("td.number", null, `${one.hits} hits`),
            h("td", null, button("Remove", () => context.run.ask("change-break", { number: one.number, what: "clear" }), {}, "button.small")))))),
      ];
    },
  };
};
