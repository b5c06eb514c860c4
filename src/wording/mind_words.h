// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"

namespace soarbox::wording {

// Lines that describe what a mind did, for trace, exports and comparisons. No program parses them.

/// What one mind did in a tick, as lines.
struct MindWords {
  std::vector<std::string> percepts;   ///< "path value", or "-path" for a removed percept.
  std::vector<std::string> decisions;  ///< "O: O1 (seek)", "==>S: S2 (operator tie)", indented by three blanks per
                                       ///< level.
  /// "fire RULE", "+ 12: S1 ^a b", each after the number of decisions before it.
  std::vector<std::string> details;
  std::vector<std::string> commands;       ///< "move-to ^waypoint gate", and results: "move-to: complete".
  std::vector<std::string> reasons;        ///< For each decision: its reason, or an empty text.
  std::vector<std::string> command_rules;  ///< For each command: the rule that made it, or an empty text.
};
MindWords Words(const mind::EventLog& log, bool with_details = true);

/// The value as text. A number that is not an integer has at most six significant digits.
std::string ValueText(const mind::Value& value);
/// "agent", or "agent#3" for one of several, by its key.
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

/// "tie", "no-change", ...; "none" for the top state.
std::string_view ReasonName(mind::StateReason reason);
/// "operator tie"; empty for the top state.
std::string ImpasseText(mind::StateReason reason, bool on_operator);
/// "O: O1 (seek)", "==>S: S2 (operator tie)", "learn RULE", without indentation. Empty for events that are not listed
/// with decisions.
std::string DecisionLine(const mind::Event& event);
/// The level of the goal stack of a decision; 1 for other events.
int LevelOf(const mind::Event& event);
/// Whether the event is a value or reward of reinforcement learning. These are listed with decisions, too.
bool IsOfReward(const mind::Event& event);
/// The reason of an event: for operators and states the recorded decision; for recalls and learned rules, where they
/// come from.
std::string ReasonText(const mind::Event& event);
/// "fire RULE", "retract RULE", "+ 12: S1 ^operator O1 +", "- 12: S1 ^a b"; empty for other events.
std::string DetailLine(const mind::Event& event);

}  // namespace soarbox::wording
