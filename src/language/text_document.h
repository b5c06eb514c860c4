// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "language/command_reader.h"
#include "language/lines.h"
#include "language/rule_words.h"

namespace soarbox::language {

/// A command in a file, as the kernel reads it.
struct DocumentCommand {
  Span span;     ///< Complete lines, to the end of the command.
  int line = 1;  ///< Line of the span's begin, from 1.
  std::shared_ptr<const ReadCommand> read;
};

/// The words of a rule and its position in the file.
struct DocumentRule {
  Span span;  ///< To the next rule.
  Span body;  ///< `span` without the blanks and comments at its end.
  std::shared_ptr<const RuleWords> words;
};

/// A cache of the words of rules, by text.
class WordCache {
 public:
  std::shared_ptr<const RuleWords> Read(std::string_view rule);

 private:
  std::unordered_map<std::string, std::shared_ptr<const RuleWords>> known_;
};

/// A file of rules after reading. Immutable: an edit creates another document. Then only rules and commands whose text
/// is new are parsed.
class Document {
 public:
  Document(std::filesystem::path path, std::string text, RuleReader& reader, WordCache& words);
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  const std::filesystem::path& path() const { return path_; }
  const std::string& text() const { return text_; }
  /// The text with comments blanked; positions are the same.
  const std::string& code() const { return code_; }
  const Lines& lines() const { return lines_; }
  const std::vector<DocumentCommand>& commands() const { return commands_; }
  const std::vector<DocumentRule>& rules() const { return rules_; }
  /// The errors and warnings of the readers of commands and rules, with positions in this file.
  const std::vector<Diagnostic>& problems() const { return problems_; }
  /// The files that it sources, with the lines of the commands.
  struct Sourced {
    std::string name;            ///< As written in the command.
    std::filesystem::path file;  ///< Relative to the file's folder, after the `pushd` and `cd` commands before it.
    int line = 1;
  };
  const std::vector<Sourced>& sourced() const { return sourced_; }

  /// The rule that contains an offset; null if there is none.
  const DocumentRule* RuleAt(std::size_t offset) const;
  /// The part of the text that a problem is about.
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
