// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "diagnostics/diagnostic.h"
#include "explain/rule_text.h"
#include "kernel/base/symbol_table.h"
#include "kernel/rules/production.h"

namespace soarbox::cli {
class Interpreter;
class Session;
struct Word;
}  // namespace soarbox::cli
namespace soarbox::kernel {
class Agent;
}

namespace soarbox::language {

/// The result of the kernel's reader for one command of a file. Lines count from 1, the first line of the command's
/// text.
struct ReadCommand {
  std::string id;                            ///< Name of the file in messages about `rules`.
  std::vector<kernel::ProductionPtr> rules;  ///< More than one for `gp`; empty for other commands and refused rules.
  std::vector<explain::RuleText> texts;      ///< The contents of the rules.
  std::vector<Diagnostic> problems;
  std::string name;     ///< Name of the rule, even if it was refused.
  std::string sourced;  ///< The file that the command sources; the other members are then empty.
  int line = 0;         ///< Its first line in the text that was read together with it, from 0.
};

/// Parses commands with the kernel's reader, and caches the results so that only edited commands are parsed again.
///
/// Parsing a rule takes about 50 µs; a cached rule takes 2 µs. The reader keeps the symbols of all rules.
class RuleReader {
 public:
  RuleReader();
  ~RuleReader();
  RuleReader(const RuleReader&) = delete;
  RuleReader& operator=(const RuleReader&) = delete;

  /// `text`: the entire command, from the beginning of its first line. `line`: number of that line in the file, from 1.
  /// `words`: the words of the command.
  std::shared_ptr<const ReadCommand> Read(const std::string& text, const std::vector<cli::Word>& words, int line);

  const kernel::SymbolTable& symbols() const { return symbols_; }
  /// Number of commands that were parsed so far.
  std::size_t reads() const { return reads_; }

 private:
  void ReadRule(const std::string& body, int line, int column, ReadCommand& read);
  void ReadGenerated(const cli::Word& body, int line, ReadCommand& read);
  void ReadOther(const std::string& text, ReadCommand& read);
  void Forget();

  kernel::SymbolTable symbols_;
  std::unique_ptr<kernel::Agent> agent_;  ///< The agent that executes the commands; they change nothing.
  std::unique_ptr<cli::Session> session_;
  std::unique_ptr<cli::Interpreter> interpreter_;
  std::unordered_map<std::string, std::shared_ptr<const ReadCommand>> known_;
  std::size_t reads_ = 0, forget_above_ = 10'000;
};

}  // namespace soarbox::language
