// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_text.h"

namespace soarbox::explain {

/// Something in a rule that loads but is most likely not what its author meant.
struct Slip {
  std::string rule;
  std::string word;           ///< The word of the rule that it is about; empty: the rule's name.
  bool is_attribute = false;  ///< The word comes after ^ or a dot.
  std::string message, hint;
  bool in_actions = false;  ///< The word comes after -->.
  Topic topic = Topic::kOther;
  std::string meant = {};   ///< The attribute that was probably meant; may be empty.
  std::string undone = {};  ///< The rule whose additions this rule removes at once; may be empty.
};

/// The names of places of a world. If `is_known` is false, rules may use any name.
struct KnownPlaces {
  bool is_known = false;
  std::set<std::string> waypoints, regions;
};

/// The commands and filters of the spatial visual system, as the kernel lists them; empty if the kernel lists none.
struct SceneKinds {
  struct Parameter {
    std::string name;
    std::string form;  ///< "nodes", "number", "object", "word", or the allowed words: "centroid|hull".
    std::string meaning;
    bool required = false;
  };
  struct Kind {
    std::string name;
    std::vector<Parameter> parameters;
  };
  std::vector<Kind> commands, filters;
};
/// Parses the output of `svs commands all`.
SceneKinds ReadSceneKinds(std::string_view text);
/// Whether any rule tests ^svs.
bool MentionsScenes(const std::vector<RuleText>& rules);
/// Whether a path goes through ^svs. Tags and answers below it may have any name.
bool IsBelowScene(const std::vector<std::string>& path);

/// The words that rules may test and use in addition to the vocabulary.
struct KnownWords {
  std::set<std::string> attributes;  ///< Attributes that rules, scripts, messages and facts add.
  std::set<std::string> scripts;     ///< All words of scripts in the folder of the rules: scripts may define percepts
                                     ///< and commands.
  KnownPlaces places = {};
  bool has_database = false;  ///< Recalled objects may have any attribute.
  bool complete = true;       ///< All rules loaded. If not, an attribute or operator that seems to be missing
                              ///< may be in a rule that did not load.
  SceneKinds scene = {};      ///< Needed only if rules mention scenes.
  std::set<std::string> made_values = {};  ///< "attribute value": values that actions of any rule of the folder make.
  bool own_world = false;  ///< The world is a game with percepts and commands of its own, to which the vocabulary does
                           ///< not apply.
};

/// Finds slips that are visible without the world: no state, variables that no condition links, words that look like
/// half a variable, and relations or functions that do not exist.
std::vector<Slip> FindSlipsOfForm(const std::vector<RuleText>& rules);

/// Finds slips against the vocabulary: attributes that nothing writes or that have another path, words that a percept
/// never has, commands and parameters that no body accepts, operators that no rule applies.
std::vector<Slip> FindSlipsOfMeaning(const std::vector<RuleText>& rules, const KnownWords& known);

/// Finds slips in the use of Soar: operators that are constants or have no name or two names, a second ^io, values that
/// accumulate, paths that may lead to different objects, attributes that no state has, variables that only a negated
/// condition binds.
std::vector<Slip> FindSlipsOfUse(const std::vector<RuleText>& rules);

/// Finds slips in how rules work together: a rule that removes the reason for its own match, paths that lead to
/// different objects that the rule itself creates, values that no rule makes, variables that nothing binds,
/// applications that cannot fire.
std::vector<Slip> FindSlipsOfLogic(const std::vector<RuleText>& rules, const KnownWords& known);

/// Finds rules that take back what they or other rules of the same operator have just made, and sums without brackets.
std::vector<Slip> FindSlipsOfUndoing(const std::vector<RuleText>& rules);

/// Finds conditions about absent elements or values that always hold or never hold.
std::vector<Slip> FindSlipsOfNegation(const std::vector<RuleText>& rules);

/// Finds slips on the links of long-term memory and reward: words that no memory accepts, rewards that are not numbers,
/// links that an action creates next to those of the agent.
std::vector<Slip> FindSlipsOfMemory(const std::vector<RuleText>& rules);
/// Whether a path ends where a memory stores its answer: "smem", "result".
bool IsMemoryAnswer(const std::vector<std::string>& path);

/// Finds slips in commands to the spatial visual system: commands, filters and parameters that do not exist or are
/// incomplete, and nodes that no rule creates.
std::vector<Slip> FindSlipsOfImagery(const std::vector<RuleText>& rules, const SceneKinds& kinds);

/// Finds slips against the behaviour of the world: proposals that depend on numbers that change all the time, actions
/// that write on the input link, places that the scenario does not have.
std::vector<Slip> FindSlipsOfWorld(const std::vector<RuleText>& rules, const KnownWords& known);

/// Reports once that rules seem to be written for another world, if this world has hardly any of the percepts that they
/// test. The vocabulary is then not applied to them. Otherwise returns nothing.
std::optional<Slip> FindOtherWorld(const std::vector<RuleText>& rules, const KnownWords& known);

/// Runs all these searches and returns their findings. Leaves out a finding about a variable if an earlier search found
/// something about the same variable of the rule. Searches for negations only if all rules loaded.
std::vector<Slip> FindSlips(const std::vector<RuleText>& rules, const KnownWords& known);

/// Converts a slip to a warning with its position in the text of the file, in which comments are blanked. The warning
/// has no position if the text does not contain the rule.
Diagnostic PlaceSlip(const Slip& slip, const std::filesystem::path& file, const std::string& text);

/// A file of rules. Its comments are blanked.
struct RuleFile {
  std::filesystem::path file;
  std::string text;
};
/// Returns a warning for each rule that replaces a rule of the same name in the same file or an earlier one, and for
/// each rule that is ignored because it has the text of an earlier one, except for its name. The warning is at the
/// later rule. Also returns a warning for each setting, rl --set, that a later line of the same file changes.
std::vector<Diagnostic> FindDuplicates(const std::vector<RuleFile>& files);

/// Returns a sentence that says how to apply an operator that no rule applies.
std::string HowToApply(const std::vector<RuleText>& rules, const std::string& name);
/// Returns the paths of the percepts of this name: "^io.input-link.self.health, ...". Empty if there are none.
std::string PlacesOfPercept(const std::string& attribute);
/// Returns the words that a percept of this name may have: "none ready ...". Empty if there is no such percept, or if
/// it may have any word.
std::vector<std::string_view> WordsOfPercept(const std::string& attribute);

}  // namespace soarbox::explain
