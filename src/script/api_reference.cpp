// SPDX-License-Identifier: BSD-2-Clause
#include "script/api_reference.h"

#include <cctype>

#include "diagnostics/lower_case.h"
#include "script/api_table.h"

namespace soarbox::script {
namespace {

constexpr const char* kIntroduction =
    R"(# The Lua API

This page lists the functions that scripts of a scenario can call. A sandbox's script defines any of
`Sandbox_Initialize(sandbox)`, `Sandbox_Update(sandbox, milliseconds)`, `Sandbox_HandleEvent(sandbox, event)` and
`Sandbox_Cleanup(sandbox)`. An agent's script defines any of `Agent_Initialize(agent)`, `Agent_Update(agent, milliseconds)`,
`Agent_HandleEvent(agent, event)` and `Agent_Cleanup(agent)`. The body of an agent with a Soar mind [has other functions](../scenarios.md#agents-in-a-script).
[Names](names.md) lists what events hold, and the names of keys, materials and effects. Lengths are in metres, angles in degrees, masses in kilograms and
forces in newtons. y is up, and an agent that is not turned faces along z.

A wrong argument is an error; the message names the first wrong one. In three cases a call only does nothing and gives a
warning: some functions got a wrong number of arguments, the first argument is not the sandbox, or the function does not
apply to this kind of object or scene node. If a name is almost that of a function, the error says which function.

The language is Lua 5.1 with `table`, `string`, `math`, `bit` and `coroutine`, but without `io` and bytecode; of `debug` there is
`debug.traceback([message])`. `require`
finds scripts of the scenario and of the library. `os` has `clock`, `time`, `date` and `difftime`, which use the clock of the
simulation; it starts at midnight on 1 January 2000. `os.exit([code])` ends all scripts: a headless run ends with that
exit code, and a window stays open. Random numbers come from the run's seed.

[Models, images and sounds](models.md) come from files of the world.

[The Lua library](library.md) is made of these functions and saves you much of the work.

In the examples, `sandbox` is the sandbox, `agent` and `other` are agents that do not move, and `object` is a box of 1 m. `node`,
`light` and `effect` are a node, a lamp and a particle effect. `ui` and `panel` are a panel on the screen and one in the
world. `mesh` is a soldier and `animation` one of its animations. What a line prints follows `-->`.

Types: a `Thing` is an agent, an object, a scene node or the sandbox; a `Scene` is any of these except an agent; a `Mesh` is a
`Scene` that shows a mesh with a skeleton; `Placed` is an object or a scene node; a `Node` is a scene node; `Agents` are a table of
agents or the name of a team; a `value` is anything. You can leave out arguments with a default at the end.

A number outside its range, or a vector with a component outside it, counts as the nearest value in the range. You get a warning,
once for each place in a script. Numbers that are not finite (0 / 0) change nothing and give a warning.
)";

std::string FileOf(std::string_view group) {
  return LowerCase(group) + ".md";
}

/// "Agent.SetPath(agent, points [, cyclic])".
std::string Call(const ApiFunction& function) {
  std::string text(function.name);
  text += "(";
  std::string closing;
  bool first = true;
  for (const ApiArgument& argument : ParseArguments(function.arguments)) {
    if (argument.optional) {
      text += first ? "[" : " [, ";
      closing += "]";
    } else if (!first) {
      text += ", ";
    }
    text += argument.name;
    first = false;
  }
  return text + closing + ")";
}

std::string Anchor(std::string_view heading) {
  std::string anchor;
  for (const unsigned char c : heading) {
    if (std::isalnum(c)) anchor += static_cast<char>(std::tolower(c));
  }
  return anchor;
}

std::string WithoutBrackets(std::string_view results) {
  std::string text;
  for (const char c : results) {
    if (c == '[') {
      text += "(";
    } else {
      text += c == ']' ? ')' : c;
    }
  }
  return text;
}

/// "0 to 1"; for vectors, the range of each component.
std::string RangeOf(const ApiArgument& argument) {
  if (argument.range.empty()) return {};
  const std::size_t dots = argument.range.find("..");
  const std::string_view high = argument.range.substr(dots + 2);
  const std::string low(argument.range.substr(0, dots));
  return high == "inf" ? "from " + low : low + " to " + std::string(high);
}

std::string Section(const ApiFunction& function) {
  std::string text = "\n## " + std::string(function.name) + "\n\n```\n" + Call(function) + "\n```\n\n" +
                     std::string(function.text) + "\n\n";
  const auto arguments = ParseArguments(function.arguments);
  if (!arguments.empty()) {
    text += "| argument | type | range | unit | default |\n| --- | --- | --- | --- | --- |\n";
    for (const ApiArgument& argument : arguments) {
      text += "| `" + std::string(argument.name) + "` | " + std::string(argument.type_name) + " | " +
              RangeOf(argument) + " | " + std::string(argument.unit) + " | " +
              (argument.optional ? std::string(argument.default_value) : "") + " |\n";
    }
    text += "\n";
  }
  text += "Returns " + (function.results.empty() ? "nothing" : WithoutBrackets(function.results)) + ".\n\n```lua\n" +
          std::string(function.example) + "\n```\n";
  return text;
}

}  // namespace

std::vector<ReferencePage> ApiReference() {
  std::vector<ReferencePage> pages;
  std::string contents = kIntroduction;
  for (const ApiGroup& group : ApiGroups()) {
    const std::string file = FileOf(group.name), name(group.name), about(group.text);
    std::string text = "# " + name + "\n\n" + about + "\n";
    contents += "\n## [" + name + "](" + file + ")\n\n" + about + "\n\n";
    for (const ApiFunction& function : group.functions) {
      text += Section(function);
      contents += "* [`" + Call(function) + "`](" + file + "#" + Anchor(function.name) + ")\n";
    }
    pages.push_back({file, text});
  }
  pages.push_back({"README.md", contents});
  return pages;
}

}  // namespace soarbox::script
