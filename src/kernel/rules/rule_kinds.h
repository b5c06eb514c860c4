// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

/// Enumerations that drafts and finished rules share.
namespace soarbox::kernel {

enum class TestKind : std::uint8_t {
  kBlank,  ///< Matches anything (an attribute or value that was not written).
  kEqual,
  kNotEqual,
  kLess,
  kGreater,
  kLessOrEqual,
  kGreaterOrEqual,
  kSameType,
  kDisjunction,  ///< << a b c >>
  kConjunction,  ///< { ... }
  kState,    ///< The word `state` before an identifier test. For positive conditions, only on the first condition (in
             ///< match order) with this variable as its identifier.
  kImpasse,  ///< The word `impasse`.
  kSameLti,
  kNotSameLti,  ///< @ x, !@ x
  kIsLti,
  kIsNotLti,  ///< @+, @-
  kLiteral,   ///< $$ <x>: always true. Learning keeps the value that the variable in this test matched. The last kind.
};

/// The equivalent comparison after its sides have been swapped.
constexpr TestKind TurnedRound(TestKind kind) {
  switch (kind) {
    case TestKind::kLess:
      return TestKind::kGreater;
    case TestKind::kGreater:
      return TestKind::kLess;
    case TestKind::kLessOrEqual:
      return TestKind::kGreaterOrEqual;
    case TestKind::kGreaterOrEqual:
      return TestKind::kLessOrEqual;
    default:
      return kind;
  }
}

enum class ConditionKind : std::uint8_t { kPositive, kNegative, kConjunctiveNegation };

/// A field of a working memory element.
enum class Field : std::uint8_t { kId, kAttribute, kValue };

/// The place where a variable is bound: the n-th positive top-level condition (in match order, counted from 0, positive
/// conditions only), and the field in it.
struct BindingSite {
  std::uint16_t positive_condition = 0;
  Field field = Field::kId;

  friend bool operator==(const BindingSite&, const BindingSite&) = default;
};

enum class PreferenceType : std::uint8_t {
  kAcceptable,
  kRequire,
  kReject,
  kProhibit,
  kBest,
  kWorst,
  kUnaryIndifferent,
  kNumericIndifferent,
  kBinaryIndifferent,
  kBetter,
  kWorse,
};
constexpr bool HasReferent(PreferenceType type) {
  return type >= PreferenceType::kNumericIndifferent;
}

enum class RhsValueKind : std::uint8_t {
  kConstant,  ///< symbol
  kBound,     ///< A variable that a condition binds: site (and symbol, its name).
  kNew,       ///< A variable that no condition binds: one new identifier per firing; new_index, symbol.
  kFunction,  ///< function and arguments
};

enum class ProductionType : std::uint8_t { kUser, kDefault, kChunk, kJustification, kTemplate };
enum class DeclaredSupport : std::uint8_t { kUndeclared, kOSupport, kISupport };

}  // namespace soarbox::kernel
