// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import type { MakePanel } from "./panel";
import { agentLink, empty, moment, toggle } from "./parts";

/** Texts that agents print, and optionally other events. */
export const outputPanel: MakePanel = (context) => {
  let hasNews = false;
  return {
    word: "output", title: "Output", about: "What agents print with write, and what happens to them.", uses: ["timeline", "moment"],
    view: (contents) => {
      const all = context.run.printed.lines, shown = all.filter((one) => one.isPrinted || hasNews).slice().reverse(), step = contents.moment?.time.step_s ?? 1 / 30;
      return [
        h("div.row", null, toggle("What happens to agents, too", hasNews, () => {
          hasNews = !hasNews;
          context.redraw("output");
        }), all.length > 0 && button("Clear", () => {
          context.run.printed.lines = [];
          context.redraw("output");
        }, {}, "button.small")),
        shown.length === 0 ? empty("Nothing has been printed yet. A rule prints with (write |some text|) after its -->; the text is shown here and over the agent's head.")
          : h("ol.lines.output", null, shown.map((one) => h("li", { key: `${one.tick}/${one.agent}/${one.text}` }, moment(context, one.tick, one.tick * step), agentLink(context, one.agent), h("span.text", null, one.text)))),
      ];
    },
  };
};
