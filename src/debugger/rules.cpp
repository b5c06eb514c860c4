// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "debugger/facts_text.h"
#include "diagnostics/diagnostic.h"

namespace soarbox::debugger {
namespace {

bool IsIn(RuleSet set, const explain::RuleFact& rule) {
  switch (set) {
    case RuleSet::kAll:
      return true;
    case RuleSet::kMatching:
      return rule.matches > 0;
    case RuleSet::kFired:
      return rule.firings > 0;
    case RuleSet::kNeverFired:
      return rule.firings == 0;
  }
  return true;
}

std::string PlaceOf(const explain::RuleFact& rule) {
  return rule.file.empty() ? std::string() : rule.file + ":" + std::to_string(rule.line);
}

/// Groups elements by identifier and attribute: "^color of S1 is blue, green".
std::string ListSeen(const std::vector<explain::ElementFact>& seen) {
  constexpr std::size_t kMostShown = 4;
  std::vector<std::pair<std::string, std::string>> groups;
  for (const explain::ElementFact& element : seen) {
    const std::string key = "^" + element.attribute + " of " + element.id + " is ";
    const std::string value = element.value + (element.acceptable ? " +" : "");
    const auto at = std::ranges::find(groups, key, &std::pair<std::string, std::string>::first);
    if (at != groups.end()) {
      at->second += ", " + value;
    } else {
      groups.emplace_back(key, value);
    }
  }
  std::string text;
  for (std::size_t i = 0; i < groups.size() && i < kMostShown; ++i)
    text += (i == 0 ? "" : "; ") + groups[i].first + groups[i].second;
  if (groups.size() > kMostShown) text += fmt::format("; and {} more", groups.size() - kMostShown);
  return text;
}

}  // namespace

std::vector<explain::RuleFact> ListRules(explain::Inspector& mind, std::string_view filter, RuleSet set) {
  std::vector<explain::RuleFact> rules = mind.Rules();
  std::erase_if(rules, [&](const explain::RuleFact& rule) {
    return !IsIn(set, rule) || !Passes(filter, rule.name + " " + rule.file + " " + rule.documentation);
  });
  return rules;
}

std::string Explain(const explain::MatchFacts& facts) {
  if (!facts.failing) return facts.complete == 1 ? "matches" : fmt::format("matches {} times", facts.complete);
  const std::size_t place = *facts.failing;
  const explain::ConditionFact& condition = facts.conditions[place];
  std::string text = fmt::format("stops at condition {} of {}, {}", place + 1, facts.conditions.size(), condition.text);
  if (condition.negated) {
    if (!facts.seen.empty()) return text + ": " + ListSeen(facts.seen);
    return text + ": an element that it excludes exists";
  }
  if (!facts.seen.empty()) return text + ": " + ListSeen(facts.seen);
  if (facts.candidates.empty()) return text + ": nothing like that is in working memory";
  return text + ": such elements exist, but on another object: " + Describe(facts.candidates.front());
}

std::optional<PartialMatch> LookAtMatch(explain::Inspector& mind, std::string_view rule) {
  std::optional<explain::MatchFacts> facts = mind.Match(rule);
  if (!facts) return std::nullopt;
  PartialMatch match;
  match.sentence = Explain(*facts);
  match.facts = std::move(*facts);
  return match;
}

std::optional<RuleView> LookAtRule(explain::Inspector& mind, std::string_view rule) {
  std::optional<PartialMatch> match = LookAtMatch(mind, rule);
  if (!match) return std::nullopt;
  RuleView view;
  for (explain::RuleFact& fact : mind.Rules())
    if (fact.name == match->facts.rule) view.rule = std::move(fact);
  if (view.rule.name.empty()) view.rule.name = rule;
  view.source = mind.RuleSource(rule);
  view.tokens = Tokenize(view.source);
  view.match = std::move(*match);
  return view;
}

std::vector<std::string> NearRules(explain::Inspector& mind, std::string_view rule, std::size_t most) {
  const std::vector<explain::RuleFact> rules = mind.Rules();
  std::vector<std::string_view> names;
  for (const explain::RuleFact& fact : rules) names.push_back(fact.name);
  std::vector<std::string> near;
  while (near.size() < most) {
    const std::string_view next = Suggest(rule, names);
    if (next.empty()) break;
    near.emplace_back(next);
    std::erase(names, next);
  }
  for (const std::string_view name : names)
    if (near.size() < most && !rule.empty() && name.find(rule) != std::string_view::npos) near.emplace_back(name);
  return near;
}

Coverage::Row& Coverage::At(const std::string& rule) {
  Row& row = rows_[rule];
  row.rule = rule;
  return row;
}

void Coverage::Add(std::uint64_t tick, const record::MindRecord& mind) {
  mind.events.ForEachOf<mind::RuleFired>([&](const mind::RuleFired& fired) {
    if (fired.retracts) return;
    Row& row = At(std::string(fired.rule));
    ++row.firings;
    row.matched = true;
    if (!row.first) row.first = tick;
    row.last = tick;
  });
}

void Coverage::Look(explain::Inspector& mind) {
  order_.clear();
  for (const explain::RuleFact& rule : mind.Rules()) {
    order_.push_back(rule.name);
    Row& row = At(rule.name);
    row.firings = std::max(row.firings, rule.firings);
    row.matched = row.matched || row.firings > 0 || rule.matches > 0;
    if (row.matched) {
      row.stops_at.clear();
      continue;
    }
    const std::optional<explain::MatchFacts> facts = mind.Match(rule.name);
    if (!facts) continue;
    row.conditions = facts->conditions.size();
    if (!facts->failing) {
      row.matched = true;
    } else if (*facts->failing >= row.furthest) {
      row.furthest = *facts->failing;
      row.stops_at = facts->conditions[*facts->failing].text;
    }
  }
}

std::vector<Coverage::Row> Coverage::rows() const {
  std::vector<Row> rows;
  for (const std::string& rule : order_) rows.push_back(rows_.at(rule));
  for (const auto& [rule, row] : rows_)
    if (std::ranges::find(order_, rule) == order_.end()) rows.push_back(row);
  return rows;
}

std::string ToText(const std::vector<explain::RuleFact>& rules) {
  std::vector<std::vector<std::string>> table = {{"rule", "fired", "matches", "type", "from"}};
  for (const explain::RuleFact& rule : rules)
    table.push_back({rule.name, std::to_string(rule.firings), std::to_string(rule.matches), rule.type, PlaceOf(rule)});
  return Table(table);
}

std::string ToText(const RuleView& view) {
  std::string text = view.source;
  if (!text.ends_with('\n')) text += "\n";
  text += fmt::format("{}, fired {} times{}\n", view.rule.type, view.rule.firings,
                      view.rule.file.empty() ? "" : ", from " + PlaceOf(view.rule));
  text += view.match.sentence + "\n";
  for (std::size_t i = 0; i < view.match.facts.conditions.size(); ++i) {
    const explain::ConditionFact& condition = view.match.facts.conditions[i];
    const bool behind = view.match.facts.failing && i > *view.match.facts.failing;
    const std::string count = view.match.facts.failing == i ? ">>>>"
                              : behind                      ? ""
                                                            : fmt::format("{}", condition.partial_matches);
    text += fmt::format("  {:>4} {}\n", count, condition.text);
  }
  for (const std::vector<explain::ElementFact>& match : view.match.facts.matches) {
    text += "  match:";
    for (const explain::ElementFact& element : match) text += " (" + Describe(element) + ")";
    text += "\n";
  }
  return text;
}

std::string ToText(const std::vector<Coverage::Row>& rows) {
  std::vector<std::vector<std::string>> table = {{"rule", "fired", "first", "last", "never fired because"}};
  for (const Coverage::Row& row : rows) {
    std::string why;
    if (row.firings == 0)
      why = row.matched
                ? "it matched and did not fire"
                : fmt::format("{} of {} conditions matched; then {}", row.furthest, row.conditions, row.stops_at);
    table.push_back({row.rule, std::to_string(row.firings), row.first ? std::to_string(*row.first) : "",
                     row.last ? std::to_string(*row.last) : "", why});
  }
  return Table(table);
}

}  // namespace soarbox::debugger
