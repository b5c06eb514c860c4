// SPDX-License-Identifier: BSD-2-Clause
// Console: the Soar command line of the selected agent.
#include <algorithm>
#include <utility>

#include "debugger/file_place.h"
#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

Role RoleOf(debugger::ConsoleLine::Kind kind) {
  using Kind = debugger::ConsoleLine::Kind;
  switch (kind) {
    case Kind::kInput:
      return Role::kName;
    case Kind::kError:
      return Role::kBad;
    case Kind::kHint:
      return Role::kGood;
    case Kind::kOutput:
      break;
  }
  return Role::kPlain;
}

/// A line; a link if it names a place in a file.
Span LineOf(const Contents& contents, const debugger::ConsoleLine& line) {
  if (line.kind == debugger::ConsoleLine::Kind::kInput) return {"> " + line.text, RoleOf(line.kind)};
  const std::optional<debugger::FilePlace> place = debugger::FindFilePlace(line.text);
  if (!place) return {line.text, RoleOf(line.kind)};
  Span span = FileLink(contents, place->file, place->line, line.text);
  span.role = RoleOf(line.kind);
  return span;
}

Transcript LinesOf(const Contents& contents) {
  constexpr std::ptrdiff_t kMost = 2'000;
  Transcript transcript{"output " + contents.agent, "Output", {}, contents.console_lines};
  const std::deque<debugger::ConsoleLine>& lines = contents.console->lines();
  for (auto line = lines.end() - std::min(std::ssize(lines), kMost); line != lines.end(); ++line)
    transcript.lines.push_back(LineOf(contents, *line));
  if (lines.empty() && contents.has_mind)
    transcript.lines.push_back(Quiet("Type a Soar command: print s1, matches RULE, preferences, help ..."));
  if (lines.empty() && !contents.has_mind)
    transcript.lines.push_back(Quiet(contents.agent +
                                     " has no Soar mind. Type Lua for its script: agent:GetPosition(), or lua-sandbox "
                                     "#Sandbox.GetAgents(sandbox)."));
  return transcript;
}

Form FormOf(const Contents& contents) {
  Field field;
  field.kind = Field::Kind::kCommand;
  field.name = "line";
  field.label = (contents.has_mind ? "A Soar command for " : "A line of Lua for ") + contents.agent;
  field.prompt = contents.agent + ">";
  field.placeholder = contents.has_mind ? "a Soar command; Tab completes" : "a line of Lua";
  field.value = contents.begun_line;
  field.is_needed = true;
  field.command = CommandLine{Action{CompleteRequest{contents.agent, {}}}, Action{KeepLineRequest{contents.agent, {}}},
                              contents.completed_line, contents.completion};
  Form form{"command " + contents.agent, {ConsoleRequest{contents.agent, {}}}, {std::move(field)}, "Send"};
  form.clears = form.repeats = true;
  return form;
}

}  // namespace

Nodes ConsoleDocument(const Contents& contents) {
  if (contents.agent.empty())
    return {
        Empty("No agent is selected.",
              "Click one in the picture or in the list of agents. Then you can type Soar commands for its mind "
              "here, such as print s1 or matches my*rule, and Lua for its script, such as lua agent:GetPosition().")};
  if (contents.console == nullptr) return {};
  return {LinesOf(contents),
          Actions{{Button{"Clear", Action{ClearConsoleRequest{}}, "Empty this console"}, FormOf(contents)}}};
}

}  // namespace soarbox::workbench::document
