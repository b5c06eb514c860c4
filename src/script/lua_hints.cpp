// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_hints.h"

#include <algorithm>
#include <utility>

#include "script/api_table.h"

namespace soarbox::script {
namespace {

bool Holds(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

/// The first text between single quotes.
std::string Quoted(std::string_view text) {
  const std::size_t begin = text.find('\'');
  const std::size_t end = begin == std::string_view::npos ? begin : text.find('\'', begin + 1);
  return end == std::string_view::npos ? std::string() : std::string(text.substr(begin + 1, end - begin - 1));
}

/// For a script that does not compile.
std::string HintForSyntax(std::string_view message, std::string_view line) {
  constexpr std::pair<std::string_view, std::string_view> kForms[] = {
      {"!=", "not equal is written ~="},
      {"&&", "write and"},
      {"||", "write or"},
      {"++", "to count, write n = n + 1"},
      {"+=", "write the sum out: n = n + 1"},
      {"-=", "write the difference out: n = n - 1"},
      {"elif ", "write elseif"},
  };
  const std::size_t first = line.find_first_not_of(" \t");
  for (const std::string_view mark : {"//", "/*", "#", ";;"})
    if (first != std::string_view::npos && line.substr(first).starts_with(mark)) return "comments start with --";
  if (Holds(message, "'end' expected")) {
    const std::size_t at = message.find("at line ");
    const std::string begin = at == std::string_view::npos
                                  ? std::string()
                                  : std::string(message.substr(at + 8, message.find(')', at) - at - 8));
    return "each function, if, for and while has an end of its own" +
           (begin.empty() ? std::string() : "; look from line " + begin + " on");
  }
  if (Holds(message, "unfinished string")) return "a text ends in its line, with the quote that it began with";
  for (const auto& [form, hint] : kForms)
    if (Holds(line, form)) return std::string(hint);
  if (Holds(message, "'then' expected")) return "a choice is written if ... then ... end";
  if (Holds(message, "'do' expected")) return "a loop is written while ... do ... end, or for ... do ... end";
  if (Holds(message, "'<eof>' expected near 'end'")) return "there is one end too many before this";
  return {};
}

/// For a value that is nil.
std::string HintForNil(std::string_view message, std::string_view line) {
  const std::string name = Quoted(message);
  if (name.empty()) return {};
  const bool is_call = message.starts_with("attempt to call");
  if (is_call && (Holds(message, "field ") || Holds(message, "method "))) {
    for (const ApiGroup& group : ApiGroups()) {
      if (!Holds(line, std::string(group.name) + "." + name) &&
          (group.name != "Agent" || !Holds(line, "agent:" + name)))
        continue;
      const std::string_view near = SuggestApiName(group.name, name);
      return near.empty()
                 ? std::string(group.name) + " has no function " + name + ": docs/lua lists those that there are"
                 : "did you mean " + std::string(near) + "?";
    }
    return {};
  }
  if (Holds(message, "global ")) {
    return is_call ? "there is no function " + name + ": is its name right, and is its script loaded with require?"
                   : "nothing has given " + name + " a value: is its name right?";
  }
  if (is_call) return {};
  return name + " has no value here: test it first, if " + name + " then ... end";
}

}  // namespace

std::string HintForLua(std::string_view message, std::string_view line) {
  if (Holds(message, "(a nil value)")) return HintForNil(message, line);
  if (Holds(message, " expected") || Holds(message, " near ")) return HintForSyntax(message, line);
  return {};
}

}  // namespace soarbox::script
