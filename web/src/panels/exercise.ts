// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import { cssColor, teamColor } from "../scene/looks";
import type { ForeignEntity } from "../run/contents";
import type { MakePanel } from "./panel";
import { empty, numberHead, short, table } from "./parts";

/** After so long nobody knows whether it is still there. */
const SILENT_S = 6;

export const exercisePanel: MakePanel = (context) => {
  const row = (one: ForeignEntity, selected: string) => {
    const name = one.agent !== "" ? one.agent : one.marking !== "" ? one.marking : one.id, about = `${one.team}, ${one.body}, type ${one.type}`;
    const shown = [h("i.team.foreign", { style: { color: cssColor(teamColor(one.team)) } }), name];
    return h(`tr${one.agent !== "" && one.agent === selected ? ".chosen" : ""}`, { key: one.id },
      h("td", null, one.agent === "" ? h("span.quiet", { attributes: { title: `${about}; it has no body here: it is too far away` } }, shown)
        : button(shown, () => context.run.ask("select", { agent: one.agent }), { attributes: { title: about, "aria-pressed": String(one.agent === selected) } }, "button.link")),
      h("td.quiet", null, one.id), h(`td.number${one.silent_s >= SILENT_S ? ".warn" : ""}`, null, one.silent_s === 0 ? "now" : `${one.silent_s} s ago`));
  };
  return {
    word: "exercise", title: "Exercise", about: "The exercise of other simulations that the run takes part in (DIS): who is there, what passes, what is dropped.", uses: ["exercise", "moment"],
    badge: (contents) => (contents.exercise?.exercise?.is_frozen === true ? "frozen" : ""),
    view: (contents) => {
      const now = contents.exercise?.exercise ?? null, selected = contents.moment?.agent ?? "";
      if (now === null) return empty("This run takes part in no exercise of other simulations.");
      const fact = (name: string, ...is: Parameters<typeof h>[2][]) => [h("dt", null, name), h("dd", null, ...is)];
      return [
        h("h3", null, `Exercise ${now.number}`),
        now.is_frozen && h("p.warn", { attributes: { role: "status" } }, "Frozen: the exercise's manager let the run stand still."),
        h("dl.facts", null,
          fact("Address", now.address, now.this_machine_only ? " (this machine only)" : h("span.warn", null, " (other machines hear it)")),
          fact("We are", `${now.as}${now.listens_only ? ", and only listen" : ""}${now.takes_orders ? ", and take orders" : ""}`),
          fact("Sent", `${now.sent} PDUs, ${short(now.sent_per_s)} per second`),
          now.not_sent > 0 && fact("Not sent", h("span.warn", null, String(now.not_sent))),
          fact("Received", `${now.received} PDUs, ${short(now.received_per_s)} per second`),
          fact("Dropped", now.dropped.length === 0 ? "nothing" : h("span.warn", null, now.dropped.map((one) => `${one.count} ${one.why}`).join(", ")))),
        h("h3", null, `${now.entity_count} ${now.entity_count === 1 ? "entity" : "entities"} of others`),
        now.entities.length < now.entity_count && h("p.quiet", null, `The first ${now.entities.length} of them:`),
        now.entities.length > 0 && table(["Name", "Id", numberHead("Heard")], now.entities.map((one) => row(one, selected))),
      ];
    },
  };
};
