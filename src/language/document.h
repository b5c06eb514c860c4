// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "language/lines.h"
#include "language/rule_reader.h"
#include "language/rule_words.h"

namespace soarbox::language {

/// A command of a file, as the kernel reads it.
struct DocumentCommand {
  Span span;     ///< Whole lines, up to the command's end.
  int line = 1;  ///< Of the span's begin, from 1.
  std::shared_ptr<const ReadCommand> read;
};

/// A rule's words at their place in the file.
struct DocumentRule {
  Span span;  ///< Up to the next rule.
  Span body;  ///< Without the blanks and comments behind its last bracket.
  std::shared_ptr<const RuleWords> words;
};

/// Words of rules that are known, by text.
class WordCache {
 public:
  std::shared_ptr<const RuleWords> Read(std::string_view rule);

 private:
  std::unordered_map<std::string, std::shared_ptr<const RuleWords>> known_;
};

/// A file of rules that was read. It never changes: an edit makes another document, at the cost of what was edited.
class Document {
 public:
  Document(std::filesystem::path path, std::string text, RuleReader& reader, WordCache& words);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::string& text() const { return text_; }
  /// With comments blanked, places as they are.
  const std::string& code() const { return code_; }
  const Lines& lines() const { return lines_; }
  const std::vector<DocumentCommand>& commands() const { return commands_; }
  const std::vector<DocumentRule>& rules() const { return rules_; }
  /// What the reader of commands and of rules says, with this file's places.
  const std::vector<Diagnostic>& problems() const { return problems_; }
  /// The files that it sources, with the lines of the commands.
  struct Sourced {
    std::string name;            ///< As it is written.
    std::filesystem::path file;  ///< From the file's own folder, after the `pushd` and `cd` before it.
    int line = 1;
  };
  const std::vector<Sourced>& sourced() const { return sourced_; }

  /// The rule that an offset lies in; null if none does.
  const DocumentRule* RuleAt(std::size_t offset) const;
  /// The part of the text that a problem points at.
  Span SpanOf(const Diagnostic& problem) const;

 private:
  void ReadCommands(RuleReader& reader);
  void AddProblems(RuleReader& reader, const std::vector<cli::Word>& words, const DocumentCommand& command);

  std::filesystem::path path_;
  std::string text_, code_;
  Lines lines_;
  std::vector<DocumentCommand> commands_;
  std::vector<DocumentRule> rules_;
  std::vector<Diagnostic> problems_;
  std::vector<Sourced> sourced_;
};

}  // namespace soarbox::language
