// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "explain/rule_wait.h"

namespace soarbox::explain {

/// The subject of a step of an answer to *why*.
enum class WhyKind : std::uint8_t {
  kReason,
  kAgent,
  kCommand,
  kOperator,
  kPreference,
  kRule,
  kElement,
  kPercept,
  kLearned,
  kCondition,
  kRecall,
  kTopic,
  kImagined,
};

/// One step of an answer to *why*, with the steps that it depends on. Users can open the object that `link` names, and
/// ask about it.
struct WhyNode {
  std::string text;
  WhyKind kind = WhyKind::kReason;
  std::string link = {};  ///< Name of the agent, operator or rule, or the time tag of the element; may be empty.
  std::vector<WhyNode> below = {};
  std::optional<double> time_s = std::nullopt;  ///< The moment that the step is about, if it is not the present.
  std::optional<RuleWait> wait = std::nullopt;  ///< If it is about a rule that does not match: why.
  bool failed = false;                          ///< Of a command: the world refused it or could not carry it out.
};

/// Returns the tree as lines; each level is indented by two more blanks.
std::vector<std::string> Lines(const WhyNode& node, std::size_t indent = 0);
/// Returns the lines of an agent's explanation (Simulation::Why). The steps below the first line are not indented;
/// their own steps are. Empty if there is no explanation.
std::vector<std::string> AccountLines(const std::optional<WhyNode>& account);

}  // namespace soarbox::explain
