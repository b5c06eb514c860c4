// SPDX-License-Identifier: BSD-2-Clause
import { h } from "../dom/view";
import type { MakePanel } from "./panel";
import { empty, filterField, moment, numberHead, short, table } from "./parts";

export const longtermPanel: MakePanel = (context) => {
  let search = "";
  return {
    word: "longterm", title: "Long-term memory", about: "What the agent knows and remembers, what it recalled and why.", uses: ["longterm", "moment"],
    view: (contents) => {
      const all = contents.longterm;
      if (all === undefined) return empty(contents.moment?.not_available || "Select an agent with a Soar mind: what it knows and remembers is shown here.");
      const { long_term: known, recalls, episode } = all, step = contents.moment?.time.step_s ?? 1 / 30;
      if (!known.semantic && !known.episodic) return empty("This agent's semantic and episodic memory are switched off. The commands smem --enable and epmem --enable switch them on.", known.note);
      return [
        h("p.quiet", null, `${known.objects} objects with ${known.augmentations} augmentations, ${known.episodes} episodes`), known.note !== undefined && h("p.quiet", null, known.note),
        filterField("Search what it knows", search, (text) => {
          search = text;
          context.run.ask("search-known", { text });
        }),
        recalls.length > 0 && h("section", null, h("h3", null, "Recalled"), h("ul.plain", null, recalls.slice(-30).reverse().map((one) => h("li", null,
          moment(context, one.tick, one.tick * step), ` ${one.memory}: ${one.question} → ${one.answer}`, h("div.quiet", null, one.reason))))),
        known.known.length > 0 && table(["Object", numberHead("Activation"), numberHead("Uses")], known.known.map((one) => h("tr", { key: String(one.number) }, h("td", null, h("code", null, one.text)), h("td.number", null, short(one.activation)), h("td.number", null, one.uses))), { caption: "What it knows, the most active first" }),
        known.episodes > 0 && h("section", null, h("h3", null, "Episodes"), h("label.row", null, "Look at episode ", h("input.number", {
          attributes: { type: "number", min: 1, max: known.episodes, value: episode.episode > 0 ? episode.episode : "" },
          on: { change: (event) => context.run.ask("episode", { number: Math.max(0, Math.floor(Number((event.target as HTMLInputElement).value))) }) },
        }), ` of ${known.episodes}`), episode.episode > 0 && h("pre.source", null, episode.elements.join("\n"))),
      ];
    },
  };
};
