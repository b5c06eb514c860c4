// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/rule_gaps.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/print_production.h"

namespace soarbox::kernel {

namespace {

/// Maximum number of warnings.
constexpr std::size_t kMostGaps = 50;

bool IsOrdering(TestKind kind) {
  return kind == TestKind::kLess || kind == TestKind::kGreater || kind == TestKind::kLessOrEqual ||
         kind == TestKind::kGreaterOrEqual;
}

bool Proposes(const Production& rule) {
  return std::ranges::any_of(rule.actions, [](const Action& action) {
    return !action.is_function_call && action.preference == PreferenceType::kAcceptable &&
           action.attribute.kind == RhsValueKind::kConstant && action.attribute.symbol() == words::kOperator;
  });
}

bool ComparesWithNumber(const Test& test) {
  return IsOrdering(test.kind) && test.referent().IsNumber();
}

/// The numbers that one field accepts, according to its comparisons with numbers.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool has_low = true, has_high = true;  ///< The limits themselves are accepted.

  void Narrow(TestKind kind, double number) {
    const bool closed = kind == TestKind::kLessOrEqual || kind == TestKind::kGreaterOrEqual;
    if (kind == TestKind::kGreater || kind == TestKind::kGreaterOrEqual) {
      if (number > low || (number == low && !closed)) {
        low = number;
        has_low = closed;
      }
    } else if (number < high || (number == high && !closed)) {
      high = number;
      has_high = closed;
    }
  }
  bool Has(double number) const {
    return (number > low || (number == low && has_low)) && (number < high || (number == high && has_high));
  }
};

/// The conditions of a rule as numbers, with variables numbered by first occurrence and without the comparisons of one
/// field with numbers. Rules with equal outlines are siblings.
class Outline {
 public:
  using Key = std::vector<std::uint32_t>;

  /// `hole` is the index of the positive condition whose value is compared.
  Outline(const Production& rule, std::size_t hole) : hole_(hole) { Add(rule.conditions, true); }

  Key Take() { return std::move(key_); }

 private:
  void Add(std::span<const Condition> conditions, bool top) {
    key_.push_back(static_cast<std::uint32_t>(conditions.size()));
    for (std::size_t n = 0; n < conditions.size(); ++n) {
      const Condition& condition = conditions[n];
      key_.push_back(static_cast<std::uint32_t>(condition.kind) * 2 + (condition.tests_acceptable ? 1 : 0));
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        Add(condition.conditions(), false);
        continue;
      }
      Add(condition.id, false);
      Add(condition.attribute, false);
      Add(condition.value, top && n == hole_);
    }
  }

  void Add(const Test& test, bool is_hole) {
    if (test.kind == TestKind::kConjunction) {
      for (const Test& part : test.parts()) {
        Add(part, is_hole);
      }
      key_.push_back(kEnd);
      return;
    }
    if (is_hole && ComparesWithNumber(test)) {
      return;
    }
    key_.push_back(static_cast<std::uint32_t>(test.kind));
    const Symbol referent = test.referent();
    key_.push_back(referent.IsVariable() ? Number(referent) : referent.bits());
    for (const Symbol constant : test.disjuncts()) {
      key_.push_back(constant.bits());
    }
    key_.push_back(kEnd);
  }

  std::uint32_t Number(Symbol variable) {
    const auto found = std::ranges::find(variables_, variable);
    const auto number = static_cast<std::uint32_t>(found - variables_.begin());
    if (found == variables_.end()) {
      variables_.push_back(variable);
    }
    return kVariable + number;
  }

  static constexpr std::uint32_t kEnd = 0xFFFFFFFFu;
  static constexpr std::uint32_t kVariable = 0xF0000000u;  ///< No symbol has such bits.

  std::size_t hole_;
  Key key_;
  std::vector<Symbol> variables_;
};

/// The index of the only condition whose value a rule compares with numbers; none if there are several or none.
std::optional<std::size_t> OnlyComparison(const Production& rule) {
  std::optional<std::size_t> found;
  for (std::size_t n = 0; n < rule.conditions.size(); ++n) {
    const Condition& condition = rule.conditions[n];
    if (condition.kind != ConditionKind::kPositive) {
      continue;
    }
    const Test& value = condition.value;
    if (ComparesWithNumber(value) || std::ranges::any_of(value.parts(), ComparesWithNumber)) {
      if (found) {
        return std::nullopt;
      }
      found = n;
    }
  }
  return found;
}

Range RangeOf(const Production& rule, std::size_t hole, const SymbolTable& symbols) {
  Range range;
  const auto narrow = [&](const Test& test) {
    if (ComparesWithNumber(test)) {
      range.Narrow(test.kind, symbols.NumberValue(test.referent()));
    }
  };
  const Test& test = rule.conditions[hole].value;
  narrow(test);
  for (const Test& part : test.parts()) {
    narrow(part);
  }
  return range;
}

struct Sibling {
  const Production* rule;
  std::size_t number;  ///< In loading order.
  std::size_t hole;
  Range range;
};

/// Returns true if another proposal tests the number by equality, or accepts any value of the attribute. Such rules
/// differ from the siblings in structure, but are probably meant for this case.
bool IsNamedElsewhere(std::span<const Production* const> rules, Symbol attribute, double number,
                      const SymbolTable& symbols) {
  const auto names = [&](Symbol symbol) { return symbol.IsNumber() && symbols.NumberValue(symbol) == number; };
  const auto takes = [&](const Test& test) {
    return (test.kind == TestKind::kEqual && names(test.referent())) || std::ranges::any_of(test.disjuncts(), names);
  };
  return std::ranges::any_of(rules, [&](const Production* rule) {
    return Proposes(*rule) && std::ranges::any_of(rule->conditions, [&](const Condition& condition) {
             const Test& value = condition.value;
             const bool any = value.kind == TestKind::kEqual && value.referent().IsVariable();
             return condition.kind == ConditionKind::kPositive && EqualitySymbol(condition.attribute) == attribute &&
                    (any || takes(value) || std::ranges::any_of(value.parts(), takes));
           });
  });
}

std::string TestText(const Sibling& sibling, double number, const SymbolTable& symbols) {
  std::string text;
  const auto add = [&](const Test& test) {
    if (text.empty() && ComparesWithNumber(test) && symbols.NumberValue(test.referent()) == number) {
      AppendTest(text, symbols, test);
    }
  };
  const Test& test = sibling.rule->conditions[sibling.hole].value;
  add(test);
  for (const Test& part : test.parts()) {
    add(part);
  }
  return text;
}

Diagnostic Warning(const Sibling& below, const Sibling& above, const SymbolTable& symbols) {
  const Production& later = below.number > above.number ? *below.rule : *above.rule;
  const double number = below.range.high;
  std::string number_text = TestText(below, number, symbols);
  number_text.erase(0, number_text.find(' ') + 1);
  const std::string attribute = ToString(symbols, EqualitySymbol(below.rule->conditions[below.hole].attribute));
  Diagnostic diagnostic;
  diagnostic.severity = Severity::kWarning;
  diagnostic.file = later.file();
  diagnostic.line = later.line;
  diagnostic.column = later.column;
  diagnostic.message = "if ^" + attribute + " is exactly " + number_text + ", neither " +
                       std::string(below.rule->name) + " (" + TestText(below, number, symbols) + ") nor " +
                       std::string(above.rule->name) + " (" + TestText(above, number, symbols) + ") proposes";
  diagnostic.hint = "write <= or >= in one of them, unless nothing is to be done then";
  return diagnostic;
}

}  // namespace

std::vector<Diagnostic> FindRuleGaps(std::span<const Production* const> rules, std::size_t fresh,
                                     const SymbolTable& symbols) {
  std::map<Outline::Key, std::vector<Sibling>> families;
  for (std::size_t number = 0; number < rules.size(); ++number) {
    const Production& rule = *rules[number];
    const std::optional<std::size_t> hole = Proposes(rule) ? OnlyComparison(rule) : std::nullopt;
    if (hole) {
      families[Outline(rule, *hole).Take()].push_back({&rule, number, *hole, RangeOf(rule, *hole, symbols)});
    }
  }
  std::vector<std::pair<std::size_t, Diagnostic>> found;  // Sorted by the later rule.
  const std::size_t first_fresh = rules.size() - std::min(fresh, rules.size());
  for (const auto& [key, siblings] : families) {
    for (const Sibling& below : siblings) {
      if (found.size() == kMostGaps) {
        break;
      }
      const double number = below.range.high;
      const auto takes = [&](const Sibling& sibling) { return sibling.range.Has(number); };
      const auto meets = [&](const Sibling& sibling) {
        return sibling.range.low == number && !sibling.range.has_low && sibling.range.high > number;
      };
      const auto above = std::ranges::find_if(siblings, meets);
      if (below.range.has_high || below.range.low >= number || above == siblings.end() ||
          std::max(below.number, above->number) < first_fresh || std::ranges::any_of(siblings, takes)) {
        continue;
      }
      const Symbol attribute = EqualitySymbol(below.rule->conditions[below.hole].attribute);
      if (!IsNamedElsewhere(rules, attribute, number, symbols)) {
        found.emplace_back(std::max(below.number, above->number), Warning(below, *above, symbols));
      }
    }
  }
  std::ranges::stable_sort(found, {}, &std::pair<std::size_t, Diagnostic>::first);
  std::vector<Diagnostic> warnings;
  for (auto& [number, warning] : found) {
    warnings.push_back(std::move(warning));
  }
  return warnings;
}

}  // namespace soarbox::kernel
