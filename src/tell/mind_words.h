// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"

namespace soarbox::tell {

// Lines for what a mind did, as trace, exports and comparisons show them. Nobody reads them back.

/// What one mind did in a tick, line by line.
struct MindWords {
  std::vector<std::string> percepts;   ///< "path value", or "-path" of what has gone.
  std::vector<std::string> decisions;  ///< "O: O1 (seek)", "==>S: S2 (operator tie)", three blanks per level.
  /// "fire RULE", "+ 12: S1 ^a b", after a count of the decisions before it.
  std::vector<std::string> details;
  std::vector<std::string> commands;       ///< "move-to ^waypoint gate", and how they went: "move-to: complete".
  std::vector<std::string> reasons;        ///< For each of the decisions: why it was taken, or nothing.
  std::vector<std::string> command_rules;  ///< For each of the commands: the rule that made it, or nothing.
};
MindWords Words(const mind::EventLog& log, bool with_details = true);

/// Numbers with six digits.
std::string ValueText(const mind::Value& value);
/// "agent", or "agent#3" for the one of several with that key.
std::string PerceptName(std::string_view attribute, std::uint32_t key);
/// "self.speed", "agent#3.range".
std::string PerceptPath(std::string_view path, std::string_view attribute, std::uint32_t key);
/// "^waypoint gate ^at (^x 3 ^z 4) ^text |go ^fast|".
std::string ParametersText(std::span<const mind::Parameter> parameters);
/// "move-to ^waypoint gate".
std::string CommandText(const mind::CommandSaid& command);
/// "move-to: complete", "shoot: error no-target".
std::string CommandText(const mind::CommandEnded& command);
/// "complete", "interrupted", "error".
std::string_view StatusName(mind::CommandStatus status);

/// "tie", "no-change", ...; "none" of the top state.
std::string_view ReasonName(mind::StateReason reason);
/// "operator tie"; empty of the top state.
std::string ImpasseText(mind::StateReason reason, bool on_operator);
/// "O: O1 (seek)", "==>S: S2 (operator tie)", "learn RULE", without blanks in front; empty of events that are no
/// decisions, nor stand among them.
std::string DecisionLine(const mind::Event& event);
/// The level of the goal stack that a decision is of; 1 if it is of none.
int LevelOf(const mind::Event& event);
/// Of the numbers and rewards of reinforcement learning, which stand among decisions, too.
bool IsOfReward(const mind::Event& event);
/// Why it came: of operators and states what the decision procedure said, of recalls and learned rules from what.
std::string ReasonText(const mind::Event& event);
/// "fire RULE", "retract RULE", "+ 12: S1 ^operator O1 +", "- 12: S1 ^a b"; empty of other events.
std::string DetailLine(const mind::Event& event);

}  // namespace soarbox::tell
