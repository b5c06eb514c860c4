// SPDX-License-Identifier: BSD-2-Clause
#include "cli/load_image.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <optional>
#include <utility>
#include <vector>

#include "cli/interpreter.h"
#include "cli/source_run.h"
#include "diagnostics/plain_text.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "kernel/agent.h"
#include "kernel/rules/ordered_rule.h"
#include "kernel/rules/print_production.h"

namespace soarbox::cli {
namespace {

constexpr const char* kSourceThem =
    "source the rules that it was made from; with them, 'save rete-network' writes another";

/// Why a text is not an image; nothing if it is one.
std::optional<Diagnostic> WhyNoImage(std::string_view text, const std::string& file) {
  if (text.empty()) return ProblemIn(file, "the file is empty", kSourceThem);
  if (text.starts_with(kImageStart)) {
    if (std::string why = WhyNoPlainText(text); !why.empty()) return ProblemIn(file, std::move(why), kSourceThem);
    return std::nullopt;
  }
  // The first lines of images of Soar and of earlier versions of this program.
  for (const std::string_view other : {"CompactReteNet", "Soarbox rules\r\n"})
    if (text.substr(0, 32).find(other) != std::string_view::npos)
      return ProblemIn(file, "this is an image of a match network, written by another program or version", kSourceThem);
  return ProblemIn(file, "this is not an image of rules: its first line is not that of an image",
                   "use 'source' for files with rules and commands");
}

bool RefuseImage(CommandCall& call, const Diagnostic& problem) {
  call.Fail(Format(problem));
  call.result.diagnostics.back() = problem;
  return false;
}

}  // namespace

Result<std::vector<Word>> ReadRuleImage(std::string_view text, const std::string& file, const kernel::Agent& agent) {
  if (std::optional<Diagnostic> problem = WhyNoImage(text, file)) return *std::move(problem);
  CommandReader reader(text);
  std::vector<Word> words, rules;
  const auto problem_at = [&](int line, int column, std::string message) {
    Diagnostic problem = ProblemIn(file, std::move(message), kSourceThem);
    problem.line = line;
    problem.column = column;
    return problem;
  };
  // The symbols of an invalid image must not stay in the agent.
  kernel::SymbolTable symbols;
  const kernel::RuleLanguage language{agent.settings().like, {}};
  while (true) {
    const CommandReader::Status status = reader.Next(words);
    if (status == CommandReader::Status::kEnd) return rules;
    if (status == CommandReader::Status::kError)
      return problem_at(reader.error_line(), reader.error_column(), reader.error());
    if (words.front().text != "sp" || words.size() != 2)
      return problem_at(words.front().line, words.front().column, "an image contains only rules");
    const kernel::SourcePlace place{kernel::FileName(file), words[1].line, words[1].column};
    const kernel::ParseOutcome outcome = kernel::ParseOrderedProduction(words[1].text, place, symbols, language);
    if (outcome.production == nullptr) {
      const auto error = std::ranges::find(outcome.diagnostics, Severity::kError, &Diagnostic::severity);
      return error != outcome.diagnostics.end() ? *error : problem_at(place.line, place.column, "this is not a rule");
    }
    rules.push_back(std::move(words[1]));
  }
}

kernel::LoadOutcome AddImageRule(kernel::Agent& agent, const Word& rule, const std::string& file) {
  const kernel::SourcePlace place{kernel::FileName(file), rule.line, rule.column};
  return agent.AddProduction(
      kernel::ParseOrderedProduction(rule.text, place, agent.mutable_symbols(), {agent.settings().like, {}})
          .production);
}

bool LoadRuleImage(CommandCall& call, const std::string& file) {
  if (call.interpreter.host().IsRunning(call.session)) {
    return call.Fail("Rules cannot be replaced by an image while the agent runs.");
  }
  std::filesystem::path path;
  if (!call.interpreter.ResolveForReading(call, file, path)) return false;
  const std::optional<std::string> text = ReadText(path);
  if (!text) return call.Fail("Failed to open file for reading: " + file);
  kernel::Agent& agent = call.agent();
  const Result<std::vector<Word>> rules = ReadRuleImage(*text, file, agent);
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
  for (const Word& rule : *rules) {
    const kernel::LoadOutcome outcome = AddImageRule(agent, rule, path.string());
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
  std::string image(kImageStart);
  const std::vector<kernel::ProductionId> rules = agent.Productions();
  for (const kernel::ProductionId id : rules)
    image +=
        kernel::PrintProduction(agent.symbols(), *agent.ProductionAsLearned(id), {.internal = true, .complete = true});
  std::filesystem::path path;
  if (!call.interpreter.ResolveForWriting(call, file, path)) return false;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << image;
  out.close();
  if (!out) return call.Fail("Failed to open file for writing: " + file);
  call.Out(fmt::format("{} production{} written to file {}.\n", rules.size(), rules.size() == 1 ? "" : "s", file));
  return true;
}

}  // namespace soarbox::cli
