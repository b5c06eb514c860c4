// SPDX-License-Identifier: BSD-2-Clause
#include "script/check_calls.h"

#include <algorithm>
#include <cctype>
#include <map>

#include "script/api_table.h"
#include "script/check_names.h"

namespace soarbox::script {
namespace {

constexpr std::string_view kLuaWords[] = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                          "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                          "repeat",   "return", "then", "true", "until",  "while"};
/// Lua's own functions that scripts may call.
constexpr std::string_view kLuaFunctions[] = {
    "assert", "collectgarbage", "error",        "getfenv",  "getmetatable", "ipairs", "load",   "loadstring",
    "next",   "pairs",          "pcall",        "print",    "rawequal",     "rawget", "rawset", "require",
    "select", "setfenv",        "setmetatable", "tonumber", "tostring",     "type",   "unpack", "xpcall"};

/// A name in a script's code, outside of comments and strings.
struct Word {
  std::string_view name;
  std::size_t at = 0;
  bool is_field = false;    ///< After a dot or a colon.
  bool is_called = false;   ///< Before a parenthesis, a brace or a string.
  bool is_defined = false;  ///< After "function", or before "=" or ",".
  bool is_local = false;    ///< After "local" or "local function".
};

bool IsWordPart(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Returns the words of `code`, in which comments and strings are blanked; `text` is the same code with them.
std::vector<Word> WordsOf(std::string_view text, std::string_view code) {
  std::vector<Word> words;
  std::string_view before, second_before;  // The previous names, if only blanks are between.
  for (std::size_t i = 0; i < code.size();) {
    if (!IsWordPart(code[i])) {
      if (std::isspace(static_cast<unsigned char>(code[i])) == 0) before = second_before = {};
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < code.size() && IsWordPart(code[end])) ++end;
    Word word{code.substr(i, end - i), i};
    const std::size_t last = code.find_last_not_of(" \t\r\n", i == 0 ? std::string_view::npos : i - 1);
    const bool has_last = i > 0 && last != std::string_view::npos && last < i;
    const bool is_joined = has_last && last > 0 && code[last] == '.' && code[last - 1] == '.';
    word.is_field = has_last && (code[last] == ':' || (code[last] == '.' && !is_joined));
    const std::size_t next = text.find_first_not_of(" \t\r\n", end);
    const char after = next == std::string_view::npos ? '\0' : text[next];
    const bool is_text = after == '"' || after == '\'' || text.compare(std::min(next, text.size()), 2, "[[") == 0;
    word.is_called = after == '(' || after == '{' || is_text;
    word.is_local = before == "local" || (before == "function" && second_before == "local");
    const bool is_assigned = after == '=' && text.compare(next, 2, "==") != 0;
    word.is_defined = before == "function" || is_assigned || after == ',';
    if (std::isdigit(static_cast<unsigned char>(code[i])) == 0) words.push_back(word);
    second_before = before;
    before = word.name;
    i = end;
  }
  return words;
}

bool IsLuaWord(std::string_view name) {
  return std::find(std::begin(kLuaWords), std::end(kLuaWords), name) != std::end(kLuaWords);
}

Diagnostic WarningAt(std::string_view text, const std::string& file, const Word& word) {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.file = file;
  const std::size_t begin = word.at == 0 ? 0 : text.rfind('\n', word.at - 1) + 1;  // npos + 1 is 0
  warning.line =
      1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(word.at), '\n'));
  warning.column = static_cast<int>(word.at - begin) + 1;
  warning.excerpt = text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
  warning.excerpt_length = static_cast<int>(word.name.size());
  return warning;
}

}  // namespace

void AddGlobalsOf(std::string_view text, GlobalNames& names) {
  const std::string code = BlankedCode(text);
  for (const Word& word : WordsOf(text, code))
    if (word.is_defined && !word.is_field && !word.is_local) names.emplace(word.name);
}

std::vector<std::string> ModulesOf(std::string_view text) {
  std::vector<std::string> modules;
  const std::string code = BlankedCode(text);
  for (const Word& word : WordsOf(text, code)) {
    if (word.name != "require" || word.is_field) continue;
    const std::size_t quote = text.find_first_not_of(" \t(", word.at + word.name.size());
    if (quote == std::string_view::npos || (text[quote] != '"' && text[quote] != '\'')) continue;
    const std::size_t end = text.find(text[quote], quote + 1);
    if (end != std::string_view::npos) modules.emplace_back(text.substr(quote + 1, end - quote - 1));
  }
  return modules;
}

std::vector<Diagnostic> CheckCalls(std::string_view text, const std::string& file, const GlobalNames& known) {
  const std::string code = BlankedCode(text);
  const std::vector<Word> words = WordsOf(text, code);
  std::map<std::string_view, const Word*> calls;  // The first call of each name; null: the name is defined, or may be.
  for (const Word& word : words) {
    if (word.is_field || IsLuaWord(word.name)) continue;
    // A script that accesses globals by name may define any of them.
    if (word.name == "_G" || word.name == "setfenv" || word.name == "loadstring") return {};
    const auto [at, is_new] = calls.try_emplace(word.name, &word);
    if (!word.is_called || word.is_defined || word.is_local) at->second = nullptr;
  }
  std::vector<std::string_view> candidates(std::begin(kLuaFunctions), std::end(kLuaFunctions));
  candidates.insert(candidates.end(), known.begin(), known.end());
  for (const Word& word : words)
    if (word.is_defined && !word.is_field) candidates.push_back(word.name);
  std::vector<Diagnostic> found;
  for (const auto& [name, word] : calls) {
    if (word == nullptr || known.contains(name)) continue;
    if (std::find(std::begin(kLuaFunctions), std::end(kLuaFunctions), name) != std::end(kLuaFunctions)) continue;
    if (std::ranges::any_of(ApiGroups(), [&called = name](const ApiGroup& group) { return group.name == called; }))
      continue;
    Diagnostic& warning = found.emplace_back(WarningAt(text, file, *word));
    warning.message = "nothing defines the function " + std::string(name);
    const std::string_view near = Suggest(name, candidates);
    warning.hint = !near.empty() ? "did you mean " + std::string(near) + "?"
                                 : "is its name right, and is its script loaded with require?";
  }
  std::ranges::stable_sort(found, {}, &Diagnostic::line);
  return found;
}

}  // namespace soarbox::script
