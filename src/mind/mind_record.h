// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"

namespace soarbox::mind {

/// How much is recorded of what minds do. kNone costs nothing.
enum class MindDetail : std::uint8_t {
  kNone,
  kDecisions,  ///< Operators and impasses, with their reasons.
  kAll,        ///< Also rules that fire and are retracted, and elements that are added and removed.
};

/// What one mind does in a tick, and the operators that are selected in its goal stack now. Levels are counted from 1,
/// the top state.
struct MindRecord {
  EventLog events;

  void OnOperator(const OperatorSelected& selected);
  /// A waiting program reports this in each cycle; it is recorded only once.
  void OnState(const StateMade& made);
  void OnStateGone(const StateGone& gone);
  /// `rule` created a new element that is directly on the output link.
  void OnCommand(std::uint64_t timetag, std::string_view rule);

  /// The rule that created an element of the output link in this tick, or an empty text. Valid until Clear.
  std::string_view MakerOf(std::uint64_t timetag) const;
  /// The selected operators from the top: "engage > aim". Empty if there is none, or if operators are not recorded.
  std::string Operators() const;
  /// Begins the next tick.
  void Clear();
  /// Call it if reports may have been missed.
  void ForgetWaiting() { waits_in_.clear(); }

 private:
  struct Maker {
    std::uint64_t timetag = 0;
    std::size_t name_end = 0;  ///< In names_. The name begins at the end of the previous one.
  };
  void Settle(int level, std::string_view operator_name);

  std::vector<Maker> makers_;
  std::string names_;
  std::vector<std::string> operators_;  ///< By level of the goal stack; only the first `depth_` are valid.
  std::size_t depth_ = 0;
  std::string waits_in_;  ///< The state that was reported last, if nothing was reported since then.
};

/// What the rules of one mind write, and their actions that fail, since the owner last took it.
struct RuleOutput {
  static constexpr std::size_t kMostText = 64 * 1024;
  static constexpr std::size_t kMostFailures = 100;
  /// An action that failed when a rule fired, or a rule that would fire endlessly.
  struct Failure {
    std::string rule;
    std::string
        text;  ///< The kernel's message: "Error: attempt to divide ('/') by zero.\n". Empty: it fires endlessly.
  };

  std::string text;  ///< Written with (write ...), or messages about failed functions or endless firing.
  std::vector<Failure> failures;

  void Write(std::string_view more) {
    if (text.size() < kMostText) text += more;
  }
  void NoteFailure(std::string_view rule, std::string_view why) {
    if (failures.size() < kMostFailures) failures.push_back({std::string(rule), std::string(why)});
  }
};

}  // namespace soarbox::mind
