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

/// What the kernel's own reader made of one command of a file. Lines count from 1, the first of the command's text.
struct ReadCommand {
  std::string id;                            ///< Stands for the file in what is said about `rules`.
  std::vector<kernel::ProductionPtr> rules;  ///< More than one for `gp`; none for other commands and refused rules.
  std::vector<explain::RuleText> texts;      ///< What the rules say.
  std::vector<Diagnostic> problems;
  std::string name;     ///< Of the rule, also of one that was refused.
  std::string sourced;  ///< The file that it sources; then nothing else is there.
  int line = 0;         ///< Where it begins in the text that was read with it, from 0.
};

/// Hands commands to the kernel's reader, and remembers the answers: what was not edited is not read again.
///
/// Reading a rule takes some 50 microseconds, and 2 if the rule is known. The reader keeps the symbols of all rules.
class RuleReader {
 public:
  RuleReader();
  ~RuleReader();
  RuleReader(const RuleReader&) = delete;
  RuleReader& operator=(const RuleReader&) = delete;

  /// `text`: all of the command, from the beginning of its first line, which is `line` of the file, counted from 1.
  /// `words`: the same, taken apart.
  std::shared_ptr<const ReadCommand> Read(const std::string& text, const std::vector<cli::Word>& words, int line);

  const kernel::SymbolTable& symbols() const { return symbols_; }
  /// How many commands were handed to the kernel so far.
  std::size_t reads() const { return reads_; }

 private:
  void ReadRule(const std::string& body, int line, int column, ReadCommand& read);
  void ReadGenerated(const cli::Word& body, int line, ReadCommand& read);
  void ReadOther(const std::string& text, ReadCommand& read);
  void Forget();

  kernel::SymbolTable symbols_;
  std::unique_ptr<kernel::Agent> agent_;  ///< Whose commands are tried; they change nothing.
  std::unique_ptr<cli::Session> session_;
  std::unique_ptr<cli::Interpreter> interpreter_;
  std::unordered_map<std::string, std::shared_ptr<const ReadCommand>> known_;
  std::size_t reads_ = 0, forget_above_ = 10'000;
};

}  // namespace soarbox::language
