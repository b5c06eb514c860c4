// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import type { MakePanel } from "./panel";
import { empty, filterField, moment, passes } from "./parts";

const KINDS = ["error", "decision", "command", "event", "input", "percept", "rule", "element"] as const;
const MOST_SHOWN = 300;

export const tracePanel: MakePanel = (context) => {
  let filter = "";
  const hidden = new Set<string>(["percept", "element"]);
  return {
    word: "trace", title: "Trace", about: "What the mind did, decision by decision; filter and search it.", uses: ["trace", "moment"],
    view: (contents) => {
      const agent = contents.moment?.agent ?? "", all = contents.trace?.lines ?? [];
      const shown = all.filter((one) => !hidden.has(one.kind) && (agent === "" || one.agent === "" || one.agent === agent) && passes(filter, one.text)).slice(-MOST_SHOWN).reverse();
      return [
        h("div.row", null, filterField("Filter by text", filter, (text) => {
          filter = text;
          context.redraw("trace");
        }), KINDS.map((kind) => button(kind, () => {
          if (!hidden.delete(kind)) hidden.add(kind);
          context.redraw("trace");
        }, { attributes: { "aria-pressed": String(!hidden.has(kind)) } }, "button.small.toggle"))),
        shown.length === 0 ? empty("Decisions, commands and events come here as they happen, the newest first.")
          : h("ol.lines", null, shown.map((one) => h(`li.${one.kind}`, null, moment(context, one.tick, one.time_s), h("span.kind", null, one.kind), h("span.text", { style: { "--level": String(one.level ?? 1) } }, one.text)))),
      ];
    },
  };
};
