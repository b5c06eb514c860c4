// SPDX-License-Identifier: BSD-2-Clause
#include "language/text_document.h"

#include <algorithm>
#include <utility>

#include "cli/tokens.h"
#include "diagnostics/plain_text.h"
#include "explain/clarify_errors.h"
#include "explain/rule_text.h"

namespace soarbox::language {

std::shared_ptr<const RuleWords> WordCache::Read(std::string_view rule) {
  std::string text(rule);
  if (const auto known = known_.find(text); known != known_.end()) return known->second;
  constexpr std::size_t kMost = 20'000;
  if (known_.size() > kMost) std::erase_if(known_, [](const auto& one) { return one.second.use_count() == 1; });
  auto words = std::make_shared<const RuleWords>(ReadWords(rule));
  known_.emplace(std::move(text), words);
  return words;
}

Document::Document(std::filesystem::path path, std::string text, RuleReader& reader, WordCache& words)
    : path_(std::move(path)), text_(std::move(text)), code_(explain::BlankComments(text_)), lines_(text_) {
  for (const Span& span : SplitAtRules(text_)) {
    const std::size_t last = code_.find_last_not_of(" \t\r\n", span.end == 0 ? 0 : span.end - 1);
    const Span body{span.begin, last == std::string::npos ? span.end : std::max(span.begin, last + 1)};
    rules_.push_back({span, body, words.Read(std::string_view(text_).substr(body.begin, body.end - body.begin))});
  }
  ReadCommands(reader);
}

void Document::ReadCommands(RuleReader& reader) {
  if (std::string why = WhyNoPlainText(text_); !why.empty()) {
    Diagnostic problem;
    problem.file = path_.string();
    problem.line = 1;
    problem.message = std::move(why);
    problems_.push_back(std::move(problem));
    return;
  }
  std::vector<Diagnostic> unread;
  cli::CommandReader commands(text_);
  std::vector<cli::Word> words;
  std::vector<std::filesystem::path> folders = {""};  // Names are relative to the last one.
  while (true) {
    const cli::CommandReader::Status status = commands.Next(words);
    if (status == cli::CommandReader::Status::kEnd) break;
    if (status == cli::CommandReader::Status::kError) {
      Diagnostic problem;
      problem.file = path_.string();
      problem.line = commands.error_line();
      problem.column = commands.error_column();
      problem.message = commands.error();
      unread.push_back(std::move(problem));
      commands.Recover();
      continue;
    }
    DocumentCommand command;
    command.line = words.front().line;
    command.span = {lines_.Begin(static_cast<std::size_t>(command.line) - 1), commands.offset()};
    command.read =
        reader.Read(text_.substr(command.span.begin, command.span.end - command.span.begin), words, command.line);
    if (!command.read->sourced.empty())
      sourced_.push_back(
          {command.read->sourced, (folders.back() / command.read->sourced).lexically_normal(), command.line});
    const std::string& name = words.front().text;
    if (words.size() == 2 && name == "pushd") folders.push_back(folders.back() / words[1].text);
    if (words.size() == 2 && name == "cd") folders.back() /= words[1].text;
    if (name == "popd" && folders.size() > 1) folders.pop_back();
    AddProblems(reader, words, command);
    commands_.push_back(std::move(command));
  }
  explain::ClarifyErrors(unread, [&](const std::string&) { return text_; });
  problems_.insert(problems_.end(), unread.begin(), unread.end());
}

void Document::AddProblems(RuleReader& reader, const std::vector<cli::Word>& words, const DocumentCommand& command) {
  constexpr std::size_t kMostReadAgain = 100;  // Each takes as many bytes as the file has lines.
  const auto names_line = [](const Diagnostic& problem) {
    return problem.message.find("line ") != std::string::npos || problem.hint.find("line ") != std::string::npos;
  };
  std::shared_ptr<const ReadCommand> read = command.read;
  int above = command.line - 1;
  if (above > 0 && problems_.size() < kMostReadAgain && std::ranges::any_of(read->problems, names_line)) {
    // Line numbers in a problem's text count from where the parser starts, so it starts at the file's first line.
    const std::string text = text_.substr(command.span.begin, command.span.end - command.span.begin);
    read = reader.Read(std::string(static_cast<std::size_t>(above), '\n') + text, words, 1);
    above = 0;
  }
  for (Diagnostic problem : read->problems) {
    problem.file = path_.string();
    problem.line += above;
    problems_.push_back(std::move(problem));
  }
}

const DocumentRule* Document::RuleAt(std::size_t offset) const {
  const auto behind = std::upper_bound(rules_.begin(), rules_.end(), offset,
                                       [](std::size_t at, const DocumentRule& rule) { return at < rule.span.begin; });
  if (behind == rules_.begin()) return nullptr;
  const DocumentRule& rule = *std::prev(behind);
  return rule.body.Holds(offset) ? &rule : nullptr;
}

Span Document::SpanOf(const Diagnostic& problem) const {
  if (problem.line <= 0) return {0, lines_.Line(0).size()};
  const auto line = static_cast<std::size_t>(problem.line) - 1;
  const std::size_t begin = lines_.Begin(line), end = begin + lines_.Line(line).size();
  if (problem.column <= 0) {
    const std::size_t first = text_.find_first_not_of(" \t", begin);
    return {std::min(first, end), end};
  }
  const std::size_t from = std::min(begin + static_cast<std::size_t>(problem.column) - 1, end);
  const auto length = static_cast<std::size_t>(std::max(problem.excerpt_length, 1));
  return {from, std::min(from + length, end)};
}

}  // namespace soarbox::language
