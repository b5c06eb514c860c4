// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import type { MakePanel } from "./panel";
import { besideToggles, empty, lineField, rowForm, table } from "./parts";

export const watchPanel: MakePanel = (context) => {
  let what = "";
  return {
    word: "watch", title: "Watch", about: "Values and Soar commands that you want to see at each decision, for several agents side by side.", uses: ["watch", "moment"],
    view: (contents) => {
      const all = contents.watch, agents = all?.agents ?? [], minds = context.run.hello?.minds ?? [];
      return [
        rowForm(() => {
          if (what.trim() === "" || !context.run.ask("watch", { what: what.trim(), is_on: true })) return;
          what = "";
          context.redraw("watch");
        }, lineField("What to watch", "S1.io.input-link.self.health, or a command", what, (text) => (what = text)), h("button", { attributes: { type: "submit" } }, "Watch")),
        minds.length > 1 && h("div.row", null, "Side by side: ", besideToggles(context, (name) => agents.includes(name))),
        (all?.rows ?? []).length === 0 ? empty("Type a value of working memory, such as S1.io.input-link.self.health, or a Soar command. It is read at each decision.")
          : table(["What", ...agents, h("td", null, "")], all!.rows.map((row) => h("tr", { key: row.what }, h("td", null, h("code", null, row.what)),
            row.cells.map((cell) => h(`td${cell.is_error ? ".warn" : cell.is_new ? ".added" : ""}`, null, h("pre", null, cell.text))), h("td", null, button("Remove", () => context.run.ask("watch", { what: row.what, is_on: false }), { attributes: { "aria-label": `Remove ${row.what}` } }, "button.small"))))),
      ];
    },
  };
};
