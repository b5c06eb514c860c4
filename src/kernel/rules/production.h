// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "kernel/base/symbol.h"

/// The syntax tree of a rule after reading, checking and reordering: what the match, the firing and the printers work
/// on. Immutable once made, and shared by agents that run the same rules; symbols are handles of their table.
namespace soarbox::kernel {

enum class TestKind : std::uint8_t {
  kBlank,         ///< Matches anything (an attribute or value that was not written).
  kEqual, kNotEqual, kLess, kGreater, kLessOrEqual, kGreaterOrEqual, kSameType,
  kDisjunction,   ///< << a b c >>
  kConjunction,   ///< { ... }
  kState,         ///< The word `state` before an identifier test. On a positive condition's identifier only once per
                  ///< variable, on the first condition (in match order) with this variable as its identifier.
  kImpasse,       ///< The word `impasse`.
  kSameLti, kNotSameLti,  ///< @ x, !@ x
  kIsLti, kIsNotLti,      ///< @+, @-
};

struct Test {
  TestKind kind = TestKind::kBlank;
  Symbol referent;                  ///< Constant or variable, for the relational kinds and @.
  std::vector<Symbol> disjuncts;    ///< kDisjunction.
  std::vector<Test> parts;          ///< kConjunction; never nested, at most one part is kEqual.

  friend bool operator==(const Test&, const Test&) = default;
};

enum class ConditionKind : std::uint8_t { kPositive, kNegative, kConjunctiveNegation };

struct Condition {
  ConditionKind kind = ConditionKind::kPositive;
  Test id, attribute, value;           ///< kPositive, kNegative.
  bool tests_acceptable = false;       ///< ^operator <o> +
  std::vector<Condition> conditions;   ///< kConjunctiveNegation.

  friend bool operator==(const Condition&, const Condition&) = default;
};

/// A field of a working memory element.
enum class Field : std::uint8_t { kId, kAttribute, kValue };

/// Where a variable is bound: the n-th positive top-level condition (in match order, counted from 0 over positive
/// conditions only) and the field in it.
struct BindingSite {
  std::uint16_t positive_condition = 0;
  Field field = Field::kId;

  friend bool operator==(const BindingSite&, const BindingSite&) = default;
};

enum class PreferenceType : std::uint8_t {
  kAcceptable, kRequire, kReject, kProhibit, kBest, kWorst, kUnaryIndifferent,
  kNumericIndifferent, kBinaryIndifferent, kBetter, kWorse,
};

enum class RhsValueKind : std::uint8_t {
  kConstant,       ///< symbol
  kBound,          ///< A variable that a condition binds: site (and symbol, its name).
  kNew,            ///< A variable that no condition binds: one new identifier per firing; new_index, symbol.
  kFunction,       ///< function and arguments
};

struct RhsValue {
  RhsValueKind kind = RhsValueKind::kConstant;
  Symbol symbol;
  BindingSite site;
  std::uint16_t new_index = 0;        ///< Which of the rule's new identifiers.
  std::string function;               ///< As written: "+", "write", "exec".
  std::uint16_t function_index = 0;   ///< Index in the table of built-in functions; kUserFunction for others.
  std::vector<RhsValue> arguments;

  static constexpr std::uint16_t kUserFunction = 0xFFFF;
  friend bool operator==(const RhsValue&, const RhsValue&) = default;
};

struct Action {
  bool is_function_call = false;      ///< (write ...): only `value` is used.
  PreferenceType preference = PreferenceType::kAcceptable;
  RhsValue id, attribute, value;
  RhsValue referent;                  ///< The binary preferences and kNumericIndifferent.

  bool HasReferent() const { return preference >= PreferenceType::kNumericIndifferent; }
  friend bool operator==(const Action&, const Action&) = default;
};

enum class ProductionType : std::uint8_t { kUser, kDefault, kChunk, kJustification, kTemplate };
enum class DeclaredSupport : std::uint8_t { kUndeclared, kOSupport, kISupport };

struct Production {
  std::string name;
  std::string documentation;
  bool has_documentation = false;     ///< An empty documentation string differs from none.
  ProductionType type = ProductionType::kUser;
  DeclaredSupport declared_support = DeclaredSupport::kUndeclared;
  bool interrupt = false;             ///< :interrupt
  bool explain = false;               ///< :explain
  bool is_rl = false;                 ///< Exactly one action, a numeric-indifferent preference for an operator.
                                      ///< Never for templates.
  std::vector<Condition> conditions;  ///< In match order.
  std::vector<Action> actions;        ///< In firing order.
  std::vector<Symbol> new_identifiers;  ///< The variables behind RhsValueKind::kNew, by new_index.
  std::string file;                   ///< Where it was read; empty for typed rules.
  int line = 0;                       ///< Of the rule's first line in `file`; 0 if unknown.
};

using ProductionPtr = std::shared_ptr<const Production>;

}  // namespace soarbox::kernel
