// SPDX-License-Identifier: BSD-2-Clause
#include "editors/mcp_prompts.h"

#include <array>
#include <string_view>

namespace soarbox::editors {
namespace {

using PromptJson = nlohmann::ordered_json;

struct PromptArgument {
  std::string_view name, meaning;
  bool required = false;
};
struct Prompt {
  std::string_view name, meaning;
  std::array<PromptArgument, 2> arguments;  ///< Those with an empty name do not exist.
  std::string_view text;                    ///< McpPrompt replaces "{name}" by the value of the argument `name`.
};

constexpr Prompt kPrompts[] = {
    {"explain_agent",
     "Explain what an agent does at a moment, and why",
     {PromptArgument{"source", "A scenario or a recording", true}, PromptArgument{"agent", "The agent's name"}},
     "Explain what the agent {agent} of {source} does, and why. Use the tools why and inspect (views stack, operators "
     "and memory). Name the rules that decide, and quote the conditions that matter. Say at which simulated second "
     "each fact holds."},
    {"find_mistake",
     "Find out why an agent does not do what it should, and mend its rules",
     {PromptArgument{"source", "A scenario or a recording", true},
      PromptArgument{"expected", "What the agent should do", true}},
     "In {source} an agent does not do this: {expected}. Find the cause before you change anything: check_rules, then "
     "run_scenario, then why with the operator or command that is expected, and inspect with the view coverage for "
     "rules that never fire. Propose the smallest change of one rule. Try it with try_future, and compare the runs. "
     "Report the cause, the change, and what the comparison shows."},
    {"write_agent",
     "Write the rules of an agent for a task",
     {PromptArgument{"task", "What the agent should do", true},
      PromptArgument{"scenario", "The scenario that it lives in", true}},
     "Write Soar rules for an agent in {scenario} that does this: {task}. Read the resources soarbox://percepts and "
     "soarbox://commands first: use no percept and no command that is not there. Propose operators with conditions on "
     "the input link, apply them by commands on the output link, and remove commands whose ^status is complete. Check "
     "the rules with check_rules until it has nothing to report, and format them with format_rules."},
    {"solve_lesson",
     "Help a learner with a lesson without giving the answer away",
     {PromptArgument{"lesson", "The number of the lesson", true}, PromptArgument{}},
     "Help me with lesson {lesson}. Read it with read_lesson. Ask me for my rules, grade them with grade_lesson, and "
     "explain what its answer means. Give one hint at a time (lesson_hint), and do not write the solution."},
};

std::string ArgumentOf(const PromptJson& arguments, std::string_view name) {
  if (!arguments.is_object()) return {};
  const auto found = arguments.find(std::string(name));
  return found != arguments.end() && found->is_string() ? found->get<std::string>() : std::string();
}

PromptJson Resource(std::string_view uri, std::string_view name, std::string_view meaning) {
  return {{"uri", uri}, {"name", name}, {"description", meaning}, {"mimeType", "text/markdown"}};
}

}  // namespace

PromptJson McpPrompts() {
  PromptJson prompts = PromptJson::array();
  for (const Prompt& prompt : kPrompts) {
    PromptJson arguments = PromptJson::array();
    for (const PromptArgument& one : prompt.arguments)
      if (!one.name.empty())
        arguments.push_back({{"name", one.name}, {"description", one.meaning}, {"required", one.required}});
    prompts.push_back({{"name", prompt.name}, {"description", prompt.meaning}, {"arguments", std::move(arguments)}});
  }
  return prompts;
}

std::optional<std::string> McpPrompt(const std::string& name, const PromptJson& arguments, std::string& missing) {
  for (const Prompt& prompt : kPrompts) {
    if (prompt.name != name) continue;
    std::string text(prompt.text);
    for (const PromptArgument& one : prompt.arguments) {
      if (one.name.empty()) continue;
      const std::string value = ArgumentOf(arguments, one.name);
      if (value.empty() && one.required && missing.empty()) missing = one.name;
      const std::string mark = "{" + std::string(one.name) + "}";
      if (const std::size_t at = text.find(mark); at != std::string::npos)
        text.replace(at, mark.size(), value.empty() ? "(the first one)" : value);
    }
    return text;
  }
  return std::nullopt;
}

PromptJson McpResources() {
  return PromptJson::array({
      Resource("soarbox://percepts", "percepts", "What agents perceive on ^io.input-link, with units and ranges"),
      Resource("soarbox://commands", "commands", "What agents do on ^io.output-link, with parameters"),
      Resource("soarbox://options", "options", "All sub-commands and options of the command soarbox"),
      Resource("soarbox://scenarios", "scenarios", "The scenarios that come with Soarbox"),
      Resource("soarbox://lessons", "lessons", "The lessons"),
  });
}

PromptJson McpResourceTemplates() {
  return PromptJson::array({{{"uriTemplate", "soarbox://lesson/{number}"},
                             {"name", "lesson"},
                             {"description", "The text and the files of a lesson"},
                             {"mimeType", "text/markdown"}}});
}

}  // namespace soarbox::editors
