// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/watch.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <sstream>
#include <vector>

#include "debugger/memory.h"
#include "debugger/operators.h"
#include "debugger/rules.h"
#include "debugger/stack_rows.h"
#include "explain/rule_text.h"

namespace soarbox::debugger {
namespace {

constexpr std::size_t kMostValues = 50, kDeepest = 6;
const char* const kForms =
    "a watch is a path (io.input-link.self.health), print ID [-d N], print RULE, preferences, matches RULE or stack";

std::vector<std::string> WordsOf(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(std::move(word));
  return words;
}

std::string Upper(std::string id) {
  if (!id.empty()) id[0] = static_cast<char>(id[0] >= 'a' && id[0] <= 'z' ? id[0] - 'a' + 'A' : id[0]);
  return id;
}

/// An identifier that is written as "s1" or "S1", or as <s>, <ts> or <o>; empty if the word is neither.
std::string IdOf(explain::Inspector& mind, const std::string& word) {
  if (explain::IsIdentifier(Upper(word))) return Upper(word);
  if (word != "<ts>" && word != "<s>" && word != "<o>") return {};
  const std::vector<explain::StateFact> stack = mind.Stack();
  if (stack.empty()) return {};
  if (word == "<ts>") return stack.front().id;
  if (word == "<s>") return stack.back().id;
  const auto has_operator = [](const explain::StateFact& state) { return !state.operator_id.empty(); };
  const auto state = std::find_if(stack.rbegin(), stack.rend(), has_operator);
  return state == stack.rend() ? std::string() : state->operator_id;
}

/// All values at the end of a path, each once, in the order of memory.
std::string ValuesAt(explain::Inspector& mind, std::string_view path) {
  const std::size_t first_dot = path.find('.');
  const std::string first(path.substr(0, first_dot));
  const std::string root = IdOf(mind, first);
  std::vector<std::string> at{root.empty() ? IdOf(mind, "<ts>") : root};
  if (!root.empty() && first_dot == std::string_view::npos) return root;
  if ((first == "<o>" || first == "<s>") && root.empty()) return {};
  std::size_t begin = root.empty() ? 0 : first_dot + 1;
  while (begin <= path.size()) {
    const std::size_t end = std::min(path.find('.', begin), path.size());
    std::string_view attribute = path.substr(begin, end - begin);
    if (attribute.starts_with('^')) attribute.remove_prefix(1);
    std::vector<std::string> next;
    for (const std::string& id : at) {
      for (const explain::ElementFact& element : mind.ElementsOf(id)) {
        if (element.attribute != attribute || element.acceptable || next.size() >= kMostValues) continue;
        if (std::find(next.begin(), next.end(), element.value) == next.end()) next.push_back(element.value);
      }
    }
    at = std::move(next);
    begin = end + 1;
  }
  std::string text;
  for (const std::string& value : at) text += (text.empty() ? "" : ", ") + value;
  return text;
}

WatchValue Print(explain::Inspector& mind, const std::vector<std::string>& words) {
  std::size_t depth = 1;
  std::string what;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if ((words[i] == "-d" || words[i] == "--depth") && i + 1 < words.size()) {
      const std::string& number = words[++i];
      std::from_chars(number.data(), number.data() + number.size(), depth);
    } else if (!words[i].starts_with('-')) {
      what = words[i];
    }
  }
  if (const std::string id = IdOf(mind, what); !id.empty()) {
    const MemoryObject object = LookAtObject(mind, id, {}, std::clamp<std::size_t>(depth, 1, kDeepest));
    return {object.exists ? ToText(object) : std::string(), false};
  }
  const std::string source = mind.RuleSource(what);
  if (!source.empty()) return {source, false};
  const std::vector<std::string> near = NearRules(mind, what, 1);
  return {"there is neither an identifier nor a rule " + what + (near.empty() ? "" : "; did you mean " + near[0] + "?"),
          true};
}

std::string WithoutEndings(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == ' ')) text.pop_back();
  return text;
}

}  // namespace

std::string WatchFault(std::string_view what) {
  const std::vector<std::string> words = WordsOf(what);
  if (words.empty()) return kForms;
  const bool needs_name = words[0] == "print" || words[0] == "p" || words[0] == "matches";
  if (needs_name) return words.size() < 2 ? words[0] + " needs an identifier or a rule" : std::string();
  if (words[0] == "preferences" || words[0] == "stack") return {};
  return words.size() > 1 ? "'" + words[0] + " ...' cannot be watched: " + kForms : std::string();
}

WatchValue LookAtWatch(explain::Inspector& mind, std::string_view what) {
  if (std::string fault = WatchFault(what); !fault.empty()) return {std::move(fault), true};
  const std::vector<std::string> words = WordsOf(what);
  if (words[0] == "print" || words[0] == "p") {
    WatchValue value = Print(mind, words);
    value.text = WithoutEndings(std::move(value.text));
    return value;
  }
  if (words[0] == "stack") return {WithoutEndings(ToText(LookAtStack(mind))), false};
  if (words[0] == "preferences") {
    const std::string state = words.size() > 1 ? IdOf(mind, words[1]) : std::string();
    return {WithoutEndings(ToText(LookAtOperators(mind, state))), false};
  }
  if (words[0] == "matches") {
    const auto match = LookAtMatch(mind, words[1]);
    if (!match) return {"there is no rule " + words[1], true};
    return {match->sentence, false};
  }
  return {ValuesAt(mind, words[0]), false};
}

}  // namespace soarbox::debugger
