// SPDX-License-Identifier: BSD-2-Clause
// Rules: all rules with how often they fired, which took part in the run, and the details of one of them.
#include <utility>

#include "debugger/fold_paths.h"
#include "workbench/document/build.h"
#include "workbench/document/glossary.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

constexpr std::uint32_t kAll = 1, kMatchNow = 2, kHaveFired = 4, kNeverFired = 8;

Node List(const Contents& contents) {
  if (contents.rules.empty()) {
    if (!contents.not_recorded.empty()) return Empty(contents.not_recorded);
    return Empty("This mind has no rules.", "Add some in the panel " + std::string(InfoOf(PanelId::kEdit).title) +
                                                ", or type a rule into the Console.");
  }
  Table table{"rules", {{"Rule"}, {"Fired", true}, {"Matches", true}}};
  table.filter = "Filter by name";
  table.groups = {"all", "match now", "have fired", "never fired"};
  table.none_fits = {"No rule matches.", "Clear the filter, or choose 'all'."};
  table.is_sortable = true;
  table.press = RowAction{{RuleRequest{}}, "rule"};
  for (const mind::RuleFact& rule : contents.rules) {
    Cell name = TextCell(rule.name, rule.matches > 0 ? Role::kGood : rule.firings > 0 ? Role::kPlain : Role::kQuiet);
    if (rule.type == "chunk") name.spans.push_back(Quiet(" learned"));
    TableRow& row = table.Add(rule.name, {std::move(name), CountCell(rule.firings), CountCell(rule.matches)});
    row.is_chosen = contents.rule && contents.rule->rule.name == rule.name;
    row.groups = kAll | (rule.matches > 0 ? kMatchNow : 0u) | (rule.firings > 0 ? kHaveFired : kNeverFired);
    row.hint = rule.documentation;
  }
  return table;
}

Nodes Coverage(const Contents& contents) {
  Nodes nodes;
  const bool is_asked = !contents.coverage.empty();
  nodes.push_back(Line{{Button{is_asked ? "Look again" : "Look", Action{CoverageRequest{}},
                               "Notes how far the rules that have not fired match now"},
                        Text("Which rules took part in the run, and where the others stop", Role::kQuiet)}});
  if (!is_asked) return nodes;
  Table table{"coverage", {{"Rule"}, {"Fired", true}, {"Stops at"}}};
  table.filter = "Filter by name";
  table.press = RowAction{{RuleRequest{}}, "rule"};
  for (const debugger::Coverage::Row& rule : contents.coverage) {
    const Role role = rule.firings > 0 ? Role::kGood : rule.matched ? Role::kWarn : Role::kBad;
    Cell stops;
    if (rule.firings == 0 && !rule.stops_at.empty())
      stops =
          TextCell(std::to_string(rule.furthest) + " of " + std::to_string(rule.conditions) + " hold; " + rule.stops_at,
                   Role::kQuiet);
    table.Add(rule.rule,
              {TextCell(rule.rule, role),
               rule.firings > 0 ? CountCell(rule.firings) : NumberCell(0, "never", Role::kBad), std::move(stops)});
  }
  nodes.push_back(std::move(table));
  return nodes;
}

/// Adds the match of a rule, condition by condition.
void AddMatch(const debugger::PartialMatch& match, Nodes& nodes) {
  // In the author's notation.
  const mind::MatchFacts facts = debugger::FoldPaths(match.facts);
  const std::size_t failing = facts.failing.value_or(facts.conditions.size());
  if (facts.failing)
    nodes.push_back(Text(debugger::Explain(facts), Role::kBad));
  else if (!match.sentence.empty())
    nodes.push_back(Text(match.sentence, Role::kGood));
  if (facts.conditions.empty()) return;
  Table conditions{"conditions", {{"Condition", false, false, true}}};
  conditions.has_heads = false;
  for (std::size_t i = 0; i < facts.conditions.size(); ++i) {
    const mind::ConditionFact& condition = facts.conditions[i];
    const bool fails = i == failing, is_after = i > failing;
    const Role role = fails ? Role::kBad : is_after ? Role::kQuiet : Role::kGood;
    Cell cell = TextCell((fails ? "\xe2\x9c\x97 " : is_after ? "  " : "\xe2\x9c\x93 ") + condition.text, role);
    if (!fails && !is_after)
      cell.spans.push_back({"  " + std::to_string(condition.partial_matches), Role::kQuiet, std::nullopt,
                            "How many combinations of elements pass it"});
    conditions.Add(std::to_string(i + 1), {std::move(cell)});
  }
  nodes.push_back(std::move(conditions));
  for (const mind::ElementFact& element : facts.seen)
    nodes.push_back(Text(Spans{{"there is ", Role::kWarn}, ElementLink(element)}));
  for (const mind::ElementFact& element : facts.candidates)
    nodes.push_back(
        Text(Spans{{"matches alone, but not together with the others: ", Role::kWarn}, ElementLink(element)}));
}

void AddMatches(const mind::MatchFacts& facts, Nodes& nodes) {
  if (facts.matches.empty()) return;
  Section section{"matches", {{Count(facts.matches.size(), "match now", "matches now")}}, {}, false};
  int number = 0;
  for (const auto& match : facts.matches) {
    section.nodes.push_back(Text("match " + std::to_string(++number), Role::kQuiet));
    for (const mind::ElementFact& element : match) section.nodes.push_back(Text(Spans{ElementLink(element)}));
  }
  nodes.push_back(std::move(section));
}

Section RuleStoryPart(const Contents& contents, const debugger::RuleView& view) {
  const mind::RuleFact& rule = view.rule;
  const std::string& text = contents.rule_text.empty() ? view.source : contents.rule_text;
  Section section{"rule", {{rule.name, Role::kStrong}}, {}};
  section.is_story = true;
  Line tools;
  const std::string& file = rule.file.empty() ? contents.rule_file : rule.file;
  Button edit{"Edit",
              Action{EditRequest{file, rule.file.empty() ? contents.rule_line : rule.line, rule.name}, PanelId::kEdit},
              file.empty() ? "It was typed, or learned: there is no file" : file + ":" + std::to_string(rule.line)};
  edit.is_enabled = !file.empty();
  tools.nodes.push_back(std::move(edit));
  if (!contents.moment.is_recording) {
    for (const auto& [label, kind] : {std::pair{"Break when it fires", debugger::BreakKind::kFire},
                                      std::pair{"Break when it matches", debugger::BreakKind::kMatch}})
      tools.nodes.push_back(
          Button{label, Action{BreakRequest{kind, contents.agent, rule.name}, PanelId::kBreakpoints}});
  }
  Button copy{"Copy", std::nullopt, "The rule's text"};
  copy.copies = text;
  tools.nodes.push_back(std::move(copy));
  tools.nodes.push_back(Button{"Close", Action{RuleRequest{}}});
  section.nodes.push_back(std::move(tools));
  if (view.source.empty())
    section.nodes.push_back(Text(contents.past_note.empty()
                                     ? "Its text is not available there."
                                     : "Its text is not recorded: it is shown once the moment is simulated again.",
                                 Role::kQuiet));
  section.nodes.push_back(Text(Spans{{rule.type + ", fired " + Count(rule.firings, "time", "times") + ", " +
                                          Count(rule.matches, "match", "matches") + " now",
                                      Role::kQuiet, std::nullopt, std::string(MeaningOf(rule.type))}}));
  if (!rule.documentation.empty()) section.nodes.push_back(Text(rule.documentation));
  AddMatch(view.match, section.nodes);
  AddMatches(view.match.facts, section.nodes);
  // The text of the rule's file if there is one; typed and learned rules are shown as Soar prints them.
  if (!text.empty())
    section.nodes.push_back(Code{text, contents.rule_text.empty() ? view.tokens : debugger::Tokenize(text)});
  return section;
}

}  // namespace

Nodes RulesDocument(const Contents& contents) {
  Nodes nodes;
  if (contents.rule) nodes.push_back(RuleStoryPart(contents, *contents.rule));
  Tabs tabs{"pages", {}};
  tabs.pages.push_back({"Rules", "All rules with how often they fired", {List(contents)}});
  tabs.pages.push_back({"Coverage", "Which rules took part in the run, and where the others stop", Coverage(contents)});
  nodes.push_back(std::move(tabs));
  return nodes;
}

}  // namespace soarbox::workbench::document
