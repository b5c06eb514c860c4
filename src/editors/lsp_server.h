// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editors/json_type.h"
#include "language/hover.h"
#include "language/workspace.h"
#include "sim/scenario.h"

namespace soarbox::editors {

/// The Language Server Protocol (3.17) for Soar rules, without its framing: it converts messages to answers.
///
/// It answers all requests as the protocol demands, including invalid ones; only `exit` ends it. Edits can be complete
/// texts or ranges; positions are in UTF-16 code units.
class LspServer {
 public:
  /// `data`: needed to simulate recordings again for the command soarbox.why; null: the command is refused. Only files
  /// below `folders` are read; empty: all files.
  explicit LspServer(const sim::DataFolders* data = nullptr, std::vector<std::filesystem::path> folders = {})
      : data_(data), workspace_(std::move(folders)) {}

  /// Processes one message. Text that is not JSON is answered with an error.
  std::vector<Json> Handle(const std::string& message);
  /// The answer to bytes that are not a message.
  static Json Fault(const std::string& what);
  /// Does slow work: searches slips in entire programs. After edits, it checks the programs of the edited files;
  /// otherwise some of the programs of which no file is open. Returns the diagnostics to send. Call it when no message
  /// is waiting.
  std::vector<Json> Idle();
  bool HasIdleWork() const { return !unchecked_.empty() || !closed_.empty(); }

  bool is_over() const { return over_; }
  /// 0 if the client sent `shutdown` before `exit`, else 1.
  int exit_code() const { return shut_down_ ? 0 : 1; }

 private:
  using Document = language::Document;
  using DocumentPtr = std::shared_ptr<const Document>;
  struct Place {
    std::filesystem::path path;
    DocumentPtr document;
    std::size_t offset = 0;
  };

  void Dispatch(const Json& message);
  Json Request(const std::string& method, const Json& params);
  void Notify(const std::string& method, const Json& params);

  Json Initialize(const Json& params);
  Json CodeActions(const Json& params);
  Json CodeLenses(const Json& params);
  Json CompletionAt(const Json& params);
  Json Definition(const Json& params);
  Json DocumentSymbols(const Json& params);
  Json ExecuteCommand(const Json& params);
  Json Folding(const Json& params);
  Json Formatting(const Json& params);
  Json Highlights(const Json& params);
  Json HoverAt(const Json& params);
  Json PrepareRename(const Json& params);
  Json References(const Json& params);
  Json RenameAt(const Json& params);
  Json SemanticTokens(const Json& params);
  Json WorkspaceSymbols(const Json& params);
  Json OperatorTree(const Json& params);
  Json DatamapOf(const Json& params);

  void Changed(const Json& params);
  void Closed(const std::filesystem::path& path);
  /// Removes the diagnostics of files outside of the editor's folders.
  void ForgetOthers();
  void ChangedOnDisk(const Json& params);
  /// Lets Idle() check all programs in the editor's folders.
  void CheckFolders();
  void CheckProgramOf(const std::filesystem::path& path, std::set<std::vector<std::filesystem::path>>& checked);
  void ChangeFolders(const Json& event);
  DocumentPtr DocumentOf(const Json& params);
  Place PlaceOf(const Json& params);
  Json LocationOf(const language::Use& use);
  /// Publishes the diagnostics of a file, which replace the previous ones. For a file that is not open and has no
  /// diagnostics, nothing is sent.
  void Publish(const std::filesystem::path& path);
  void PublishNothing(const std::filesystem::path& path);
  const language::LastRun* LastRunBeside(const std::filesystem::path& file);

  const sim::DataFolders* data_;
  language::Workspace workspace_;
  std::vector<Json> out_;
  bool initialized_ = false, shut_down_ = false, over_ = false;
  std::set<std::filesystem::path> unchecked_;  ///< Open files whose programs Idle() must check.
  std::set<std::filesystem::path> closed_;     ///< Other files whose programs it must check, after those.
  /// Slips by file, from the last check of all rules. Their lines are adjusted when text is typed above them.
  std::map<std::filesystem::path, std::vector<Diagnostic>> slips_;
  std::map<std::filesystem::path, std::string> published_;  ///< The diagnostics that were sent last, as JSON.
  struct KnownRun {
    std::filesystem::file_time_type time;
    std::optional<language::LastRun> run;
  };
  std::map<std::filesystem::path, KnownRun> runs_;
};

/// Serves on two file descriptors until the client sends `exit` or closes its end. Returns the exit code of the
/// process.
int ServeLsp(int in, int out, const sim::DataFolders* data);

}  // namespace soarbox::editors
