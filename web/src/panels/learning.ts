// SPDX-License-Identifier: BSD-2-Clause
import { button, h } from "../dom/view";
import type { MakePanel } from "./panel";
import { empty, moment, numberHead, short, story, table } from "./parts";
import { reasonView } from "./why";

export const learningPanel: MakePanel = (context) => ({
  word: "learning", title: "Learning", about: "Rules that the agent learned, with their reasons; values learned from reward.", uses: ["learning", "moment"],
  view: (contents) => {
    const all = contents.learning, step = contents.moment?.time.step_s ?? 1 / 30;
    if (all === undefined) return empty(contents.moment?.not_available || "Select an agent with a Soar mind: what it learned is shown here.");
    const { learning, rule, episodes } = all;
    if (learning.rules.length === 0 && learning.numbers.length === 0)
      return empty("This agent has learned nothing yet. Chunking makes rules of what substates find out; reward changes the numbers of preferences.", learning.note);
    const at = (tick: number): ReturnType<typeof moment> => moment(context, tick, tick * step);
    return [
      learning.note !== undefined && h("p.quiet", null, learning.note),
      rule.rule !== "" && story(rule.rule, "rule", () => context.run.ask("learned-rule", { rule: "" }), null,
        rule.fired.length > 0 && h("p", null, "Fired since: ", rule.fired.slice(-8).map((tick) => [at(tick), " "])), rule.note !== undefined && h("p.quiet", null, rule.note), reasonView(context, rule.why)),
      learning.rules.length > 0 && table(["Rule", "Learned", numberHead("Fired")], learning.rules.map((one) => h("tr", { key: one.rule }, h("td", null, button(one.rule, () => context.run.ask("learned-rule", { rule: one.rule }), {}, "button.link.rule"),
          one.purpose !== undefined && h("div.quiet", null, one.purpose), one.excised === true && h("span.warn", null, " removed")), h("td", null, one.tick !== undefined && at(one.tick)), h("td.number", null, one.firings))), { caption: "Learned rules" }),
      learning.numbers.length > 0 && table(["Rule", numberHead("Value"), numberHead("Updates"), h("td", null, "")], learning.numbers.map((one) => h("tr", { key: one.rule }, h("td", null, one.rule), h("td.number", null, short(one.value)), h("td.number", null, one.updates),
          h("td", null, button("Plot", () => context.run.ask("plot", { agent: contents.moment?.agent ?? "", what: `learned:${one.rule}`, is_on: true }) && context.reveal("plots"), { attributes: { "aria-label": `Plot ${one.rule}` } }, "button.small")))), { caption: `Values learned from reward (${short(learning.total_reward)} in all)` }),
      episodes.length > 0 && h("details", null, h("summary", null, `Reward of ${episodes.length} episodes`), h("ul.plain", null, episodes.slice(-50).reverse().map((one) => h("li", null, at(one.first_tick), ` to `, at(one.last_tick), ` ${short(one.reward)}`)))),
    ];
  },
});
