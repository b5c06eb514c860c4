// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import { cssColor, FOREIGN, kindColor, teamColor } from "../scene/looks";
import type { MakePanel } from "./panel";
import { empty, filterField, numberHead, passes, table } from "./parts";

/** Whether another simulation moves it. */
export function isForeign(agent: { readonly kind: string }): boolean {
  return agent.kind === FOREIGN;
}

export const agentsPanel: MakePanel = (context) => {
  let filter = "";
  return {
    word: "agents", title: "Agents", about: "Everybody in the world: team, state, operator, command. Click to select.", uses: ["agents", "moment"],
    view: (contents) => {
      const all = contents.agents?.agents ?? [], selected = contents.moment?.agent ?? "";
      if (all.length === 0) return empty("Nobody is in this world yet. Some worlds wait for a key: click the picture, and press what the world names in the panel Output.");
      const shown = all.filter((one) => passes(filter, `${one.name} ${one.team} ${one.kind} ${one.operator} ${one.command}`));
      return [
        all.length > 8 && filterField("Filter by text", filter, (text) => {
          filter = text;
          context.redraw("agents");
        }),
        table(["Name", "Doing", numberHead("Health")], shown.map((one) => h(`tr${one.name === selected ? ".chosen" : ""}`, { key: one.name, attributes: { "aria-selected": String(one.name === selected) } },
            h("td", null, button([h(`i.team${isForeign(one) ? ".foreign" : ""}`, { style: { [isForeign(one) ? "color" : "background"]: cssColor(one.team === "" ? kindColor(one.kind) : teamColor(one.team)) } }), one.name],
              () => context.run.ask("select", { agent: one.name }), { attributes: { "aria-pressed": String(one.name === selected), title: [one.name, one.team, isForeign(one) ? "foreign: another simulation moves it" : one.kind].filter((text) => text !== "").join(", ") } }, "button.link")),
            h("td", null, one.failed ? h("span.warn", null, "stopped by an error") : !one.alive ? "dead" : isForeign(one) ? "foreign" : one.operator !== "" ? one.operator : one.command !== "" ? one.command : one.mind ? h("span.quiet", null, "idle") : h("span.quiet", { attributes: { title: "A Lua script decides for it" } }, `script ${one.script}`), one.errors > 0 && h("span.warn", { attributes: { title: one.error ?? "" } }, ` ${one.errors} errors`)),
            h("td.number", null, Math.round(one.health)))), { what: "table.agents" }),
      ];
    },
  };
};
