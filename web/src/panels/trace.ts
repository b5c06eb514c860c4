// SPDX-License-Identifier: BSD-2-Clause
import { h } from "../dom/view";
import type { MakePanel } from "./panel";
import { empty, filterField, moment, passes, toggle } from "./parts";

const KINDS = ["error", "decision", "command", "event", "input", "percept", "rule", "element"] as const;
const MOST_SHOWN = 300;

export const tracePanel: MakePanel = (context) => {
  let filter = "", isChosen = false;
  const hidden = new Set<string>(["percept", "element"]);
  return {
    word: "trace", title: "Trace", about: "What the mind did, decision by decision; filter and search it.", uses: ["trace", "moment"],
    view: (contents) => {
      const agent = contents.moment?.agent ?? "", all = contents.trace?.lines ?? [];
      const found = all.filter((one) => (agent === "" || one.agent === "" || one.agent === agent) && passes(filter, one.text)), wanted = found.filter((one) => !hidden.has(one.kind));
      // In a quiet world there are only percepts among the newest lines: better those than nothing.
      const shown = (wanted.length === 0 && !isChosen ? found : wanted).slice(-MOST_SHOWN).reverse();
      return [
        h("div.row", null, filterField("Filter by text", filter, (text) => {
          filter = text;
          context.redraw("trace");
        }), KINDS.map((kind) => toggle(kind, !hidden.has(kind), () => {
          isChosen = true;
          if (!hidden.delete(kind)) hidden.add(kind);
          context.redraw("trace");
        }))),
        shown.length === 0 ? empty(found.length === 0 ? "Decisions, commands and events come here as they happen, the newest first." : "All of the newest lines are of kinds that are switched off above.")
          : h("ol.lines", null, shown.map((one) => h(`li.${one.kind}`, null, moment(context, one.tick, one.time_s), h("span.kind", null, one.kind), h("span.text", { style: { "--level": String(one.level ?? 1) } }, one.text)))),
      ];
    },
  };
};
