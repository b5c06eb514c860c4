// SPDX-License-Identifier: BSD-2-Clause
#include "script/check_names.h"

#include <algorithm>
#include <cctype>

#include "script/api_table.h"

namespace soarbox::script {
namespace {

/// The functions of scripts that a sandbox calls.
constexpr std::string_view kCalled[] = {
    "Agent_Initialize", "Agent_Update",   "Agent_HandleEvent",  "Agent_Cleanup",  "Agent_Sense",
    "Agent_Tick",       "Agent_Withdraw", "Sandbox_Initialize", "Sandbox_Update", "Sandbox_HandleEvent",
    "Sandbox_Cleanup",  "Sandbox_Sense",  "Sandbox_Command"};

bool IsNamePart(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

struct Names {
  std::string_view text;
  const std::string code;
  const std::string& file;
  std::vector<Diagnostic> found;

  void Warn(std::size_t at, std::size_t length, std::string message, std::string_view near) {
    Diagnostic& warning = found.emplace_back();
    warning.severity = Severity::kWarning;
    warning.file = file;
    const std::size_t begin = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 is 0
    warning.line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    warning.column = static_cast<int>(at - begin) + 1;
    warning.excerpt = text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
    warning.excerpt_length = static_cast<int>(length);
    warning.message = std::move(message);
    warning.hint =
        near.empty() ? "docs/lua lists the functions that there are" : "did you mean " + std::string(near) + "?";
  }

  std::string WordAt(std::size_t at) const {
    std::size_t end = at;
    while (end < code.size() && IsNamePart(code[end])) ++end;
    return code.substr(at, end - at);
  }

  bool IsDefined(const std::string& name) const { return code.find("function " + name) != std::string::npos; }

  /// Whether it is a method that the script itself adds to agents, or to its own table named `agent`.
  bool IsOwnMethod(const std::string& name) const {
    return IsDefined("Agent." + name) || IsDefined("Agent:" + name) || IsDefined("agent:" + name) ||
           IsDefined("agent." + name) || code.find("local agent = {") != std::string::npos;
  }

  void CheckTable(std::string_view table) {
    for (std::size_t at = code.find(table); at != std::string::npos; at = code.find(table, at + 1)) {
      if (at > 0 && (IsNamePart(code[at - 1]) || code[at - 1] == '.')) continue;
      const std::size_t dot = at + table.size();
      if (dot >= code.size() || code[dot] != '.') continue;
      const std::string name = WordAt(dot + 1);
      const std::string whole = std::string(table) + "." + name;
      const std::size_t behind = code.find_first_not_of(" \t", dot + 1 + name.size());
      if (name.empty() || behind == std::string::npos || code[behind] != '(') continue;
      if (FindApiFunction(whole) != nullptr || IsDefined(whole)) continue;
      Warn(dot + 1, name.size(), std::string(table) + " has no function " + name, SuggestApiName(table, name));
    }
  }

  /// Methods of agents: agent:SetPositon(...).
  void CheckMethods() {
    for (std::size_t at = code.find("agent:"); at != std::string::npos; at = code.find("agent:", at + 1)) {
      if (at > 0 && (IsNamePart(code[at - 1]) || code[at - 1] == '.')) continue;
      const std::string name = WordAt(at + 6);
      if (name.empty() || FindApiFunction("Agent." + name) != nullptr || IsOwnMethod(name)) continue;
      Warn(at + 6, name.size(), "an agent has no function " + name, SuggestApiName("Agent", name));
    }
  }

  void CheckDefinitions() {
    for (std::size_t at = code.find("function "); at != std::string::npos; at = code.find("function ", at + 1)) {
      const std::string name = WordAt(at + 9);
      if (!name.starts_with("Agent_") && !name.starts_with("Sandbox_") && name.find("_") == std::string::npos) continue;
      if (std::find(std::begin(kCalled), std::end(kCalled), name) != std::end(kCalled)) continue;
      const std::string_view near = Suggest(name, {std::begin(kCalled), std::end(kCalled)});
      // Less similar names are functions of the script itself.
      const bool close = !near.empty() &&
                         (near.size() > name.size() ? near.size() - name.size() : name.size() - near.size()) <= 2 &&
                         !near.empty() && near.substr(0, 4) == std::string_view(name).substr(0, 4);
      if (close && code.find(name, at + 9 + name.size()) == std::string::npos)
        Warn(at + 9, name.size(), "nothing calls the function " + name, near);
    }
  }
};

}  // namespace

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

std::vector<Diagnostic> CheckNames(std::string_view text, const std::string& file) {
  Names names{text, BlankedCode(text), file, {}};
  for (const ApiGroup& group : ApiGroups()) names.CheckTable(group.name);
  names.CheckMethods();
  names.CheckDefinitions();
  std::stable_sort(names.found.begin(), names.found.end(),
                   [](const Diagnostic& a, const Diagnostic& b) { return a.line < b.line; });
  return std::move(names.found);
}

std::vector<Diagnostic> CheckCallbackNames(std::string_view text, const std::string& file) {
  Names names{text, BlankedCode(text), file, {}};
  names.CheckDefinitions();
  return std::move(names.found);
}

}  // namespace soarbox::script
