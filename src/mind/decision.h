// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::mind {

enum class PreferenceKind : std::uint8_t {
  kAcceptable,
  kRequire,
  kReject,
  kProhibit,
  kBest,
  kWorst,
  kBetter,
  kWorse,
  kIndifferent,
  kNumeric,
  kEqual,  ///< Indifferent to another operator.
};

/// The steps of the decision procedure that drop candidates, in their order.
enum class Stage : std::uint8_t { kForced, kRequire, kProhibit, kReject, kDominated, kBest, kWorst };

/// What kNone means with nothing selected: no candidate is left, a no-change of the state.
enum class Impasse : std::uint8_t { kNone, kTie, kConflict, kConstraintFailure };

/// How one of several indifferent operators is selected (`decide indifferent-selection`).
enum class Policy : std::uint8_t { kBoltzmann, kEpsilonGreedy, kSoftmax, kFirst, kLast };

/// Whether a drop decided something.
enum class Decisive : std::uint8_t {
  kUnknown,  ///< Too many preferences to try.
  kYes,      ///< Without the preferences that it rests on, the outcome would differ.
  kNo,       ///< Without them the candidate would have lost all the same.
};

/// What the decision procedure said of the operators of a state: facts of the kernel that decided, as values. Nobody
/// computes them again, and whoever has none says so. Operators and preferences are named by their places.
template <typename Text>
struct DecisionOf {
  static constexpr std::uint32_t kNoOperator = 0xFFFFFFFFu;

  struct Operator {
    Text id, name;  ///< The name may be empty.
  };
  struct Preference {
    PreferenceKind kind = PreferenceKind::kAcceptable;
    std::uint32_t op = kNoOperator;
    std::uint32_t referent = kNoOperator;  ///< Of better, worse and equal.
    double number = 0;                     ///< Of numeric ones.
    Text rule;                             ///< That made it; empty: the architecture.
  };
  /// A candidate that was dropped, by any of by[first .. first + count - 1]: places of preferences, each of which
  /// suffices; without all of them it is not dropped at that stage. None where another operator was forced.
  struct Drop {
    std::uint32_t op = kNoOperator;
    Stage stage = Stage::kForced;
    Decisive decisive = Decisive::kUnknown;
    std::uint32_t first = 0, count = 0;
  };
  /// A candidate that was left. One of several that are indifferent is selected by value.
  struct Chance {
    std::uint32_t op = kNoOperator;
    double value = 0;
    double probability = 0;  ///< 0 to 1; 0 in an impasse.
  };

  Impasse impasse = Impasse::kNone;
  std::uint32_t selected = kNoOperator;
  bool is_forced = false;    ///< By `decide select`.
  bool has_changed = false;  ///< Preferences have changed since: these are the present ones.
  Policy policy = Policy::kSoftmax;
  std::vector<Operator> operators;
  std::vector<Preference> preferences;
  std::vector<Drop> drops;        ///< By stage. In a conflict all candidates are dropped and left.
  std::vector<std::uint32_t> by;  ///< Places in `preferences`, of the drops.
  std::vector<Chance> left;       ///< Newest proposal first.

  /// Nothing was reported of a decision.
  bool empty() const { return preferences.empty(); }
  void Clear() {
    impasse = Impasse::kNone;
    selected = kNoOperator;
    is_forced = has_changed = false;
    operators.clear(), preferences.clear(), drops.clear(), by.clear(), left.clear();
  }
  /// The drop of an operator; null if it was not dropped.
  const Drop* DropOf(std::uint32_t op) const {
    for (const Drop& drop : drops)
      if (drop.op == op) return &drop;
    return nullptr;
  }
  /// The place of an operator by its identifier, or kNoOperator.
  std::uint32_t Find(std::string_view id) const {
    for (std::uint32_t i = 0; i < operators.size(); ++i)
      if (operators[i].id == id) return i;
    return kNoOperator;
  }
};

using Decision = DecisionOf<std::string>;
/// Texts belong to somebody else. For whoever reports a decision while it is made.
using DecisionView = DecisionOf<std::string_view>;

}  // namespace soarbox::mind
