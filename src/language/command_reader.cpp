// SPDX-License-Identifier: BSD-2-Clause
#include "language/command_reader.h"

#include <algorithm>
#include <utility>

#include "cli/fence.h"
#include "cli/generate_rules.h"
#include "cli/interpreter.h"
#include "cli/session.h"
#include "explain/clarify_errors.h"
#include "explain/rule_from_facts.h"
#include "kernel/agent.h"
#include "kernel/rules/parser.h"
#include "rule_reading/rule_reading.h"

namespace soarbox::language {
namespace {

/// Maximum number of rules of one `gp` that are parsed.
constexpr std::uint64_t kMostGenerated = 100;

/// "source x.soar", "load file x.soar"
std::string SourcedBy(const std::vector<cli::Word>& words) {
  if (words.size() == 2 && words[0].text == "source") return words[1].text;
  if (words.size() == 3 && words[0].text == "load" && words[1].text == "file") return words[2].text;
  return {};
}

std::string FirstWordOf(const std::string& body) {
  const std::size_t begin = body.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) return {};
  return body.substr(begin, body.find_first_of(" \t\r\n(", begin) - begin);
}

}  // namespace

RuleReader::RuleReader()
    : agent_(std::make_unique<kernel::Agent>("reader")),
      session_(std::make_unique<cli::Session>(*agent_)),
      interpreter_(std::make_unique<cli::Interpreter>()) {}
RuleReader::~RuleReader() = default;

std::shared_ptr<const ReadCommand> RuleReader::Read(const std::string& text, const std::vector<cli::Word>& words,
                                                    int line) {
  if (const auto known = known_.find(text); known != known_.end()) return known->second;
  if (known_.size() > forget_above_) Forget();
  auto read = std::make_shared<ReadCommand>();
  read->id = "#" + std::to_string(++reads_);
  read->sourced = SourcedBy(words);
  const std::string& command = words.front().text;
  const bool changes_folder = command == "cd" || command == "pushd" || command == "popd";
  if (!read->sourced.empty() || changes_folder) {
    // The caller, which has the path of this file, resolves the names of files.
  } else if (words.size() == 2 && command == "sp") {
    ReadRule(words[1].text, words[1].line - line + 1, words[1].column, *read);
  } else if (words.size() == 2 && command == "gp") {
    ReadGenerated(words[1], words[1].line - line + 1, *read);
  } else {
    ReadOther(text, *read);
  }
  for (Diagnostic& problem : read->problems) {
    problem.file = read->id;
    if (problem.line == 0) problem.line = words.front().line - line + 1;
  }
  explain::ClarifyErrors(read->problems, [&](const std::string&) { return text; });
  known_.emplace(text, read);
  return read;
}

void RuleReader::ReadRule(const std::string& body, int line, int column, ReadCommand& read) {
  read.name = FirstWordOf(body);
  kernel::ParseOutcome outcome = kernel::ParseProduction(body, {read.id, line, column}, symbols_);
  read.problems.insert(read.problems.end(), outcome.diagnostics.begin(), outcome.diagnostics.end());
  if (outcome.production == nullptr) return;
  read.texts.push_back(explain::TextOf(rule_reading::FactsOf(*outcome.production, symbols_)));
  read.rules.push_back(std::move(outcome.production));
}

void RuleReader::ReadGenerated(const cli::Word& body, int line, ReadCommand& read) {
  constexpr std::uint64_t kMostOfAll = 1'000'000;
  const cli::GeneratedRules generated = cli::GenerateRules(body.text, kMostOfAll);
  if (!generated.error.empty()) {
    Diagnostic problem;
    problem.message = generated.error;
    problem.line = line;
    read.problems.push_back(std::move(problem));
  }
  // Usually all have the same errors.
  for (std::uint64_t i = 0; i < std::min(generated.count, kMostGenerated) && read.problems.empty(); ++i)
    ReadRule(generated.Body(i), line, body.column, read);
  read.name = FirstWordOf(body.text);
}

void RuleReader::ReadOther(const std::string& text, ReadCommand& read) {
  const cli::Fence fence({}, cli::Fence::Source::kRulesOnly);
  const cli::Interpreter::Fenced fenced(*interpreter_, &fence);
  const cli::CommandResult result = interpreter_->Execute(*session_, text);
  read.problems = result.diagnostics;
  if (result.ok || std::ranges::any_of(read.problems,
                                       [](const Diagnostic& problem) { return problem.severity == Severity::kError; }))
    return;
  Diagnostic problem;
  problem.message = result.text.substr(0, result.text.find('\n'));
  if (problem.message.empty()) problem.message = "this command fails";
  read.problems.push_back(std::move(problem));
}

void RuleReader::Forget() {
  std::erase_if(known_, [](const auto& one) { return one.second.use_count() == 1; });
  forget_above_ = std::max<std::size_t>(10'000, 2 * known_.size());
}

}  // namespace soarbox::language
