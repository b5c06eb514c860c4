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
#include "cli/result_node.h"
#include "cli/session.h"

namespace soarbox::cli {

struct CommandCall;
struct SourceRun;

/// The Soar command language of one kernel. Aliases, directories and files are shared by its agents; everything else
/// belongs to the session in which a command is executed.
///
/// Execute accepts any text and never throws. A line can contain several commands; it ends at the first one that fails.
/// A sourced file continues after a command that fails, and reports all failures.
///
/// Commands can be executed within a run (`cmd` in a rule, a callback of a client). Those that would damage the running
/// agent are refused.
///
/// Not thread-safe: used on the thread that owns the kernel.
class Interpreter {
 public:
  /// `host` must outlive the interpreter; without one, agents run alone.
  explicit Interpreter(Host* host = nullptr);
  ~Interpreter();

  CommandResult Execute(Session& session, std::string_view line);

  /// Completions of the last word of `line`: command words, subcommands, options, rule names, file names.
  std::vector<std::string> Complete(Session& session, std::string_view line) const;

  AliasTable& aliases() { return aliases_; }
  Host& host() { return *host_; }

  /// The directory that file names are relative to; at first that of the process. `cd` changes only this.
  const std::filesystem::path& directory() const { return directory_; }
  bool ChangeDirectory(const std::string& path);
  /// Returns to the directory that was current before a file was read. The fence does not apply.
  void GoBackTo(std::filesystem::path directory);
  std::vector<std::filesystem::path>& directory_stack() { return directory_stack_; }
  /// The path of a file name as typed, relative to directory().
  std::filesystem::path Resolve(const std::string& file) const;
  /// Replaces backslashes by slashes, if the file exists only under that name. Otherwise returns the name unchanged.
  std::string WithSlashes(const std::string& file) const;

  /// Called for each file of commands before it is executed, with its content. May be empty.
  std::function<void(const std::filesystem::path& file, std::string_view content)> on_file_read;

  /// For commands that read a file: sets its path. Fails the call if the fence does not allow to read it, or if it is
  /// larger than 256 MiB.
  bool ResolveForReading(CommandCall& call, const std::string& file, std::filesystem::path& path) const;
  /// For commands that write a file: sets its path. Fails the call if there is a fence.
  bool ResolveForWriting(CommandCall& call, const std::string& file, std::filesystem::path& path) const;

  /// During its lifetime, commands come from files of a stranger, and the fence restricts them. Null: no fence.
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

  /// For commands that execute others (source, time, command-to-file). Appends to call.result.text. Expands aliases in
  /// `words`.
  bool ExecuteWords(CommandCall& call, std::vector<Word>& words);
  /// The running source command; null if there is none.
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

/// If the line is one `source` or `load` command that names an existing file, returns the line with the absolute path
/// of the file. Otherwise returns it unchanged.
std::string WithWholeFileName(const Interpreter& interpreter, std::string_view line);

}  // namespace soarbox::cli
