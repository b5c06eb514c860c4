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
  std::string word;           ///< Where in the rule: this word; empty: its name.
  bool is_attribute = false;  ///< The word comes after ^ or a dot.
  std::string message, hint;
  bool in_actions = false;  ///< The word comes after -->.
};

/// The places of a world by name. Rules of no world in particular may name any.
struct KnownPlaces {
  bool is_known = false;
  std::set<std::string> waypoints, regions;
};

/// What you can tell and ask the spatial visual system, as the kernel lists it; nothing if the kernel lists nothing.
struct SceneKinds {
  struct Parameter {
    std::string name;
    std::string form;  ///< "nodes", "number", "object", "word", or the words that it may be: "centroid|hull".
    std::string meaning;
    bool required = false;
  };
  struct Kind {
    std::string name;
    std::vector<Parameter> parameters;
  };
  std::vector<Kind> commands, filters;
};
/// Reads what `svs commands all` prints.
SceneKinds ReadSceneKinds(std::string_view text);
/// Whether rules test ^svs at all.
bool MentionsScenes(const std::vector<RuleText>& rules);
/// True if a path goes through ^svs: tags and answers there may have any name.
bool IsBelowScene(const std::vector<std::string>& path);

/// What rules may test and give besides the vocabulary.
struct KnownWords {
  std::set<std::string> attributes;  ///< That rules, scripts, messages and facts make.
  std::set<std::string> scripts;     ///< All words of scripts beside the rules: percepts and commands of their own.
  KnownPlaces places = {};
  bool has_database = false;               ///< What is recalled may have any attribute.
  bool complete = true;                    ///< All rules loaded; else what is missing may be in those that did not.
  SceneKinds scene = {};                   ///< Needed only if rules mention scenes.
  std::set<std::string> made_values = {};  ///< "attribute value": what actions of any rule of the folder make.
  bool own_world = false;  ///< A game with percepts and commands of its own: the vocabulary says nothing of them.
};

/// Slips of form, which need no knowledge of the world: no state, variables that nothing links, words that look like
/// half a variable, and relations or functions that do not exist.
std::vector<Slip> FindSlipsOfForm(const std::vector<RuleText>& rules);

/// Slips against the vocabulary: attributes that nothing writes or that are elsewhere, words that a percept never has,
/// commands and parameters that no body knows, operators that nothing applies.
std::vector<Slip> FindSlipsOfMeaning(const std::vector<RuleText>& rules, const KnownWords& known);

/// Slips in the use of Soar itself: operators that are words or have no name or two, a second ^io, values that pile up,
/// paths that may lead to different objects, words that no state has, variables that only a negation binds.
std::vector<Slip> FindSlipsOfUse(const std::vector<RuleText>& rules);

/// Slips in what rules do together: what a rule makes or removes takes its own reason away, paths that lead to
/// different objects of a rule's own, values that no rule makes, variables that nothing binds, applications that cannot
/// fire.
std::vector<Slip> FindSlipsOfLogic(const std::vector<RuleText>& rules, const KnownWords& known);

/// Slips on the links of long-term memory and reward: words that no memory knows, rewards that are no numbers, links
/// that an action makes beside the agent's own.
std::vector<Slip> FindSlipsOfMemory(const std::vector<RuleText>& rules);
/// True if a path ends where a memory answers: "smem", "result".
bool IsMemoryAnswer(const std::vector<std::string>& path);

/// Slips in what rules tell and ask the spatial visual system: commands, filters and parameters that do not exist or
/// lack something, and nodes that nobody makes.
std::vector<Slip> FindSlipsOfImagery(const std::vector<RuleText>& rules, const SceneKinds& kinds);

/// Slips against how the world behaves: proposals that rest on numbers that change all the time, writing on the input
/// link, places that the scenario does not have.
std::vector<Slip> FindSlipsOfWorld(const std::vector<RuleText>& rules, const KnownWords& known);

/// Says once that rules seem to be written for another world, if this one knows hardly any of the percepts that they
/// test; then the vocabulary says nothing of them. Nothing otherwise.
std::optional<Slip> FindOtherWorld(const std::vector<RuleText>& rules, const KnownWords& known);

/// What all these searches find, one after the other.
std::vector<Slip> FindSlips(const std::vector<RuleText>& rules, const KnownWords& known);

/// The slip as a warning at its place in the text of the file (comments blanked). Without a place if the rule is not
/// there.
Diagnostic PlaceSlip(const Slip& slip, const std::filesystem::path& file, const std::string& text);

/// A file of rules, with comments blanked.
struct RuleFile {
  std::filesystem::path file;
  std::string text;
};
/// Rules that replace one of the same name in the same file or in one before it, as warnings at the later one.
std::vector<Diagnostic> FindDuplicates(const std::vector<RuleFile>& files);

/// What to do about an operator that no rule applies, as a sentence.
std::string HowToApply(const std::vector<RuleText>& rules, const std::string& name);
/// "^io.input-link.self.health, ...": where percepts of this name are; empty if there are none.
std::string PlacesOfPercept(const std::string& attribute);
/// The words that a percept of this name may be, "none ready ..."; empty if it is none, or may be any word.
std::vector<std::string_view> WordsOfPercept(const std::string& attribute);

}  // namespace soarbox::explain
