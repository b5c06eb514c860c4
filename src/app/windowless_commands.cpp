// SPDX-License-Identifier: BSD-2-Clause
#include "app/windowless_commands.h"

#include <map>

#include "app/command_options.h"

namespace soarbox::app {

int ExecuteWindowless(const std::string& command, const CommandOptions& options) {
  static const std::map<std::string, int (*)(const CommandOptions&)> kCommands = {
      {"check", [](const CommandOptions& given) { return Check(given.check); }},
      {"compare", [](const CommandOptions& given) { return Compare(given.recording); }},
      {"dap", [](const CommandOptions&) { return ServeDebugger(); }},
      {"datamap", [](const CommandOptions& given) { return WriteDatamap(given.datamap); }},
      {"engine", [](const CommandOptions& given) { return Engine(given.engine); }},
      {"export", [](const CommandOptions& given) { return Export(given.recording); }},
      {"format", [](const CommandOptions& given) { return FormatFiles(given.format); }},
      {"inspect", [](const CommandOptions& given) { return Inspect(given.inspect); }},
      {"kernel", [](const CommandOptions& given) { return ServeKernel(given.kernel); }},
      {"lsp", [](const CommandOptions&) { return ServeLanguage(); }},
      {"mcp", [](const CommandOptions& given) { return ServeAssistant(given.assistant_folder); }},
      {"new", [](const CommandOptions& given) { return NewScenario(given.made); }},
      {"replay", [](const CommandOptions& given) { return PrintRecording(given.recording); }},
      {"report", [](const CommandOptions& given) { return Report(given.report); }},
      {"resume", [](const CommandOptions& given) { return Resume(given.recording); }},
      {"soar", [](const CommandOptions& given) { return RunSoarShell(given.soar); }},
      {"sweep", [](const CommandOptions& given) { return Sweep(given.sweep); }},
      {"test", [](const CommandOptions& given) { return Test(given.test); }},
      {"verify", [](const CommandOptions& given) { return Verify(given.recording); }},
      {"why", [](const CommandOptions& given) { return Why(given.why); }},
  };
  return kCommands.at(command)(options);
}

}  // namespace soarbox::app
