// SPDX-License-Identifier: BSD-2-Clause
#include "script/check_names.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <span>

#include "script/api_table.h"

namespace soarbox::script {
namespace {

/// The functions of scripts that a sandbox calls.
constexpr std::string_view kCalled[] = {
    "Agent_Initialize", "Agent_Update",   "Agent_HandleEvent",  "Agent_Cleanup",  "Agent_Sense",
    "Agent_Tick",       "Agent_Withdraw", "Sandbox_Initialize", "Sandbox_Update", "Sandbox_HandleEvent",
    "Sandbox_Cleanup",  "Sandbox_Sense",  "Sandbox_Command"};
constexpr std::string_view kLuaWords[] = {"and",      "break",  "do",   "else", "elseif", "end",  "false", "for",
                                          "function", "goto",   "if",   "in",   "local",  "nil",  "not",   "or",
                                          "repeat",   "return", "then", "true", "until",  "while"};
/// Lua's own functions that scripts may call.
constexpr std::string_view kLuaFunctions[] = {
    "assert", "collectgarbage", "error",        "getfenv",  "getmetatable", "ipairs", "load",   "loadstring",
    "next",   "pairs",          "pcall",        "print",    "rawequal",     "rawget", "rawset", "require",
    "select", "setfenv",        "setmetatable", "tonumber", "tostring",     "type",   "unpack", "xpcall"};

bool IsIn(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

/// A name in a script's code, outside of comments and strings.
struct Word {
  std::string_view name;
  std::size_t at = 0;
  char joint = '\0';            ///< '.' or ':' of a field.
  std::string_view owner;       ///< Of a field: the name before the joint, unless that is a field, too.
  bool is_called = false;       ///< Before a parenthesis, a brace or a string.
  bool names_function = false;  ///< After "function".
  bool is_defined = false;      ///< After "function", or before "=" or ",".
  bool is_local = false;        ///< After "local" or "local function".

  bool IsField() const { return joint != '\0'; }
};

bool IsWordPart(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

/// Returns the script with comments and strings replaced by blanks, so that positions stay the same.
std::string BlankedCode(std::string_view text) {
  std::string code(text);
  const auto blank = [&code](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < std::min(to, code.size()); ++i)
      if (code[i] != '\n') code[i] = ' ';
    return to;
  };
  for (std::size_t i = 0; i < code.size();) {
    const bool comment = code.compare(i, 2, "--") == 0;
    const std::size_t bracket = comment ? i + 2 : i;
    if (code.compare(bracket, 2, "[[") == 0) {
      const std::size_t end = code.find("]]", bracket);
      i = blank(i, end == std::string::npos ? code.size() : end + 2);
    } else if (comment) {
      i = blank(i, std::min(code.find('\n', i), code.size()));
    } else if (code[i] == '"' || code[i] == '\'') {
      std::size_t end = i + 1;
      while (end < code.size() && code[end] != code[i] && code[end] != '\n') end += code[end] == '\\' ? 2 : 1;
      i = blank(i, end + 1);
    } else {
      ++i;
    }
  }
  return code;
}

/// A script, the same without comments and strings, and the words in it. The text must outlive it.
struct Code {
  explicit Code(std::string_view given) : text(given), code(BlankedCode(given)) { FindWords(); }

  void FindWords();
  bool Defines(const std::string& name) const { return code.find("function " + name) != std::string::npos; }
  /// Whether it is a method that the script itself adds to agents, or to its own table named `agent`.
  bool HasOwnMethod(const std::string& name) const {
    return Defines("Agent." + name) || Defines("Agent:" + name) || Defines("agent:" + name) ||
           Defines("agent." + name) || code.find("local agent = {") != std::string::npos;
  }
  Diagnostic WarningAt(const Word& word, const std::string& file, std::string message, std::string_view near,
                       const char* other_hint) const;

  const std::string_view text;
  const std::string code;
  std::vector<Word> words;
};

void Code::FindWords() {
  constexpr char kOther = '#';
  std::string_view before, second_before;  // The previous names.
  char between = kOther;       // The last sign since the previous name: ' ' if there is none, '.' or ':', or kOther.
  bool is_after_word = false;  // The last sign is the only one.
  for (std::size_t i = 0; i < code.size();) {
    if (!IsWordPart(code[i])) {
      if (std::isspace(static_cast<unsigned char>(code[i])) == 0) {
        const bool is_joint = code[i] == ':' || (code[i] == '.' && (i == 0 || code[i - 1] != '.'));
        is_after_word = between == ' ';
        between = is_joint ? code[i] : kOther;
      }
      ++i;
      continue;
    }
    std::size_t end = i;
    while (end < code.size() && IsWordPart(code[end])) ++end;
    Word word;
    word.name = std::string_view(code).substr(i, end - i);
    word.at = i;
    if (between == '.' || between == ':') {
      word.joint = between;
      if (is_after_word && !words.empty() && !words.back().IsField()) word.owner = before;
    }
    if (between != ' ') before = second_before = {};
    const std::size_t next = text.find_first_not_of(" \t\r\n", end);
    const char after = next == std::string_view::npos ? '\0' : text[next];
    const bool is_text = after == '"' || after == '\'' || text.compare(std::min(next, text.size()), 2, "[[") == 0;
    word.is_called = after == '(' || after == '{' || is_text;
    word.is_local = before == "local" || (before == "function" && second_before == "local");
    word.names_function = before == "function";
    const bool is_assigned = after == '=' && text.compare(next, 2, "==") != 0;
    word.is_defined = word.names_function || is_assigned || after == ',';
    if (std::isdigit(static_cast<unsigned char>(code[i])) == 0) words.push_back(word);
    second_before = before;
    before = word.name;
    between = ' ';
    i = end;
  }
}

Diagnostic Code::WarningAt(const Word& word, const std::string& file, std::string message, std::string_view near,
                           const char* other_hint) const {
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.file = file;
  const std::size_t begin = word.at == 0 ? 0 : text.rfind('\n', word.at - 1) + 1;  // npos + 1 is 0
  warning.line =
      1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(word.at), '\n'));
  warning.column = static_cast<int>(word.at - begin) + 1;
  warning.excerpt = text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
  warning.excerpt_length = static_cast<int>(word.name.size());
  warning.message = std::move(message);
  warning.hint = near.empty() ? other_hint : "did you mean " + std::string(near) + "?";
  return warning;
}

constexpr const char* kSeeFunctions = "docs/lua lists the functions that there are";

bool IsTable(std::string_view name) {
  return std::ranges::find(ApiGroups(), name, &ApiGroup::name) != ApiGroups().end();
}

/// Functions of the API's tables and methods of agents that do not exist.
void CheckApi(const Code& code, const std::string& file, std::vector<Diagnostic>& found) {
  for (const Word& word : code.words) {
    const std::string name(word.name), table(word.owner);
    const bool is_method = word.joint == ':' && table == "agent";
    if (!is_method && (word.joint != '.' || !word.is_called || !IsTable(table))) continue;
    const std::string whole = (is_method ? "Agent" : table) + "." + name;
    if (FindApiFunction(whole) != nullptr || (is_method ? code.HasOwnMethod(name) : code.Defines(whole))) continue;
    found.push_back(code.WarningAt(word, file, (is_method ? "an agent" : table) + " has no function " + name,
                                   SuggestApiName(is_method ? "Agent" : table, name), kSeeFunctions));
  }
}

void CheckDefinitions(const Code& code, const std::string& file, std::vector<Diagnostic>& found) {
  for (const Word& word : code.words) {
    if (!word.names_function || word.name.find('_') == std::string_view::npos || IsIn(word.name, kCalled)) continue;
    const std::string_view near = Suggest(word.name, {std::begin(kCalled), std::end(kCalled)});
    // Less similar names are functions of the script itself.
    const auto sizes = std::minmax({near.size(), word.name.size()});
    if (near.empty() || sizes.second - sizes.first > 2 || near.substr(0, 4) != word.name.substr(0, 4)) continue;
    if (code.code.find(word.name, word.at + word.name.size()) != std::string::npos) continue;
    found.push_back(
        code.WarningAt(word, file, "nothing calls the function " + std::string(word.name), near, kSeeFunctions));
  }
}

}  // namespace

std::vector<Diagnostic> CheckNames(std::string_view text, const std::string& file) {
  const Code code(text);
  std::vector<Diagnostic> found;
  CheckApi(code, file, found);
  CheckDefinitions(code, file, found);
  std::ranges::stable_sort(found, {}, &Diagnostic::line);
  return found;
}

std::vector<Diagnostic> CheckCallbackNames(std::string_view text, const std::string& file) {
  std::vector<Diagnostic> found;
  CheckDefinitions(Code(text), file, found);
  return found;
}

void AddGlobalsOf(std::string_view text, GlobalNames& names) {
  const Code code(text);
  for (const Word& word : code.words)
    if (word.is_defined && !word.IsField() && !word.is_local) names.emplace(word.name);
}

std::vector<std::string> ModulesOf(std::string_view text) {
  std::vector<std::string> modules;
  const Code code(text);
  for (const Word& word : code.words) {
    if (word.name != "require" || word.IsField()) continue;
    const std::size_t quote = text.find_first_not_of(" \t(", word.at + word.name.size());
    if (quote == std::string_view::npos || (text[quote] != '"' && text[quote] != '\'')) continue;
    const std::size_t end = text.find(text[quote], quote + 1);
    if (end != std::string_view::npos) modules.emplace_back(text.substr(quote + 1, end - quote - 1));
  }
  return modules;
}

std::vector<Diagnostic> CheckCalls(std::string_view text, const std::string& file, const GlobalNames& known) {
  const Code code(text);
  std::map<std::string_view, const Word*> calls;  // The first call of each name; null: the name is defined, or may be.
  for (const Word& word : code.words) {
    if (word.IsField() || IsIn(word.name, kLuaWords)) continue;
    // A script that accesses globals by name may define any of them.
    if (word.name == "_G" || word.name == "setfenv" || word.name == "loadstring") return {};
    const auto [at, is_new] = calls.try_emplace(word.name, &word);
    if (!word.is_called || word.is_defined || word.is_local) at->second = nullptr;
  }
  std::vector<std::string_view> candidates(std::begin(kLuaFunctions), std::end(kLuaFunctions));
  candidates.insert(candidates.end(), known.begin(), known.end());
  for (const Word& word : code.words)
    if (word.is_defined && !word.IsField()) candidates.push_back(word.name);
  std::vector<Diagnostic> found;
  for (const auto& [name, word] : calls) {
    if (word == nullptr || known.contains(name)) continue;
    if (IsIn(name, kLuaFunctions) || IsTable(name)) continue;
    found.push_back(code.WarningAt(*word, file, "nothing defines the function " + std::string(name),
                                   Suggest(name, candidates),
                                   "is its name right, and is its script loaded with require?"));
  }
  std::ranges::stable_sort(found, {}, &Diagnostic::line);
  return found;
}

}  // namespace soarbox::script
