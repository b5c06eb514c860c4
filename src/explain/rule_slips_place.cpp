// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>

#include "explain/rule_slips.h"

namespace soarbox::explain {
namespace {

constexpr std::size_t kNotThere = std::string::npos;

bool IsBlankAt(std::string_view text, std::size_t at) {
  return at >= text.size() || std::isspace(static_cast<unsigned char>(text[at])) != 0;
}

bool IsNameAt(std::string_view text, std::size_t at) {
  if (at >= text.size()) return false;
  const char c = text[at];
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_' || c == '*';
}

/// Position of a rule's name after its brace.
std::size_t FindNameOfRule(std::string_view text, std::string_view rule) {
  for (std::size_t at = text.find(rule); at != kNotThere; at = text.find(rule, at + 1)) {
    const bool is_whole = IsBlankAt(text, at + rule.size()) || text[at + rule.size()] == '(';
    if (at == 0 || !is_whole) continue;
    const std::size_t brace = text.find_last_not_of(" \t\r\n", at - 1);
    if (brace != kNotThere && text[brace] == '{') return at;
  }
  return kNotThere;
}

/// Position of a word in the rule that begins here; the position of the rule if the word does not occur.
std::size_t FindWord(std::string_view text, std::size_t begin, std::string_view word, bool is_attribute) {
  const std::size_t next = std::min(text.find("\nsp", begin), text.size());
  for (std::size_t at = text.find(word, begin + 1); at < next; at = text.find(word, at + 1)) {
    const std::size_t after = at + word.size();
    if (IsNameAt(text, after)) continue;
    // "<name" without ">" must not match inside "<name>".
    if (word.starts_with('<') && !word.ends_with('>') && after < text.size() && text[after] == '>') continue;
    const char before = text[at - 1];
    if (is_attribute ? before == '^' || before == '.' : !IsNameAt(text, at - 1)) return at;
  }
  return begin;
}

/// Positions of the names of all rules: after "sp {" or "gp {" at the beginning of a line.
std::vector<std::size_t> NamesOfRules(std::string_view text) {
  std::vector<std::size_t> names;
  for (std::size_t line = 0; line < text.size(); line = std::min(text.find('\n', line), text.size()) + 1) {
    const std::size_t word = text.find_first_not_of(" \t", line);
    if (word == kNotThere) break;
    if (text.compare(word, 2, "sp") != 0 && text.compare(word, 2, "gp") != 0) continue;
    const std::size_t brace = text.find_first_not_of(" \t", word + 2);
    if (brace == kNotThere || text[brace] != '{') continue;
    if (const std::size_t name = text.find_first_not_of(" \t\r\n", brace + 1); name != kNotThere) names.push_back(name);
  }
  return names;
}

struct PlaceInText {
  int line = 0, column = 0;
  std::string excerpt;
};

PlaceInText PlaceAt(const std::string& text, std::size_t at) {
  const std::size_t before = at == 0 ? kNotThere : text.rfind('\n', at - 1);
  const std::size_t begin = before == kNotThere ? 0 : before + 1;
  return {1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n')),
          static_cast<int>(at - begin) + 1, text.substr(begin, std::min(text.find('\n', at), text.size()) - begin)};
}

/// The text of a rule after its name, without insignificant blanks, up to its closing brace. `end`: position of the
/// name of the next rule, or the end of the text.
std::string BodyOfRule(std::string_view text, std::size_t begin, std::size_t end) {
  std::string body;
  for (std::size_t at = begin; at < end; ++at) {
    if (!IsBlankAt(text, at)) {
      body += text[at];
    } else if (!body.empty() && body.back() != ' ') {
      body += ' ';
    }
  }
  if (end < text.size()) body.resize(std::min(body.size(), body.rfind('{')));
  const std::size_t brace = body.rfind('}');
  return brace == kNotThere ? std::string() : body.substr(0, brace);
}

/// A warning at the name of a rule.
Diagnostic WarningAt(const RuleFile& file, std::size_t at, const std::string& rule, std::string message,
                     std::string hint) {
  PlaceInText place = PlaceAt(file.text, at);
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.file = file.file.string();
  warning.message = std::move(message);
  warning.hint = std::move(hint);
  warning.line = place.line;
  warning.column = place.column;
  warning.excerpt = std::move(place.excerpt);
  warning.excerpt_length = static_cast<int>(rule.size());
  warning.rule = rule;
  return warning;
}

/// Lines "rl --set NAME VALUE" whose setting a later line of the same file changes before the agent runs.
void FindRepeatedSettings(const RuleFile& file, std::vector<Diagnostic>& warnings) {
  struct Setting {
    std::size_t at;
    std::string value;
  };
  std::map<std::string, Setting> known;
  for (std::size_t line = 0; line < file.text.size();
       line = std::min(file.text.find('\n', line), file.text.size()) + 1) {
    if (std::string_view("rdsi").find(file.text[line]) == kNotThere) continue;  // Not one of the commands below.
    std::istringstream words(file.text.substr(line, std::min(file.text.find('\n', line), file.text.size()) - line));
    std::string command, option, name, value;
    words >> command >> option >> name >> value;
    // The setting may have been used.
    if (command == "run" || command == "d" || command == "step" || command == "init-soar") known.clear();
    if (command != "rl" || (option != "--set" && option != "-s") || value.empty()) continue;
    const auto [earlier, is_new] = known.try_emplace(name, Setting{line, value});
    if (is_new) continue;
    if (earlier->second.value != value) {
      const int number = PlaceAt(file.text, line).line;
      Diagnostic warning = WarningAt(file, earlier->second.at, {},
                                     "this sets " + name + " to " + earlier->second.value + ", and line " +
                                         std::to_string(number) + " sets it to " + value + ": only the last one counts",
                                     "change line " + std::to_string(number) + ", or remove it");
      warning.excerpt_length = static_cast<int>(warning.excerpt.size());
      warnings.push_back(std::move(warning));
    }
    earlier->second = {line, value};
  }
}

}  // namespace

std::vector<Diagnostic> FindDuplicates(const std::vector<RuleFile>& files) {
  // Stores positions, not lines: PlaceAt is slow and is called only for rules that get a warning.
  std::map<std::string, std::pair<const RuleFile*, std::size_t>> known;
  std::map<std::string, std::string> bodies;  // The first rule with this text.
  std::vector<Diagnostic> warnings;
  for (const RuleFile& file : files) {
    FindRepeatedSettings(file, warnings);
    const std::vector<std::size_t> names = NamesOfRules(file.text);
    for (std::size_t i = 0; i < names.size(); ++i) {
      const std::size_t at = names[i];
      const std::string name =
          file.text.substr(at, std::min(file.text.find_first_of(" \t\r\n(", at), file.text.size()) - at);
      const auto [first, is_new] = known.try_emplace(name, &file, at);
      if (is_new) {
        std::string body =
            BodyOfRule(file.text, at + name.size(), i + 1 < names.size() ? names[i + 1] : file.text.size());
        if (body.empty()) continue;
        const auto [copied, is_first] = bodies.try_emplace(std::move(body), name);
        if (!is_first)
          warnings.push_back(
              WarningAt(file, at, name,
                        "rule " + name + " is ignored: it has the same conditions and actions as " + copied->second,
                        "change what is to be different, or remove one of them"));
        continue;
      }
      const RuleFile* const other = first->second.first;
      const int line = PlaceAt(other->text, first->second.second).line;
      warnings.push_back(WarningAt(file, at, name,
                                   "rule " + name + " replaces the rule of the same name in " +
                                       (other == &file ? "line " : other->file.string() + ":") + std::to_string(line),
                                   "give each rule its own name"));
    }
  }
  return warnings;
}

std::vector<Slip> FindSlips(const std::vector<RuleText>& rules, const KnownWords& given) {
  std::vector<Slip> all;
  KnownWords known = given;
  if (std::optional<Slip> other = FindOtherWorld(rules, given)) {
    all.push_back(*std::move(other));
    known.own_world = true;
  }
  std::set<std::pair<std::string, std::string>> told;  // Rule and variable.
  for (const std::vector<Slip>& some :
       {FindSlipsOfForm(rules), FindSlipsOfUse(rules), FindSlipsOfMeaning(rules, known), FindSlipsOfLogic(rules, known),
        FindSlipsOfUndoing(rules), known.complete ? FindSlipsOfNegation(rules) : std::vector<Slip>(),
        FindSlipsOfMemory(rules), FindSlipsOfImagery(rules, known.scene), FindSlipsOfWorld(rules, known)}) {
    // Slips about a variable that an earlier search has reported are dropped.
    std::set<std::pair<std::string, std::string>> variables;
    for (const Slip& slip : some) {
      if (told.contains({slip.rule, slip.word})) continue;
      if (IsVariable(slip.word)) variables.emplace(slip.rule, slip.word);
      all.push_back(slip);
    }
    told.merge(variables);
  }
  return all;
}

Diagnostic PlaceSlip(const Slip& slip, const std::filesystem::path& file, const std::string& text) {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.file = file.string();
  warning.message = slip.message;
  warning.rule = slip.rule;
  warning.topic = slip.topic;
  warning.meant = slip.meant;
  warning.hint = slip.hint;
  const std::size_t rule = FindNameOfRule(text, slip.rule);
  if (rule == kNotThere) return warning;
  std::size_t from = rule;
  if (slip.in_actions) {
    const std::size_t arrow = text.find("-->", rule);
    if (arrow < std::min(text.find("\nsp", rule), text.size())) from = arrow;
  }
  const std::size_t found = slip.word.empty() ? from : FindWord(text, from, slip.word, slip.is_attribute);
  const std::size_t at = found == from ? rule : found;
  PlaceInText place = PlaceAt(text, at);
  warning.line = place.line;
  warning.column = place.column;
  warning.excerpt = std::move(place.excerpt);
  warning.excerpt_length = static_cast<int>(slip.word.empty() || at == rule ? slip.rule.size() : slip.word.size());
  return warning;
}

}  // namespace soarbox::explain
