// SPDX-License-Identifier: BSD-2-Clause
// Slips on the links of long-term memory and reward: words that no memory accepts, and links created next to those of
// the agent.
#include <algorithm>

#include "diagnostics/diagnostic.h"
#include "explain/mind_view.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"

namespace soarbox::explain {
namespace {

using NameList = std::vector<std::string_view>;

/// The words of a memory's commands and answers (docs/memory.md).
struct Memory {
  std::string_view link, name;
  NameList commands, answers;
};
const std::vector<Memory>& Memories() {
  static const std::vector<Memory> kMemories = {
      {"smem",
       "semantic memory",
       {"store", "store-new", "retrieve", "query", "neg-query", "math-query", "prohibit", "depth", "link-to-ltm",
        "link-to-new-ltm"},
       {"success", "failure", "bad-cmd", "retrieved", "depth-retrieved"}},
      {"epmem",
       "episodic memory",
       {"store", "retrieve", "next", "previous", "query", "neg-query", "before", "after", "prohibit"},
       {"status", "success", "failure", "retrieved", "memory-id", "present-id", "match-score", "cue-size",
        "normalized-match-score", "match-cardinality", "graph-match", "mapping"}}};
  return kMemories;
}

/// The memory whose link ("command", "result") a path ends at; null if none.
const Memory* MemoryOn(const std::vector<std::string>& path, std::string_view link) {
  if (path.size() < 2 || path.back() != link) return nullptr;
  const auto memory = std::ranges::find(Memories(), path[path.size() - 2], &Memory::link);
  return memory == Memories().end() ? nullptr : &*memory;
}

std::string HintOf(const std::string& word, const NameList& words, std::string_view otherwise) {
  if (const std::string_view near = Suggest(word, words); !near.empty())
    return "did you mean ^" + std::string(near) + "?";
  std::string hint(otherwise);
  for (const std::string_view one : words) hint += (one == words.front() ? " ^" : ", ^") + std::string(one);
  return hint;
}

void FindUnknownWords(const RuleText& rule, std::vector<Slip>& slips) {
  const PathMap& paths = rule.paths;
  for (const RuleAttribute& action : rule.actions) {
    const auto path = paths.find(action.id);
    const Memory* const memory = path == paths.end() ? nullptr : MemoryOn(path->second, "command");
    if (memory == nullptr || !IsConstantAttribute(action.attribute)) continue;
    if (std::ranges::find(memory->commands, action.attribute) != memory->commands.end()) continue;
    slips.push_back({rule.name, action.attribute, true,
                     "rule " + rule.name + " asks " + std::string(memory->name) + " by ^" + action.attribute +
                         ", which is not one of its commands: the entire command is refused",
                     HintOf(action.attribute, memory->commands, "its commands are"), true});
  }
  for (const RuleAttribute& condition : rule.conditions) {
    const auto path = paths.find(condition.id);
    const Memory* const memory = path == paths.end() ? nullptr : MemoryOn(path->second, "result");
    if (memory == nullptr || !IsConstantAttribute(condition.attribute)) continue;
    if (std::ranges::find(memory->answers, condition.attribute) != memory->answers.end()) continue;
    slips.push_back({rule.name, condition.attribute, true,
                     "rule " + rule.name + " tests ^" + condition.attribute + ", which " + std::string(memory->name) +
                         " never answers",
                     HintOf(condition.attribute, memory->answers, "it answers with")});
  }
}

/// A reward that is not a number, or that is not on the reward link.
void FindOddRewards(const RuleText& rule, std::vector<Slip>& slips) {
  const PathMap& paths = rule.paths;
  std::set<std::string> rewards;
  for (const RuleAttribute& action : rule.actions) {
    const auto path = paths.find(action.id);
    if (path == paths.end() || path->second.empty() || path->second.back() != "reward-link") continue;
    if (action.attribute == "reward") {
      rewards.insert(FirstWord(action.value));
    } else if (IsConstantAttribute(action.attribute)) {
      slips.push_back(
          {rule.name, action.attribute, true,
           "rule " + rule.name + " puts ^" + action.attribute + " on the reward link, where only ^reward counts",
           "(<link> ^reward.value 1)", true});
    }
  }
  for (const RuleAttribute& action : rule.actions) {
    if (!rewards.contains(action.id) || action.attribute != "value") continue;
    const std::string word = FirstWord(action.value);
    if (word.empty() || IsVariable(word) || word.front() == '(') continue;
    if (IsNumber(std::string_view(word).substr(word.starts_with('+') ? 1 : 0))) continue;
    slips.push_back({rule.name, word, false,
                     "rule " + rule.name + " gives " + word + " as a reward, which is not a number: it does not count",
                     "a reward is a number, such as ^value 1 or ^value -0.5", true});
  }
}

/// "(<s> ^reward-link.reward.value 1)": a path in an action creates a second link, which is never read.
void FindSecondMemories(const RuleText& rule, std::vector<Slip>& slips) {
  const std::set<std::string> states = StatesOf(rule);
  for (const RuleAttribute& action : rule.actions) {
    const std::string& link = action.attribute;
    if (!states.contains(action.id) || (link != "reward-link" && link != "smem" && link != "epmem")) continue;
    if (IsBoundByConditions(rule, FirstWord(action.value)) || action.removes) continue;
    const bool is_reward = link == "reward-link";
    slips.push_back({rule.name, link, true,
                     "rule " + rule.name + " makes a second ^" + link +
                         " on its state: a path in an action makes new objects, so this " +
                         (is_reward ? "gives no reward" : "asks nothing"),
                     is_reward
                         ? "bind the link in a condition, (state <s> ^reward-link <r>), and write (<r> ^reward.value 1)"
                         : "bind the link in a condition, (state <s> ^" + link + ".command <c>), and write on <c>",
                     true});
    return;
  }
}

bool GivesReward(const RuleText& rule) {
  const PathMap& paths = rule.paths;
  return std::ranges::any_of(rule.actions, [&](const RuleAttribute& action) {
    const auto path = paths.find(action.id);
    return action.attribute == "reward" && path != paths.end() && !path->second.empty() &&
           path->second.back() == "reward-link";
  });
}

/// The number of "<o> = 0.500000" as one would write it, "0.5"; empty if there is none.
std::string NumericValue(const RuleAttribute& action) {
  const std::size_t sign = action.value.rfind("= ");
  if (action.attribute != "operator" || sign == std::string::npos) return {};
  std::string word = FirstWord(action.value.substr(sign + 2));
  if (!IsNumber(word)) return {};
  if (const std::size_t point = word.find('.'); point != std::string::npos)
    word.erase(std::max(word.find_last_not_of('0') + 1, point + 2));
  return word;
}

/// Finds numeric preferences in rules with other actions, if some rule gives reward. Reward does not change such a
/// number: only a rule with one action learns.
void FindNumbersThatStay(const std::vector<RuleText>& rules, std::vector<Slip>& slips) {
  if (std::ranges::none_of(rules, GivesReward)) return;
  for (const RuleText& rule : rules) {
    const auto numeric =
        std::ranges::find_if(rule.actions, [](const auto& action) { return !NumericValue(action).empty(); });
    if (numeric == rule.actions.end() || rule.actions.size() == 1) continue;
    slips.push_back(
        {rule.name, NumericValue(*numeric), false,
         "rule " + rule.name + " gives an operator the number " + NumericValue(*numeric) +
             " and has other actions, so that reward does not change the number",
         "give it in a rule of its own, which tests the proposal, (<s> ^operator <o> +), and has one action: (<s> "
         "^operator <o> = " +
             NumericValue(*numeric) + ")",
         true});
  }
}

/// Finds templates whose conditions bind only objects. Such a template has no values to make different rules for.
void FindEmptyTemplates(const RuleText& rule, std::vector<Slip>& slips) {
  if (!rule.is_template) return;
  const bool has_value = std::ranges::any_of(rule.conditions, [&](const RuleAttribute& condition) {
    if (condition.negated) return false;
    const std::vector<std::string> bound = VariablesIn(condition.value + " " + condition.attribute);
    return std::ranges::any_of(bound, [&](const std::string& variable) {
      return std::ranges::find(rule.conditions, variable, &RuleAttribute::id) == rule.conditions.end() &&
             condition.attribute != "operator";
    });
  });
  if (has_value) return;
  slips.push_back(
      {rule.name, "", false,
       "template " + rule.name + " has no variable for a value, so there are no values to make rules for",
       "a template makes one rule for each combination of the values that its variables find: test what the "
       "numbers depend on, such as (<o> ^name go ^to <place>)"});
}

}  // namespace

bool IsMemoryAnswer(const std::vector<std::string>& path) {
  return MemoryOn(path, "result") != nullptr;
}

std::vector<Slip> FindSlipsOfMemory(const std::vector<RuleText>& rules) {
  std::vector<Slip> slips;
  for (const RuleText& rule : rules) {
    FindUnknownWords(rule, slips);
    FindOddRewards(rule, slips);
    FindSecondMemories(rule, slips);
    FindEmptyTemplates(rule, slips);
  }
  FindNumbersThatStay(rules, slips);
  return slips;
}

}  // namespace soarbox::explain
