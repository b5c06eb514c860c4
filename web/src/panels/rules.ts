// SPDX-License-Identifier: BSD-2-Clause
import { button, h, type Child, type View } from "../dom/view";
import type { Contents, RuleView, Rules } from "../run/contents";
import type { MakePanel, PanelContext } from "./panel";
import { soarPieces } from "../editor/soar_tokens";
import { elementLink, empty, filterField, lacksMind, noMind, numberHead, passes, story, table } from "./parts";

function ruleView(context: PanelContext, rules: Rules, rule: RuleView): View {
  return story(rule.name, "rule", () => context.run.ask("rule", { rule: "" }),
    rules.rule_file !== "" && button("Edit", () => context.run.ask("edit", { file: rules.rule_file, line: rules.rule_line, rule: rule.name }) && context.reveal("edit"), {}, "button.small"),
    rule.documentation !== undefined && h("p.quiet", null, rule.documentation),
    h(`p.${rule.complete ? "good" : "warn"}`, null, rule.match),
    h("ol.conditions", null, rule.conditions.map((one, i) => {
      const state = rule.failing === i + 1 ? ".stops" : rule.failing !== undefined && i + 1 > rule.failing ? ".untested" : ".holds";
      return h(`li${state}`, null, h("code", null, one.text), h("span.quiet", null, state === ".stops" ? " it stops here" : ` ${one.partial_matches}`));
    })),
    rule.seen.length > 0 && h("div", null, h("p.quiet", null, "What it saw instead:"), h("ul.plain", null, rule.seen.map((one) => h("li", null, elementLink(context, one))))),
    rule.matches_now.length > 0 && h("details", null, h("summary", null, rule.matches_now.length === 1 ? "1 match now" : `${rule.matches_now.length} matches now`), rule.matches_now.map((match) =>
      h("ul.plain", null, match.map((one) => h("li", null, elementLink(context, one)))))),
    h("pre.source", null, rules.rule_text !== "" ? soarPieces(rules.rule_text).map(({ kind, text }) => (kind === null ? text : h(`span.tok-${kind}`, null, text))) : rule.tokens.length > 0 ? rule.tokens.map((token) => h(`span.tok-${token.kind}`, null, token.text)) : rule.source));
}

export const rulesPanel: MakePanel = (context) => {
  let filter = "";
  const list = (contents: Contents, rules: Rules): Child => {
    const shown = rules.rules.filter((one) => passes(filter, `${one.name} ${one.file ?? ""} ${one.documentation ?? ""}`));
    if (rules.coverage.length > 0) {
      return table(["Rule", numberHead("Fired"), "Stops at"], rules.coverage.filter((one) => passes(filter, one.rule)).map((one) => h("tr", null, h("td", null, button(one.rule, () => context.run.ask("rule", { rule: one.rule }), {}, "button.link.rule")),
          h("td.number", null, one.firings), h("td.quiet", null, one.matched ? "" : `${one.held ?? 0} of ${one.conditions ?? 0}: ${one.stops_at ?? ""}`))), { caption: "Which rules took part so far" });
    }
    if (shown.length === 0) return empty(rules.rules.length === 0 ? (contents.moment?.not_available || "The selected agent has no rules.") : "No rule has this text.");
    return table(["Rule", numberHead("Fired"), numberHead("Matches")], shown.map((one) => h(`tr${rules.rule?.name === one.name ? ".chosen" : ""}`, { key: one.name },
        h("td", null, button(one.name, () => context.run.ask("rule", { rule: one.name }), { attributes: { title: one.documentation ?? one.type } }, "button.link.rule"), one.type === "chunk" && h("span.quiet", null, " learned")),
        h("td.number", null, one.firings), h("td.number", null, one.matches))));
  };
  return {
    word: "rules", title: "Rules", about: "The rules with how often they fired, what they match now, or where they fail.", uses: ["rules", "moment"],
    view: (contents) => {
      const rules = contents.rules;
      if (rules === undefined || lacksMind(context, contents)) return noMind(context, contents, "Select an agent with a Soar mind: its rules are listed here, with how often they fired.");
      return [
        h("div.row", null, filterField("Filter by text", filter, (text) => {
          filter = text;
          context.redraw("rules");
        }), button("Coverage", () => context.run.ask("coverage"), { attributes: { title: "Which rules took part so far, and where the others stop" } })),
        rules.rule !== null && ruleView(context, rules, rules.rule),
        list(contents, rules),
      ];
    },
  };
};
