// SPDX-License-Identifier: BSD-2-Clause
#include "editors/mcp_tools.h"

#include <string>
#include <utility>
#include <vector>

namespace soarbox::editors {
namespace {

using ToolJson = nlohmann::ordered_json;

struct Argument {
  const char* name;
  const char* type;
  const char* about;
  bool required = false;
};

ToolJson Tool(const char* name, const char* about, const std::vector<Argument>& arguments) {
  ToolJson properties = ToolJson::object(), required = ToolJson::array();
  for (const Argument& argument : arguments) {
    properties[argument.name] = {{"type", argument.type}, {"description", argument.about}};
    if (argument.required) required.push_back(argument.name);
  }
  return {{"name", name},
          {"description", about},
          {"inputSchema", {{"type", "object"}, {"properties", properties}, {"required", required}}},
          {"annotations", {{"readOnlyHint", true}, {"destructiveHint", false}, {"openWorldHint", false}}}};
}

constexpr const char* kSource = "A scenario's name or file, a recording's file, or the recording of run_scenario";

}  // namespace

ToolJson McpTools() {
  const Argument agent{"agent", "string", "The agent's name; without it, the first one with a mind"};
  const Argument at{"at", "number", "Simulated seconds"};
  const Argument seed{"seed", "integer", "Seed of the run"};
  return ToolJson::array({
      Tool("check_rules",
           "Check Soar rules, Lua scripts and scenario files with the kernel's own reader. Gives problems with file, "
           "line, column and a hint.",
           {{"path", "string", "A file or folder"}, {"text", "string", "Rules to check, in place of a path"}}),
      Tool("format_rules", "Format rules as soarbox format does. Gives their text.",
           {{"text", "string", "Rules", true}}),
      Tool("make_datamap",
           "A project for VisualSoar with a datamap: the elements that rules test and make, with values.",
           {{"path", "string", "The file of rules that loads all others", true}}),
      Tool("list_percepts", "What agents may perceive on ^io.input-link: paths, types, units, ranges, meanings.",
           {{"filter", "string", "Only paths with this text in them"}}),
      Tool("list_commands", "What agents may do on ^io.output-link: commands with their parameters.",
           {{"filter", "string", "Only commands with this text in their names"}}),
      Tool("list_scenarios", "The scenarios that come with Soarbox.", {}),
      Tool("run_scenario",
           "Run a scenario headless and record it. Gives the events and the name of the recording, for why, inspect, "
           "read_recording, try_future and compare_runs.",
           {{"scenario", "string", "Its name or file", true},
            {"seconds", "number", "Simulated seconds, at most 600"},
            seed}),
      Tool("run_mission", "Run a mission's checks over its seeds. Gives what passed and what failed, with reasons.",
           {{"path", "string", "The mission's file or folder, or a scenario's name", true},
            {"seeds", "string", "1..20 or 1,4,7, in place of the mission's own"}}),
      Tool("why", "Why an agent does what it does at a moment of a run, or does not do something.",
           {{"source", "string", kSource, true},
            {"topic", "string", "A command, an operator or a rule that should happen"},
            agent,
            at,
            seed}),
      Tool(
          "inspect", "What a debugger shows of an agent at a moment: goal stack, working memory, rules, matches.",
          {{"source", "string", kSource, true},
           {"view", "string", "stack, memory, operators, rules, 'rule NAME', trace, learning, 'panel mind', ...", true},
           agent,
           at,
           seed}),
      Tool("read_recording", "What happened in a part of a recording, tick by tick.",
           {{"recording", "string", "A recording's file, or the recording of run_scenario", true},
            {"from", "number", "Simulated seconds"},
            {"to", "number", "Simulated seconds"}}),
      Tool("try_future",
           "Go back to a moment of a recording, replace rules there, go on, and say where the two futures differ.",
           {{"recording", "string", "A recording's file, or the recording of run_scenario", true},
            {"at", "number", "Simulated seconds at which the rules are replaced", true},
            {"rules", "string", "Rules that replace those of the same names", true},
            agent,
            {"seconds", "number", "How long to go on"}}),
      Tool("list_lessons", "The lessons in which people learn Soar, with their numbers.", {}),
      Tool("read_lesson", "The idea and the task of a lesson, its world and the rules that it begins with.",
           {{"lesson", "integer", "Its number", true}}),
      Tool("lesson_hint", "The next hint of a lesson.", {{"lesson", "integer", "Its number", true}}),
      Tool("grade_lesson",
           "Grade rules as the answer to a lesson. Says which checks passed, and the cause of what did not.",
           {{"lesson", "integer", "Its number", true},
            {"rules", "string", "The whole file of rules, in place of that of read_lesson", true}}),
      Tool("compare_runs", "Where two recordings differ first, and how they go on.",
           {{"recording", "string", "The first", true}, {"other", "string", "The second", true}}),
  });
}

}  // namespace soarbox::editors
