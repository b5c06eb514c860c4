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

/// How many conditions of a rule match at present.
struct RuleMatch {
  int matched = 0, total = 0;
  std::string failing;    ///< The first condition that fails, as a kernel prints it; empty if all match.
  bool is_group = false;  ///< The failing condition is a negated group, -{ ... }.
};

/// "O1 (left) > O2 (right)".
std::string PreferenceText(const PreferenceFact& preference);

/// Searches what an Inspector reports about a Soar program of any kernel. Each call queries the kernel; only the rules
/// are cached, and their numbers of firings if the inspector reports all data. Valid until the agent runs again.
class MindView {
 public:
  explicit MindView(sml::Agent& agent) : agent_(agent), inspector_(MakeInspector(agent)) {}

  const std::vector<RuleText>& rules();
  const RuleText* FindRule(std::string_view name);
  /// From the top state down.
  std::vector<StackEntry> Stack();
  RuleMatch Match(const std::string& rule);
  /// Whether the rule has fired since its agent was created. True if the kernel does not report it.
  bool HasFired(const std::string& rule);
  /// Whether a match of the rule has not fired yet, because the elaboration limit or a break came first.
  bool IsPending(const std::string& rule);
  /// How often the rule has fired; nothing if that is not reported.
  std::optional<std::uint64_t> Firings(const std::string& rule);
  std::vector<PreferenceFact> Preferences(const std::string& state) { return inspector_->Operators(state).preferences; }
  /// The recorded decision about a state's operators; empty if the kernel does not report it.
  mind::Decision DecisionOf(const std::string& state);
  /// Values that an attribute has anywhere in working memory.
  std::vector<std::string> ValuesOf(const std::string& attribute);
  /// Values at the end of a path of attributes that begins at identifier `id`. Each value occurs once.
  std::vector<std::string> ValuesAt(const std::string& id, const std::vector<std::string>& path);
  /// The elements that a preference of this state depends on: "(I2 ^path P2)".
  std::vector<std::string> Elements(const std::string& state, const PreferenceFact& preference);
  /// An operator's name and attributes: "move-to ^waypoint north".
  std::string DescribeOperator(const std::string& id);

 private:
  std::string Ask(const std::string& command);

  sml::Agent& agent_;
  std::unique_ptr<Inspector> inspector_;
  std::map<std::string, std::uint64_t> firings_;  ///< By rule; filled on the first request if all data are reported.
  std::vector<RuleText> rules_;
  bool read_ = false;
};

/// A condition as its author would write it, with its path from the state: "^io.input-link.self.health < 50".
struct ConditionText {
  std::vector<std::string> path;  ///< Attributes from the state on.
  std::string value;              ///< Tests, without variables that the kernel generated; may be empty.
  bool negated = false;
  std::vector<std::vector<std::string>> compared;  ///< Paths of the variables that the condition compares with.
  std::string Text() const;
};
/// Parses a condition of `rule`, or a group of conditions, from the text that a kernel printed.
std::vector<ConditionText> ReadCondition(const RuleText& rule, const std::string& printed);

}  // namespace soarbox::explain
