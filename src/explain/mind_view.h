// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "explain/inspector.h"
#include "explain/rule_text.h"

namespace sml {
class Agent;
}

namespace soarbox::explain {

/// One state or operator of an agent's goal stack.
struct StackEntry {
  bool is_state = false;
  std::string id;     ///< "S1", "O3"
  std::string about;  ///< "operator tie", or the operator's name; empty for the top state.
};

/// How far a rule gets with what there is now.
struct RuleMatch {
  int matched = 0, total = 0;
  std::string failing;    ///< The first condition that fails, as a kernel prints it; empty: all match.
  bool is_group = false;  ///< It is a negated group of conditions, -{ ... }.
};

/// One preference for an operator.
struct Preference {
  std::string section;            ///< "acceptable", "better", "best", ...
  std::string operator_id, name;  ///< "O3", "move-to"
  std::string text;               ///< "O1 (left) > O2 (right)"
  std::string rule;               ///< That made it; empty if none is named.
  PreferenceFact fact;
};

/// What a Soar program reports about itself, whatever kernel it lives in: the facts of an Inspector, and walks over
/// them. Asks again each time; keeps only the rules and how often they have fired. Valid until the agent runs on.
class MindView {
 public:
  explicit MindView(sml::Agent& agent) : agent_(agent), inspector_(MakeInspector(agent)) {}

  const std::vector<RuleText>& rules();
  const RuleText* FindRule(std::string_view name);
  /// From the top state down.
  std::vector<StackEntry> Stack();
  RuleMatch Match(const std::string& rule);
  /// Whether it has fired since its agent was made; true where a kernel does not say.
  bool HasFired(const std::string& rule);
  /// Whether a match of it is yet to fire: the elaboration limit, or a break, came before.
  bool IsPending(const std::string& rule);
  /// How often it has fired; nothing if that is not reported.
  std::optional<std::uint64_t> Firings(const std::string& rule);
  std::vector<Preference> Preferences(const std::string& state);
  /// Values of an attribute anywhere in working memory.
  std::vector<std::string> ValuesOf(const std::string& attribute);
  /// Values at the end of a path of attributes that begins at an identifier, each once.
  std::vector<std::string> ValuesAt(const std::string& id, const std::vector<std::string>& path);
  /// The elements that a preference of this state rests on, "(I2 ^path P2)".
  std::vector<std::string> Elements(const std::string& state, const Preference& preference);
  /// "move-to ^waypoint north": an operator's name and attributes.
  std::string DescribeOperator(const std::string& id);

 private:
  std::string Ask(const std::string& command);

  sml::Agent& agent_;
  std::unique_ptr<Inspector> inspector_;
  std::map<std::string, std::uint64_t> firings_;  ///< By rule, once somebody has asked.
  std::vector<RuleText> rules_;
  bool read_ = false;
};

/// A condition as its author would write it, from the state on: "^io.input-link.self.health < 50".
struct ConditionText {
  std::vector<std::string> path;  ///< Attributes from the state on.
  std::string value;              ///< Tests without the variables that a kernel made up; may be empty.
  bool negated = false;
  std::vector<std::vector<std::string>> compared;  ///< Paths of the variables that it compares with.
  std::string Text() const;
};
/// Reads what a kernel printed of one condition, or of a group of them, of this rule.
std::vector<ConditionText> ReadCondition(const RuleText& rule, const std::string& printed);

}  // namespace soarbox::explain
