// SPDX-License-Identifier: BSD-2-Clause
#include "cli/find_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/object_printer.h"
#include "cli/printed_rule.h"
#include "kernel/rules/parser.h"

namespace soarbox::cli {
namespace {

using kernel::Condition;
using kernel::ConditionKind;
using kernel::Symbol;
using kernel::Test;
using kernel::TestKind;

/// Variables of a rule, each bound to a variable of the pattern; newest binding last.
using Bindings = std::vector<std::pair<Symbol, Symbol>>;

class Finder {
 public:
  explicit Finder(Symbol anything) : anything_(anything) {}

  /// Finds a condition of the rule for each condition of the pattern, from `next` on.
  bool Match(std::span<const Condition> pattern, std::size_t next, std::span<const Condition> conditions) {
    if (next == pattern.size()) return true;
    if (++steps_ > kMaxSteps) return false;
    for (const Condition& condition : conditions) {
      const std::size_t before = bindings_.size();
      if (Fits(pattern[next], condition) && Match(pattern, next + 1, conditions)) return true;
      bindings_.resize(before);
    }
    return false;
  }

  const Bindings& bindings() const { return bindings_; }

 private:
  /// Maximum number of steps, because a pattern with many similar conditions could take very long.
  static constexpr int kMaxSteps = 100000;

  bool Fits(const Condition& pattern, const Condition& condition) {
    return pattern.kind == ConditionKind::kPositive && condition.kind == ConditionKind::kPositive &&
           pattern.tests_acceptable == condition.tests_acceptable && FitsId(pattern.id, condition.id) &&
           FitsTest(pattern.attribute, condition.attribute) && FitsTest(pattern.value, condition.value);
  }

  /// The word `state` may be missing in the pattern, but not in the rule.
  bool FitsId(const Test& pattern, const Test& test) {
    const Test* plain = EqualityIn(pattern);
    const Test* tested = EqualityIn(test);
    if (!plain || !tested) return FitsTest(pattern, test);
    return (!HasState(pattern) || HasState(test)) && FitsTest(*plain, *tested);
  }

  static bool HasState(const Test& test) {
    for (const Test& part : test.parts()) {
      if (part.kind == TestKind::kState) return true;
    }
    return false;
  }

  static const Test* EqualityIn(const Test& test) {
    if (test.kind == TestKind::kEqual) return &test;
    if (test.kind != TestKind::kConjunction) return nullptr;
    const Test* found = nullptr;
    for (const Test& part : test.parts()) {
      if (part.kind == TestKind::kEqual)
        found = &part;
      else if (part.kind != TestKind::kState && part.kind != TestKind::kImpasse)
        return nullptr;
    }
    return found;
  }

  bool FitsTest(const Test& pattern, const Test& test) {
    if (pattern.kind == TestKind::kBlank) return true;
    if (pattern.kind != TestKind::kEqual || test.kind != TestKind::kEqual) return pattern == test;
    if (pattern.referent() == anything_) return true;
    if (!pattern.referent().IsVariable()) return pattern.referent() == test.referent();
    if (!test.referent().IsVariable()) return false;
    for (const auto& [variable, bound] : bindings_) {
      if (variable == pattern.referent()) return bound == test.referent();
    }
    bindings_.emplace_back(pattern.referent(), test.referent());
    return true;
  }

  Symbol anything_;
  Bindings bindings_;
  int steps_ = 0;
};

/// Parses the pattern as the conditions of a rule; prints its errors.
kernel::ProductionPtr ReadPattern(PrintStream& stream, kernel::Agent& agent, const std::string& pattern) {
  const std::string body = "pattern " + pattern + "\n --> (write a)";
  kernel::ParseOutcome outcome = kernel::ParseProduction(body, {}, agent.mutable_symbols());
  if (outcome.production) return outcome.production;
  std::vector<kernel::RuleMessage> messages = std::move(outcome.messages);
  messages.insert(messages.end(), outcome.late_messages.begin(), outcome.late_messages.end());
  for (const kernel::RuleMessage& message : messages) {
    if (message.text.find("(Ignoring production") != std::string::npos) continue;
    stream.FreshLine();
    stream.Print(message.text);
  }
  stream.FreshLine();
  stream.Print("Error: not a valid condition list.\n");
  return nullptr;
}

}  // namespace

void FindRules(PrintStream& stream, kernel::Agent& agent, const std::string& pattern, bool searches, bool show_bindings,
               const std::function<bool(const kernel::Production&)>& wanted) {
  const kernel::ProductionPtr parsed = ReadPattern(stream, agent, pattern);
  bool any = false;
  if (parsed && searches) {
    // Learned rules come after all others; within both groups, newer rules come first.
    std::vector<kernel::ProductionId> rules = agent.Productions();
    std::ranges::reverse(rules);
    std::stable_partition(rules.begin(), rules.end(), [&](kernel::ProductionId id) {
      return agent.production(id).type != kernel::ProductionType::kChunk;
    });
    for (const kernel::ProductionId id : rules) {
      const kernel::Production& rule = agent.production(id);
      if (!wanted(rule)) continue;
      Finder finder(agent.mutable_symbols().String("*"));
      if (!finder.Match(parsed->conditions, 0, rule.conditions)) continue;
      any = true;
      stream.Print(RuleName(agent, rule) + (show_bindings ? ", with bindings:\n" : "\n"));
      if (!show_bindings) continue;
      const Bindings& bindings = finder.bindings();
      for (auto binding = bindings.rbegin(); binding != bindings.rend(); ++binding) {
        stream.Print(
            fmt::format("   ({} -> {})\n", SymbolText(agent, binding->first), SymbolText(agent, binding->second)));
      }
    }
  }
  if (!any) stream.Print("No matches.\n");
}

}  // namespace soarbox::cli
