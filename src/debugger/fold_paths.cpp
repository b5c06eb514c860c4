// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/fold_paths.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace soarbox::debugger {
namespace {

/// The parts of "(<s> ^attribute value)".
struct Parts {
  std::string before;  ///< "(", "-(" or "(state ".
  std::string id, attribute, value;
};

std::optional<Parts> TakeApart(const std::string& text) {
  const std::size_t caret = text.find(" ^");
  const std::size_t open = text.find('(');
  if (caret == std::string::npos || open == std::string::npos || open > caret || text.back() != ')')
    return std::nullopt;
  if (text.find(" ^", caret + 1) != std::string::npos)
    return std::nullopt;  // Several attributes: the kernel generates none.
  Parts parts;
  const std::size_t id = text.rfind(' ', caret - 1);
  const std::size_t begin = id == std::string::npos || id < open ? open + 1 : id + 1;
  parts.before = text.substr(0, begin);
  parts.id = text.substr(begin, caret - begin);
  const std::string rest = text.substr(caret + 2, text.size() - caret - 3);
  const std::size_t gap = rest.find(' ');
  parts.attribute = rest.substr(0, gap);
  if (gap != std::string::npos) parts.value = rest.substr(gap + 1);
  return parts;
}

/// Whether the kernel generated a variable: <h*12>.
bool IsGiven(const std::string& word) {
  const std::size_t star = word.rfind('*');
  return word.size() > 4 && word.front() == '<' && word.back() == '>' && star != std::string::npos &&
         star + 2 < word.size() &&
         std::all_of(word.begin() + static_cast<std::ptrdiff_t>(star) + 1, word.end() - 1,
                     [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// Removes generated variables: "{ < 10 <h*1> }" is converted to "< 10". Removes braces with a single test.
std::string WithoutGiven(const std::string& value) {
  if (IsGiven(value)) return {};
  if (value.size() < 4 || value.front() != '{' || value.back() != '}') return value;
  std::istringstream words(value.substr(1, value.size() - 2));
  std::vector<std::string> kept;
  bool is_relation = false;
  std::size_t tests = 0;
  for (std::string word; words >> word;) {
    if (!is_relation && IsGiven(word)) continue;
    tests += !is_relation;
    is_relation = word.find_first_not_of("<>=") == std::string::npos;
    kept.push_back(std::move(word));
  }
  std::string text;
  for (const std::string& word : kept) text += (text.empty() ? "" : " ") + word;
  return tests == 1 ? text : "{ " + text + " }";
}

}  // namespace

explain::MatchFacts FoldPaths(explain::MatchFacts facts) {
  std::vector<std::optional<Parts>> all;
  std::map<std::string, std::size_t> uses;
  for (const explain::ConditionFact& condition : facts.conditions) {
    all.push_back(TakeApart(condition.text));
    if (all.back()) ++uses[all.back()->id];
  }
  std::map<std::string, std::pair<std::string, std::string>> paths;  // By generated variable: the variable and the path
                                                                     // that lead to it.
  std::vector<explain::ConditionFact> folded;
  std::optional<std::size_t> failing;
  for (std::size_t i = 0; i < facts.conditions.size(); ++i) {
    explain::ConditionFact& condition = facts.conditions[i];
    const bool is_failing = facts.failing == i;
    if (const std::optional<Parts>& found = all[i]) {
      Parts parts = *found;
      if (const auto path = paths.find(parts.id); path != paths.end()) {
        parts.id = path->second.first;
        parts.attribute = path->second.second + "." + parts.attribute;
      }
      const bool leads_on = !condition.negated && IsGiven(parts.value) && uses[parts.value] > 0;
      if (leads_on) paths[parts.value] = {parts.id, parts.attribute};
      if (leads_on && !is_failing) continue;
      const std::string value = WithoutGiven(parts.value);
      condition.text = parts.before + parts.id + " ^" + parts.attribute + (value.empty() ? "" : " " + value) + ")";
    }
    if (is_failing) failing = folded.size();
    folded.push_back(std::move(condition));
  }
  facts.conditions = std::move(folded);
  facts.failing = failing;
  return facts;
}

}  // namespace soarbox::debugger
