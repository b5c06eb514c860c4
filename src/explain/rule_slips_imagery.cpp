// SPDX-License-Identifier: BSD-2-Clause
// Slips in commands to the spatial visual system: unknown commands and filters, missing or unknown parameters, and
// nodes that no rule creates. The kernel lists the valid ones (svs commands all).
#include <algorithm>
#include <cctype>

#include "diagnostics/diagnostic.h"
#include "explain/rule_slips.h"
#include "explain/slip_words.h"

namespace soarbox::explain {
namespace {

using Parameter = SceneKinds::Parameter;
using SceneKind = SceneKinds::Kind;

std::vector<std::string_view> KindNames(const std::vector<SceneKind>& kinds) {
  std::vector<std::string_view> names;
  for (const SceneKind& kind : kinds) names.emplace_back(kind.name);
  return names;
}

const SceneKind* Find(const std::vector<SceneKind>& kinds, std::string_view name) {
  const auto found = std::ranges::find(kinds, name, &SceneKind::name);
  return found == kinds.end() ? nullptr : &*found;
}

std::string ListOf(const std::vector<std::string_view>& words, std::string_view mark) {
  std::string list;
  for (const std::string_view word : words) list += (list.empty() ? " " : ", ") + std::string(mark) + std::string(word);
  return list;
}

/// The value as a constant without bars; empty if it is not a constant.
std::string SoleConstant(const std::string& value) {
  if (value.empty() || value.find_first_of("<{(") == 0 || value.ends_with(" -")) return {};
  if (value.size() > 2 && value.front() == '|' && value.back() == '|') return value.substr(1, value.size() - 2);
  return FirstWord(value);
}

/// Whether two names differ in more than their digits.
bool DifferInLetters(std::string_view a, std::string_view b) {
  const auto letters = [](std::string_view name) {
    std::string found;
    for (const char c : name) {
      if (std::isdigit(static_cast<unsigned char>(c)) == 0) found += c;
    }
    return found;
  };
  return letters(a) != letters(b);
}

bool EndsWith(const std::vector<std::string>& path, std::initializer_list<std::string_view> end) {
  return path.size() >= end.size() && std::equal(end.begin(), end.end(), path.end() - static_cast<long>(end.size()));
}

class SceneChecker {
 public:
  SceneChecker(const std::vector<RuleText>& rules, const SceneKinds& kinds) : rules_(rules), kinds_(kinds) {
    for (const RuleText& rule : rules) NoteNodes(rule);
  }

  std::vector<Slip> slips;

  void Check(const RuleText& rule) {
    for (const RuleAttribute& action : rule.actions) {
      if (!IsOnCommandLink(rule, action) || !IsConstantAttribute(action.attribute) || action.removes) continue;
      const SceneKind* const kind = Find(kinds_.commands, action.attribute);
      if (kind == nullptr) {
        const std::vector<std::string_view> names = KindNames(kinds_.commands);
        const std::string_view near = Suggest(action.attribute, names);
        Tell(rule, action.attribute, true,
             "rule " + rule.name + " gives ^" + action.attribute +
                 ", a command that the spatial visual system does not know",
             near.empty() ? "its commands are" + ListOf(names, "^") : "did you mean ^" + std::string(near) + "?");
      } else if (!IsVariable(FirstWord(action.value))) {
        Tell(rule, action.attribute, true, "rule " + rule.name + " gives ^" + action.attribute + " without an object",
             "(<c> ^" + action.attribute + " <x>) (<x> ^" +
                 (kind->parameters.empty() ? "id" : kind->parameters[0].name) + " ...)");
      } else if (kind->name.starts_with("extract")) {
        CheckFilter(rule, FirstWord(action.value), action.attribute, 0);
      } else {
        CheckParameters(rule, FirstWord(action.value), *kind, "command " + kind->name);
      }
    }
  }

 private:
  static constexpr int kDeepest = 20;

  static bool IsOnCommandLink(const RuleText& rule, const RuleAttribute& action) {
    const auto path = rule.paths.find(action.id);
    return path != rule.paths.end() && EndsWith(path->second, {"svs", "command"});
  }

  void Tell(const RuleText& rule, const std::string& word, bool is_attribute, std::string message, std::string hint) {
    slips.push_back({rule.name, word, is_attribute, std::move(message), std::move(hint), true});
  }

  static const RuleAttribute* FindAction(const RuleText& rule, std::string_view id, std::string_view attribute) {
    for (const RuleAttribute& action : rule.actions) {
      if (action.id == id && action.attribute == attribute) return &action;
    }
    return nullptr;
  }

  /// Whether the object may have further attributes: it is bound elsewhere, or has variable attributes.
  static bool IsOpen(const RuleText& rule, const std::string& id) {
    return IsBoundByConditions(rule, id) || std::ranges::any_of(rule.actions, [&](const RuleAttribute& action) {
             return action.id == id && !IsConstantAttribute(action.attribute);
           });
  }

  /// Whether other rules may add to a command that they find on the link.
  bool OthersAdd(const RuleText& rule) const {
    return std::ranges::any_of(rules_, [&](const RuleText& other) {
      return &other != &rule && std::ranges::any_of(other.actions, [&](const RuleAttribute& action) {
        const auto path = other.paths.find(action.id);
        if (path == other.paths.end()) return false;
        const auto link = std::ranges::find(path->second, "svs");
        return link != path->second.end() && path->second.end() - link > 2;
      });
    });
  }

  void CheckFilter(const RuleText& rule, const std::string& id, const std::string& what, int depth) {
    if (depth > kDeepest) return;
    const RuleAttribute* const type = FindAction(rule, id, "type");
    if (type == nullptr) {
      if (IsOpen(rule, id) || OthersAdd(rule)) return;
      Tell(rule, what, true,
           "rule " + rule.name + " gives ^" + what + " " + id + " without a ^type: it is not a filter",
           "name a filter, such as (" + id + " ^type all_nodes)");
      return;
    }
    const std::string name = SoleConstant(type->value);
    if (name.empty()) return;
    const SceneKind* const kind = Find(kinds_.filters, name);
    if (kind == nullptr) {
      const std::string_view near = Suggest(name, KindNames(kinds_.filters));
      Tell(rule, name, false, "rule " + rule.name + " asks for the filter " + name + ", which does not exist",
           near.empty() ? "the filters are" + ListOf(KindNames(kinds_.filters), "")
                        : "did you mean " + std::string(near) + "?");
      return;
    }
    CheckParameters(rule, id, *kind, "filter " + kind->name);
    for (const RuleAttribute& action : rule.actions) {
      if (action.id != id || !IsVariable(action.value) || IsBoundByConditions(rule, action.value)) continue;
      const auto known = std::ranges::find(kind->parameters, action.attribute, &Parameter::name);
      if (known == kind->parameters.end() ? kind->name == "combine_nodes" : known->form == "nodes")
        CheckFilter(rule, action.value, action.attribute, depth + 1);
    }
  }

  void CheckParameters(const RuleText& rule, const std::string& id, const SceneKind& kind, const std::string& what) {
    std::vector<std::string_view> names;
    for (const Parameter& parameter : kind.parameters) names.emplace_back(parameter.name);
    std::set<std::string> given, misspelt;
    for (const RuleAttribute& action : rule.actions) {
      if (action.id != id || !IsConstantAttribute(action.attribute) || action.removes) continue;
      given.insert(action.attribute);
      const auto known = std::ranges::find(kind.parameters, action.attribute, &Parameter::name);
      if (known != kind.parameters.end()) {
        CheckValue(rule, action, *known, what);
        continue;
      }
      // An unknown parameter of a filter has no effect.
      if (action.attribute == "type" || action.attribute == "input-type" || kind.name == "combine_nodes") continue;
      const std::string_view near = Suggest(action.attribute, names);
      if (near.empty() || FindAction(rule, id, near) != nullptr) continue;
      misspelt.emplace(near);
      Tell(rule, action.attribute, true, "rule " + rule.name + ": " + what + " has no parameter ^" + action.attribute,
           "did you mean ^" + std::string(near) + "?");
    }
    if (IsOpen(rule, id) || OthersAdd(rule)) return;
    for (const Parameter& parameter : kind.parameters) {
      if (!parameter.required || given.contains(parameter.name) || misspelt.contains(parameter.name)) continue;
      if (kind.name == "combine_nodes") continue;  // Its parameters may have any names.
      Tell(rule, what.substr(what.find(' ') + 1), what.starts_with("command"),
           "rule " + rule.name + ": " + what + " lacks ^" + parameter.name,
           parameter.form == "nodes"
               ? "(" + id + " ^" + parameter.name + " <n>) (<n> ^type all_nodes), or another filter that gives nodes"
               : "^" + parameter.name + " is " + parameter.meaning);
    }
  }

  void CheckValue(const RuleText& rule, const RuleAttribute& action, const Parameter& parameter,
                  const std::string& what) {
    const std::string word = SoleConstant(action.value);
    if (word.empty()) return;
    const std::string begin = "rule " + rule.name + ": ";
    const bool is_number = IsNumber(word) && action.value.front() != '|';
    if (parameter.form == "nodes") {
      Tell(rule, action.attribute, true,
           begin + "^" + parameter.name + " of " + what + " is a filter that gives nodes, not the word " + word,
           "(" + action.id + " ^" + parameter.name + " <n>) (<n> ^type node ^id " + word + ")");
    } else if (parameter.form == "object") {
      Tell(rule, action.attribute, true, begin + "^" + parameter.name + " of " + what + " is an object, not " + word,
           parameter.name == "tags" ? "(<t> ^color red): its attributes become tags"
                                    : "it has three numbers: (<p> ^x 1 ^y 0 ^z 0)");
    } else if (parameter.form == "number") {
      if (!is_number)
        Tell(rule, action.attribute, true, begin + "^" + parameter.name + " of " + what + " is a number, not " + word,
             "^" + parameter.name + " is " + parameter.meaning);
    } else if (is_number && what.find("axis") == std::string::npos) {
      Tell(rule, action.attribute, true,
           begin + "^" + parameter.name + " of " + what + " is a word: a number counts as missing",
           "write it between bars: ^" + parameter.name + " |" + word + "|");
    } else if (parameter.form != "word") {
      CheckChoice(rule, action, parameter, what, word);
    } else if (parameter.name == "source" || parameter.name == "destination" || parameter.name == "parent" ||
               (parameter.name == "id" && what != "command add_node" && what != "command copy_node")) {
      CheckNode(rule, word);
    }
  }

  void CheckChoice(const RuleText& rule, const RuleAttribute& action, const Parameter& parameter,
                   const std::string& what, const std::string& word) {
    std::vector<std::string_view> choices;
    std::string_view rest = parameter.form;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find('|'), rest.size());
      choices.push_back(rest.substr(0, end));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    const bool is_axis = parameter.name == "axis" && word.find_first_of("xyzXYZ012") == 0;
    if (is_axis || std::ranges::find(choices, word) != choices.end()) return;
    const std::string_view near = Suggest(word, choices);
    Tell(rule, word, false, "rule " + rule.name + ": ^" + parameter.name + " of " + what + " cannot be " + word,
         near.empty() ? "it is one of" + ListOf(choices, "") : "did you mean " + std::string(near) + "?");
    (void)action;
  }

  /// Reports a node that no rule creates, if its name is similar to a node that rules create. Other sources of nodes
  /// are not known here.
  void CheckNode(const RuleText& rule, const std::string& word) {
    if (names_vary_ || made_.contains(word)) return;
    const std::string_view near = Suggest(word, {made_.begin(), made_.end()});
    if (near.empty() || !DifferInLetters(near, word)) return;
    Tell(rule, word, false, "rule " + rule.name + " names the node " + word + ", which no rule makes",
         "did you mean " + std::string(near) + "?");
  }

  void NoteNodes(const RuleText& rule) {
    for (const RuleAttribute& action : rule.actions) {
      if (!IsOnCommandLink(rule, action) || (action.attribute != "add_node" && action.attribute != "copy_node"))
        continue;
      const RuleAttribute* const id = FindAction(rule, FirstWord(action.value), "id");
      if (id == nullptr) continue;
      const std::string name = SoleConstant(id->value);
      names_vary_ |= name.empty();
      if (!name.empty()) made_.insert(name);
    }
  }

  const std::vector<RuleText>& rules_;
  const SceneKinds& kinds_;
  std::set<std::string> made_ = {"world", "self", "eye", "reach"};  ///< Nodes that rules or the world create.
  bool names_vary_ = false;
};

}  // namespace

bool MentionsScenes(const std::vector<RuleText>& rules) {
  return std::ranges::any_of(rules, [](const RuleText& rule) {
    return std::ranges::any_of(rule.conditions, [](const RuleAttribute& one) { return one.attribute == "svs"; });
  });
}

bool IsBelowScene(const std::vector<std::string>& path) {
  return std::ranges::find(path, "svs") != path.end();
}

SceneKinds ReadSceneKinds(std::string_view text) {
  SceneKinds kinds;
  std::vector<SceneKind>* list = nullptr;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const std::size_t colon = line.find(": ");
    if (colon == std::string_view::npos) continue;
    const std::string meaning(line.substr(colon + 2));
    if (line.starts_with("  ")) {
      const std::size_t blank = line.find(' ', 2);
      if (list == nullptr || list->empty() || blank > colon) continue;
      std::string_view name = line.substr(2, blank - 2);
      const bool required = name.front() == '^';
      if (!required) name = name.substr(1, name.size() - 2);
      if (name.size() < 2) continue;
      list->back().parameters.push_back(
          {std::string(name.substr(1)), std::string(line.substr(blank + 1, colon - blank - 1)), meaning, required});
      continue;
    }
    const std::size_t blank = line.find(' ');
    const std::string_view what = line.substr(0, blank);
    list = what == "command" ? &kinds.commands : what == "filter" ? &kinds.filters : nullptr;
    if (list != nullptr) list->push_back({std::string(line.substr(blank + 1, colon - blank - 1)), {}});
  }
  return kinds;
}

std::vector<Slip> FindSlipsOfImagery(const std::vector<RuleText>& rules, const SceneKinds& kinds) {
  if (kinds.commands.empty()) return {};
  SceneChecker checker(rules, kinds);
  for (const RuleText& rule : rules) checker.Check(rule);
  return std::move(checker.slips);
}

}  // namespace soarbox::explain
