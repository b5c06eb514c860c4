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

/// The impasse of a decision. kNone without a selected operator means that no candidate is left: a no-change of the
/// state.
enum class Impasse : std::uint8_t { kNone, kTie, kConflict, kConstraintFailure };

/// How one of several indifferent operators is selected (`decide indifferent-selection`).
enum class Policy : std::uint8_t { kBoltzmann, kEpsilonGreedy, kSoftmax, kFirst, kLast };

/// Whether a drop changed the outcome of the decision.
enum class Decisive : std::uint8_t {
  kUnknown,  ///< There were too many preferences to test it.
  kYes,      ///< Without the preferences that caused it, the outcome would be different.
  kNo,       ///< Without them the candidate would still have lost.
};

/// The decision procedure's record of a decision about the operators of a state, as reported by the kernel that made
/// it. It is never recomputed: without a record, there is no explanation. Operators and preferences are identified by
/// their indices.
template <typename Text>
struct DecisionOf {
  static constexpr std::uint32_t kNoOperator = 0xFFFFFFFFu;

  struct Operator {
    Text id, name;  ///< The name may be empty.
  };
  struct Preference {
    PreferenceKind kind = PreferenceKind::kAcceptable;
    std::uint32_t op = kNoOperator;
    std::uint32_t referent = kNoOperator;  ///< Only for better, worse and equal.
    double number = 0;                     ///< Only for numeric preferences.
    Text rule;                             ///< The rule that made it; empty: the architecture.
  };
  /// A candidate that was dropped. by[first .. first + count - 1] are indices of the preferences that caused it. Each
  /// of them is sufficient; without all of them, the candidate is not dropped at that stage. There are none if another
  /// operator was forced.
  struct Drop {
    std::uint32_t op = kNoOperator;
    Stage stage = Stage::kForced;
    Decisive decisive = Decisive::kUnknown;
    std::uint32_t first = 0, count = 0;
  };
  /// A candidate that was not dropped. If several are left and are indifferent, one is selected by its value.
  struct Chance {
    std::uint32_t op = kNoOperator;
    double value = 0;
    double probability = 0;  ///< 0 to 1; 0 in an impasse.
  };

  Impasse impasse = Impasse::kNone;
  std::uint32_t selected = kNoOperator;
  bool is_forced = false;    ///< Selected by the command `decide select`.
  bool has_changed = false;  ///< Preferences have changed since the decision; these are the present ones.
  Policy policy = Policy::kSoftmax;
  std::vector<Operator> operators;
  std::vector<Preference> preferences;
  std::vector<Drop> drops;        ///< Sorted by stage. In a conflict, the candidates are both dropped and left.
  std::vector<std::uint32_t> by;  ///< Indices in `preferences` for the drops.
  std::vector<Chance> left;       ///< The newest proposal first.

  /// Whether no decision was recorded.
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
  /// The index of an operator by its identifier, or kNoOperator.
  std::uint32_t Find(std::string_view id) const {
    for (std::uint32_t i = 0; i < operators.size(); ++i)
      if (operators[i].id == id) return i;
    return kNoOperator;
  }
};

using Decision = DecisionOf<std::string>;
/// The texts belong to the reporter of the decision, and are valid only while it reports.
using DecisionView = DecisionOf<std::string_view>;

}  // namespace soarbox::mind
