// SPDX-License-Identifier: BSD-2-Clause
#include "cli/load_image.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>

#include "cli/interpreter.h"
#include "cli/rule_image.h"
#include "cli/source_run.h"
#include "kernel/agent.h"

namespace soarbox::cli {
namespace {

bool RefuseImage(CommandCall& call, const Diagnostic& problem) {
  std::string text = problem.file + ": " + problem.message;
  if (!problem.hint.empty()) text += "\n" + problem.hint;
  call.Fail(text);
  Diagnostic& told = call.result.diagnostics.back();
  told.message = problem.message;
  told.hint = problem.hint;
  return false;
}

}  // namespace

bool LoadRuleImage(CommandCall& call, const std::string& file) {
  if (call.interpreter.host().IsRunning(call.session)) {
    return call.Fail("Rules cannot be replaced by an image while the agent runs.");
  }
  std::filesystem::path path;
  if (!call.interpreter.ResolveForReading(call, file, path)) return false;
  std::error_code error;
  std::ifstream in(path, std::ios::binary);
  if (!in || std::filesystem::is_directory(path, error)) {
    return call.Fail("Failed to open file for reading: " + file);
  }
  std::ostringstream content;
  content << in.rdbuf();
  const std::string bytes = std::move(content).str();
  kernel::Agent& agent = call.agent();
  Result<std::vector<kernel::ProductionPtr>> rules = ReadRuleImage(bytes, file, agent.mutable_symbols());
  if (!rules) return RefuseImage(call, rules.error());

  PrintStream::Capture capture(call.stream(), &call.result.text);
  SourceRun* source = call.interpreter.source_run();
  const std::vector<kernel::ProductionId> older = agent.Productions();
  for (const kernel::ProductionId id : older) {
    if (source) source->counts.excised.emplace_back(agent.production(id).name);
    agent.Excise(id);
    call.stream().Print("#");
  }
  call.interpreter.host().Reinitialize(call.session);
  int loaded = 0;
  for (kernel::ProductionPtr& rule : *rules) {
    const kernel::LoadOutcome outcome = agent.AddProduction(std::move(rule));
    if (outcome.loaded) {
      ++loaded;
    } else {
      call.Hint(fmt::format("{} was left out: it equals {}", outcome.name, outcome.duplicate_of), {});
    }
  }
  if (source) source->counts.sourced += loaded;
  call.AddArgument("sourced-production-count", "int", std::to_string(loaded));
  return true;
}

bool SaveRuleImage(CommandCall& call, const std::string& file) {
  const kernel::Agent& agent = call.agent();
  if (agent.CountProductions(kernel::ProductionType::kJustification) > 0) {
    return call.Fail(
        "An image cannot be written while there are justifications, which only make sense in this moment of the run.\n"
        "Use 'init-soar' first, or write the image before the run.");
  }
  const std::string image = WriteRuleImage(agent);
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path)) return false;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << image;
  out.close();
  if (!out) return call.Fail("Failed to open file for writing: " + file);
  call.Out(fmt::format("{} production{} written to file {}.\n", agent.Productions().size(),
                       agent.Productions().size() == 1 ? "" : "s", file));
  return true;
}

}  // namespace soarbox::cli
