// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::explain {

/// One attribute of a clause of a rule as a kernel prints it, with dots already expanded.
struct RuleAttribute {
  std::string id;         ///< The clause's variable, "<s>".
  std::string attribute;  ///< Without the ^; a variable or a list of tests if it is no constant.
  std::string value;      ///< All that follows it, "<o> +".
  bool negated = false;
  bool on_state = false;  ///< The clause begins with the word state.
  bool in_group = false;  ///< Of a condition: it is one of several in -{ ... }, or of a negated clause.
  bool removes = false;   ///< Of an action: the value is followed by the sign - alone.
};

/// A call of a function in a rule's actions.
struct RuleCall {
  std::string function;
  std::vector<std::string> arguments;  ///< As they are printed; "(" for a call within the call.
};

/// Places by name, each as attributes from the state on.
using PathMap = std::map<std::string, std::vector<std::string>>;

/// The support that a rule declares for what it makes: :o-support, :i-support, or neither.
enum class RuleSupport : std::uint8_t { kByConditions, kOSupport, kISupport };

/// What a rule says about itself, as far as reasons and checks need it.
struct RuleText {
  std::string name;
  std::vector<RuleAttribute> conditions, actions;
  PathMap paths;  ///< Where the variables of its conditions lie.

  /// Constant names of the operators that it proposes; "" among them stands for names that are not constant.
  std::set<std::string> proposes;
  /// Names of the operators whose selection it tests; "" for any.
  std::set<std::string> applies;
  /// Names of operators of a state above below which it proposes others: it works on them in a substate.
  std::set<std::string> works_on;
  /// Attributes that it puts directly on the output link.
  std::set<std::string> says;
  /// Names of the functions that its actions call.
  std::set<std::string> calls;
  /// The same with their arguments, each call as often as it is there.
  std::vector<RuleCall> all_calls;
  bool acts = false;  ///< It has actions at all.
  RuleSupport support = RuleSupport::kByConditions;
};

/// True for what a kernel prints for an identifier: a capital letter and a number.
bool IsIdentifier(std::string_view value);
/// What comes before the first blank.
std::string FirstWord(const std::string& value);
/// Reads what `print --all --full` answers. Text that is no rule is skipped.
std::vector<RuleText> ReadRules(std::string_view text);
/// A text of rules with its comments blanked, so that places in it stay.
std::string BlankComments(std::string text);
/// Reads clauses alone: "(<in> ^agent <a>)".
std::vector<RuleAttribute> ReadConditions(std::string_view text);
/// "<s>"
bool IsVariable(std::string_view word);
/// All variables in a text, in order, each as often as it is there.
std::vector<std::string> VariablesIn(std::string_view text);
/// <h*1>: a kernel made it up for a dot or a test; authors' own hold no star before a number.
bool IsMadeUpVariable(std::string_view variable);
/// True if what the rule makes lasts only while it matches. False for rules that test the operator that is selected in
/// their own state.
bool IsElaboration(const RuleText& rule);
bool IsConstantAttribute(std::string_view attribute);
/// Attributes that the architecture, its memories and the world themselves make: "superstate", "retrieved", "status",
/// ...
bool IsArchitectureAttribute(std::string_view attribute);
/// True if a rule tests what was recalled: memories may hold attributes that no rule and no percept makes.
bool TestsWhatWasRecalled(const RuleText& rule);

}  // namespace soarbox::explain
