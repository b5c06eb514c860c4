// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary command lines to the command language, with an agent that runs at most a few cycles. Commands that
// access files are only split into words.
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "cli/command.h"
#include "cli/fence.h"
#include "cli/interpreter.h"
#include "cli/session.h"
#include "kernel/agent.h"

namespace {

using namespace soarbox;

/// Limits runs, independent of the command.
class ShortRuns : public cli::Host {
 public:
  kernel::RunResult Run(cli::Session& session, const cli::RunRequest& request) override {
    cli::RunRequest cut = request;
    if (cut.unit == kernel::RunUnit::kForever) cut.unit = kernel::RunUnit::kDecision;
    if (cut.count > 3) cut.count = 3;
    return Host::Run(session, cut);
  }
};

bool TouchesFiles(std::string_view command) {
  for (const std::string_view name : {"load", "save", "output", "cd", "pushd", "popd", "ls", "visualize"}) {
    if (command == name) return true;
  }
  return false;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  kernel::Agent agent("fuzz");
  cli::Session session(agent);
  ShortRuns host;
  cli::Interpreter interpreter(&host);
  interpreter.Execute(session, "sp {p (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name go)}");

  cli::CommandReader reader(text);
  std::vector<cli::Word> words;
  for (int i = 0; i < 20 && reader.Next(words) == cli::CommandReader::Status::kCommand; ++i) {
    std::string line;
    for (const cli::Word& word : words) line += cli::QuoteWord(word.text) + " ";
    interpreter.aliases().Expand(words);
    std::string error;
    const cli::CommandInfo* command = words.empty() ? nullptr : cli::FindCommand(words.front().text, error);
    bool safe = command && !TouchesFiles(command->name);
    // `debug time COMMAND` executes another command; `alias` may hide one.
    if (command && (command->name == "debug" || command->name == "alias")) safe = words.size() < 3;
    // Long-term memories use files; with a fence they write none.
    const bool remembers = command && (command->name == "smem" || command->name == "epmem");
    const cli::Fence fence({});
    const cli::Interpreter::Fenced fenced(interpreter, remembers ? &fence : nullptr);
    if (safe) interpreter.Execute(session, line);
    interpreter.Complete(session, line);
  }
  return 0;
}
