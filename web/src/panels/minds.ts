// SPDX-License-Identifier: BSD-2-Clause
import { h } from "../dom/view";
import type { MakePanel } from "./panel";
import { besideToggles, empty } from "./parts";
import { stackView } from "./mind";

export const mindsPanel: MakePanel = (context) => ({
  word: "minds", title: "Minds", about: "Several minds side by side: goal stack, operators, commands.", uses: ["minds", "moment"],
  view: (contents) => {
    const shown = contents.minds?.minds ?? [];
    return [
      h("div.row", null, besideToggles(context, (name) => shown.some((one) => one.agent === name))),
      shown.length === 0 ? empty("Choose agents above: their minds are shown side by side.")
        : h("div.columns", null, shown.map((one) => h("section", { key: one.agent }, h("h3", null, one.agent), one.note !== "" && h("p.quiet", null, one.note), stackView(one.stack, ""),
          one.operators.why !== "" && h("p", null, one.operators.why), one.command !== "" && h("p", null, "Command: ", h("b", null, one.command))))),
    ];
  },
});
