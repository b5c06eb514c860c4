// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::explain {

/// One attribute of a clause of a rule, as a kernel prints it. Paths with dots are already expanded.
struct RuleAttribute {
  std::string id;         ///< The clause's variable, "<s>".
  std::string attribute;  ///< Without the ^; a variable or a list of tests if it is not a constant.
  std::string value;      ///< Everything after the attribute: "<o> +".
  bool negated = false;
  bool on_state = false;  ///< The clause begins with the word `state`.
  bool in_group = false;  ///< For a condition: it belongs to a group -{ ... } with several conditions, or to a negated
                          ///< clause.
  bool removes = false;   ///< For an action: the value is followed by the sign - alone.
};

/// A call of a function in a rule's actions.
struct RuleCall {
  std::string function;
  std::vector<std::string> arguments;  ///< As they are printed; "(" for a nested call.
};

/// Paths by the variable that they lead to. A path is a list of attributes that begins at the state.
using PathMap = std::map<std::string, std::vector<std::string>>;

/// The support that a rule declares for the elements that it makes: :o-support, :i-support, or neither.
enum class RuleSupport : std::uint8_t { kByConditions, kOSupport, kISupport };

/// The content of a rule that reasons and checks need.
struct RuleText {
  std::string name;
  std::vector<RuleAttribute> conditions, actions;
  PathMap paths;  ///< Paths of the variables in its conditions.

  /// Constant names of the operators that it proposes; contains "" if one of them has no constant name in this rule.
  std::set<std::string> proposes;
  /// Names of the operators whose selection it tests; contains "" if it tests the selection of any operator.
  std::set<std::string> applies;
  /// Names of selected operators in a state above that it works on by proposing other operators in a substate.
  std::set<std::string> works_on;
  /// Attributes that it adds directly to the output link.
  std::set<std::string> says;
  /// Names of the functions that its actions call.
  std::set<std::string> calls;
  /// These calls with their arguments, in order and with repetitions.
  std::vector<RuleCall> all_calls;
  bool acts = false;         ///< It has at least one action.
  bool is_template = false;  ///< It has the flag :template.
  RuleSupport support = RuleSupport::kByConditions;
};

/// Whether a printed value is an identifier: a capital letter and a number.
bool IsIdentifier(std::string_view value);
/// The part of `value` before the first blank.
std::string FirstWord(const std::string& value);
/// "^io.input-link.self", with all steps of a path.
std::string Dotted(const std::vector<std::string>& path);
/// Parses the output of `print --all --full`. Skips text that is not a rule.
std::vector<RuleText> ReadRules(std::string_view text);
/// Replaces the comments in a text of rules by blanks, so that positions stay the same.
std::string BlankComments(std::string text);
/// Parses clauses outside a rule: "(<in> ^agent <a>)".
std::vector<RuleAttribute> ReadConditions(std::string_view text);
/// Whether a word is a variable: "<s>".
bool IsVariable(std::string_view word);
/// All variables in a text, in order and with repetitions.
std::vector<std::string> VariablesIn(std::string_view text);
/// Whether the kernel generated the variable, for a dot or a test: <h*1>. Variables of authors have no star before a
/// number.
bool IsMadeUpVariable(std::string_view variable);
/// Whether what the rule makes lasts only while it matches. False for rules that test the selected operator of their
/// own state.
bool IsElaboration(const RuleText& rule);
bool IsConstantAttribute(std::string_view attribute);
/// Whether the rule proposes a new operator to which it gives no ^name.
bool ProposesWithoutName(const RuleText& rule);
/// Attributes that the architecture, its memories and the world create: "superstate", "retrieved", "status", ...
bool IsArchitectureAttribute(std::string_view attribute);
/// Whether a rule tests a recalled object. Memories may contain attributes that no rule and no percept makes.
bool TestsWhatWasRecalled(const RuleText& rule);

}  // namespace soarbox::explain
