// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/aliases.h"
#include "cli/fence.h"
#include "cli/host.h"
#include "cli/result.h"
#include "cli/session.h"

namespace soarbox::cli {

struct CommandCall;
struct SourceRun;

/// The Soar command language of one kernel. Its agents share aliases, directories and files; everything else belongs to
/// the session that receives a command.
///
/// Execute accepts any text and never throws. A line may hold several commands; it ends at the first that fails. A
/// sourced file continues after a command that fails, and reports all failures.
///
/// Commands may come from within a run (a rule's `cmd`, a callback of a client). Those that would break the running
/// agent are refused.
///
/// Not thread-safe: called by the thread that owns the kernel.
class Interpreter {
 public:
  /// `host` must outlive the interpreter; without one, agents run alone.
  explicit Interpreter(Host* host = nullptr);
  ~Interpreter();

  CommandResult Execute(Session& session, std::string_view line);

  /// How the last word of `line` may continue: command words, sub-commands, options, rule names, file names.
  std::vector<std::string> Complete(Session& session, std::string_view line) const;

  AliasTable& aliases() { return aliases_; }
  Host& host() { return *host_; }

  /// The directory that relative file names start from; at first that of the process. `cd` changes only this.
  const std::filesystem::path& directory() const { return directory_; }
  bool ChangeDirectory(const std::string& path);
  /// Returns to the directory from before a file was read; the fence does not apply.
  void GoBackTo(std::filesystem::path directory);
  std::vector<std::filesystem::path>& directory_stack() { return directory_stack_; }
  /// A file name as typed, relative to directory().
  std::filesystem::path Resolve(const std::string& file) const;
  /// A file's name as another system writes it, with slashes for its backslashes, if only this names a file.
  std::string WithSlashes(const std::string& file) const;

  /// Hears of each file of commands that is read, with its content, before it is carried out. May be empty.
  std::function<void(const std::filesystem::path& file, std::string_view content)> on_file_read;

  /// For commands that read a file: its path, or a failure of the call if it lies outside the fence.
  bool ResolveForReading(CommandCall& call, const std::string& file, std::filesystem::path& path) const;
  /// For commands that write a file: inside a fence nothing may be written.
  bool ResolveForWriting(CommandCall& call, const std::string& file, std::filesystem::path& path) const;

  /// While one exists, commands come from a stranger's files and the fence applies to them. Null: no fence.
  class Fenced {
   public:
    Fenced(Interpreter& interpreter, const Fence* fence)
        : interpreter_(interpreter), before_(std::exchange(interpreter.fence_, fence)) {}
    ~Fenced() { interpreter_.fence_ = before_; }
    Fenced(const Fenced&) = delete;
    Fenced& operator=(const Fenced&) = delete;

   private:
    Interpreter& interpreter_;
    const Fence* before_;
  };
  const Fence* fence() const { return fence_; }

  /// For commands that run others (source, time, command-to-file). Appends to call.result.text and expands aliases in
  /// `words`.
  bool ExecuteWords(CommandCall& call, std::vector<Word>& words);
  /// The source command that is running, if any.
  SourceRun*& source_run() { return source_run_; }

 private:
  Host default_host_;
  Host* host_;
  AliasTable aliases_;
  std::filesystem::path directory_;
  std::vector<std::filesystem::path> directory_stack_;
  SourceRun* source_run_ = nullptr;
  const Fence* fence_ = nullptr;
  int depth_ = 0;
};

/// The line as it is, unless it only loads a file: then it names the file by its absolute path.
std::string WithWholeFileName(const Interpreter& interpreter, std::string_view line);

}  // namespace soarbox::cli
