// SPDX-License-Identifier: BSD-2-Clause
#include "cli/rule_crowds.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

#include "kernel/rules/draft.h"
#include "kernel/rules/print_production.h"

namespace soarbox::cli {

using kernel::Condition;
using kernel::ConditionKind;
using kernel::EqualitySymbol;
using kernel::Production;
using kernel::Symbol;
using kernel::SymbolTable;
using kernel::Test;
using kernel::TestKind;

namespace {

constexpr std::size_t kFewestConditions = 6;
/// Maximum number of conditions on one attribute that are examined; more would give the same advice.
constexpr std::size_t kMostMembers = 40;

bool IsPlain(const Condition& condition) {
  return condition.kind == ConditionKind::kPositive;
}

/// Whether a test passes few values: a constant, a disjunction, or a bound variable.
bool TellsApart(const Test& test, const std::set<std::uint32_t>& bound) {
  const auto tells = [&](const Test& part) {
    return part.kind == TestKind::kDisjunction ||
           (part.kind == TestKind::kEqual && (!part.referent().IsVariable() || bound.contains(part.referent().bits())));
  };
  return tells(test) || std::ranges::any_of(test.parts(), tells);
}

/// A condition (<x> ^attribute <v>) with a new value, and the condition that distinguishes its value.
struct Member {
  std::size_t at = 0;
  std::size_t settled = 0;
  std::vector<std::size_t> way;
};

/// Whether at least kFewestConditions conditions test this attribute for this variable, like a rule in which all things
/// must be on the same peg. Such a test does not distinguish the things.
bool IsShared(const Production& rule, const Condition& condition) {
  const Symbol attribute = EqualitySymbol(condition.attribute), value = EqualitySymbol(condition.value);
  return value && value.IsVariable() && std::ranges::count_if(rule.conditions, [&](const Condition& other) {
                                          return IsPlain(other) && EqualitySymbol(other.attribute) == attribute &&
                                                 EqualitySymbol(other.value) == value;
                                        }) >= static_cast<std::ptrdiff_t>(kFewestConditions);
}

/// The conditions below the value of a condition, up to the first one that distinguishes it; empty if there is none.
std::vector<std::size_t> WayToSettle(const Production& rule, std::size_t at) {
  std::map<std::uint32_t, std::size_t> made_by;  // Variables below the value: the condition that binds each.
  made_by[EqualitySymbol(rule.conditions[at].value).bits()] = at;
  std::set<std::uint32_t> bound;
  for (std::size_t n = 0; n < rule.conditions.size(); ++n) {
    const Condition& condition = rule.conditions[n];
    if (!IsPlain(condition)) continue;
    const Symbol id = EqualitySymbol(condition.id), value = EqualitySymbol(condition.value);
    const auto parent = n > at && id ? made_by.find(id.bits()) : made_by.end();
    if (parent != made_by.end()) {
      if (IsShared(rule, condition)) continue;
      if (TellsApart(condition.value, bound)) {
        std::vector<std::size_t> way = {n};
        for (std::size_t up = parent->second; up != at;) {
          way.push_back(up);
          up = made_by.at(EqualitySymbol(rule.conditions[up].id).bits());
        }
        way.push_back(at);
        std::ranges::reverse(way);
        return way;
      }
      if (value && value.IsVariable()) made_by.emplace(value.bits(), n);
    } else {
      for (const Symbol symbol : {id, value}) {
        if (symbol && symbol.IsVariable() && !made_by.contains(symbol.bits())) bound.insert(symbol.bits());
      }
    }
  }
  return {};
}

}  // namespace

double RuleCrowd::PartialMatches() const {
  return std::pow(static_cast<double>(values), static_cast<double>(values));
}

std::optional<RuleCrowd> FindCrowd(const Production& rule) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<Member>> groups;  // By identifier and attribute.
  std::set<std::uint32_t> bound;
  for (std::size_t n = 0; n < rule.conditions.size(); ++n) {
    const Condition& condition = rule.conditions[n];
    if (!IsPlain(condition)) continue;
    const Symbol id = EqualitySymbol(condition.id), attribute = EqualitySymbol(condition.attribute),
                 value = EqualitySymbol(condition.value);
    if (id && attribute && !attribute.IsVariable() && value && value.IsVariable() && !bound.contains(value.bits()) &&
        id != value) {
      groups[{id.bits(), attribute.bits()}].push_back({n, 0, {}});
    }
    for (const Symbol symbol : {id, value}) {
      if (symbol && symbol.IsVariable()) bound.insert(symbol.bits());
    }
  }
  std::optional<RuleCrowd> worst;
  for (auto& [key, members] : groups) {
    if (members.size() < kFewestConditions) continue;
    if (members.size() > kMostMembers) members.resize(kMostMembers);
    for (Member& member : members) {
      member.way = WayToSettle(rule, member.at);
      member.settled = member.way.empty() ? 0 : member.way.back();
    }
    // Values that are never distinguished multiply in any order, which is intended.
    std::erase_if(members, [](const Member& member) { return member.way.empty(); });
    std::size_t most = 0;
    for (const Member& last : members) {
      const auto waits = [&](const Member& member) { return member.at <= last.at && member.settled > last.at; };
      most = std::max(most, static_cast<std::size_t>(std::ranges::count_if(members, waits)));
    }
    if (most < kFewestConditions || (worst && worst->values >= most)) continue;
    worst =
        RuleCrowd{Symbol::FromBits(key.second), most, members.front().at, members.front().settled, members.front().way};
  }
  return worst;
}

std::string AdviceFor(const Production& rule, const RuleCrowd& crowd, const SymbolTable& symbols) {
  const std::string attribute = ToString(symbols, crowd.attribute);
  std::string text = "test what distinguishes each ^" + attribute + " directly after it, in this order:";
  for (const std::size_t n : crowd.way) {
    text += ' ';
    kernel::AppendCondition(text, symbols, rule.conditions[n]);
  }
  return text + ", then the next ^" + attribute + "; or declare `multi-attributes " + attribute + " " +
         std::to_string(crowd.values) + "` in front of the rule";
}

std::vector<Diagnostic> FindRuleCrowds(std::span<const Production* const> rules, std::size_t fresh,
                                       const SymbolTable& symbols) {
  std::vector<Diagnostic> warnings;
  for (const Production* rule : rules.last(std::min(fresh, rules.size()))) {
    const std::optional<RuleCrowd> crowd =
        rule->conditions.size() < 2 * kFewestConditions ? std::nullopt : FindCrowd(*rule);
    if (!crowd) continue;
    Diagnostic& warning = warnings.emplace_back();
    warning.severity = Severity::kWarning;
    warning.file = rule->file();
    warning.line = rule->line;
    warning.column = rule->column;
    warning.message =
        std::string(rule->name) + " tests ^" + ToString(symbols, crowd->attribute) + " " +
        std::to_string(crowd->values) + " times before it distinguishes the values: with " +
        std::to_string(crowd->values) + " values it holds " +
        (crowd->PartialMatches() < 1e18 ? std::to_string(std::llround(crowd->PartialMatches())) : "more than 10^18") +
        " partial matches";
    warning.hint = AdviceFor(*rule, *crowd, symbols);
  }
  return warnings;
}

}  // namespace soarbox::cli
