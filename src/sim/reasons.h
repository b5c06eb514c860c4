// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "sim/rule_text.h"

namespace sml {
class Agent;
}

namespace soarbox::sim {

/// One state or operator of an agent's goal stack.
struct StackEntry {
  bool is_state = false;
  std::string id;     ///< "S1", "O3"
  std::string about;  ///< "operator tie", or the operator's name; empty for the top state.
};

/// Asks a Soar program about itself, through its command language alone, so that it works with any kernel. Costs
/// nothing until somebody asks.
class MindReasons {
 public:
  explicit MindReasons(sml::Agent& agent) : agent_(agent) {}

  /// Why it does nothing, most telling first; each a whole sentence or two. `known`: attributes that are made
  /// elsewhere (percepts of scripts, other agents' messages).
  std::vector<std::string> WhyIdle(const std::set<std::string>& known);
  /// Attributes that its rules test and that no sense, rule or answer ever writes.
  std::vector<std::string> UnwrittenAttributes(const std::set<std::string>& known);
  /// What led to the operator that is selected: proposals, preferences and the elements that they rest on, as lines.
  std::vector<std::string> OperatorTree(const std::string& command);

  std::vector<StackEntry> Stack();
  const std::vector<RuleText>& rules();

 private:
  std::string Ask(const std::string& command);
  std::vector<std::string> Nearest(const std::vector<const RuleText*>& rules, std::size_t most);
  std::string ExplainCondition(const std::string& condition);
  std::string ExplainTie(const std::string& state);
  /// Values of an attribute anywhere in working memory.
  std::vector<std::string> ValuesOf(const std::string& attribute);

  sml::Agent& agent_;
  std::vector<RuleText> rules_;
  bool read_ = false;
};

/// "did you mean ^distance?" or nothing, from percepts and these.
std::string SuggestAttribute(std::string_view attribute, const std::set<std::string>& known);

}  // namespace soarbox::sim
