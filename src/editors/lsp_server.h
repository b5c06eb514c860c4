// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "editors/json.h"
#include "language/hover.h"
#include "language/workspace.h"
#include "sim/scenario.h"

namespace soarbox::editors {

/// The Language Server Protocol (3.17) for Soar's rules, without its framing: messages in, messages out.
///
/// Any message is answered as the protocol says, whatever it holds; none ends the process but `exit`. Edits come in
/// whole or as changes of ranges, positions in units of UTF-16.
class LspServer {
 public:
  /// `data`: to simulate recordings again for *why*; null: that is refused. Nothing but files below the folders is
  /// read; none: any.
  explicit LspServer(const sim::DataFolders* data = nullptr, std::vector<std::filesystem::path> folders = {})
      : data_(data), workspace_(std::move(folders)) {}

  /// Takes one message, as text; what is no JSON is answered too.
  std::vector<Json> Handle(const std::string& message);
  /// The answer to bytes that are no message.
  static Json Fault(const std::string& what);
  /// What takes longer than a keystroke may (slips of whole programs), for files that were edited since. To be called
  /// when no message waits; returns at once if there is nothing to do.
  std::vector<Json> Idle();
  bool HasIdleWork() const { return !unchecked_.empty(); }

  bool is_over() const { return over_; }
  /// 0 if the client said `shutdown` before `exit`.
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

  void Changed(const Json& params);
  void Closed(const std::filesystem::path& path);
  void ChangeFolders(const Json& event);
  DocumentPtr DocumentOf(const Json& params);
  Place PlaceOf(const Json& params);
  Json LocationOf(const language::Use& use);
  /// What was said of the file before is replaced. Of a file that is not open nothing is published as long as nothing
  /// was found.
  void Publish(const std::filesystem::path& path);
  void PublishNothing(const std::filesystem::path& path);
  const language::LastRun* LastRunBeside(const std::filesystem::path& file);

  const sim::DataFolders* data_;
  language::Workspace workspace_;
  std::vector<Json> out_;
  bool initialized_ = false, shut_down_ = false, over_ = false;
  std::set<std::filesystem::path> unchecked_;
  /// Slips as they were when all rules were looked over last, by file. Lines move with what is typed above them.
  std::map<std::filesystem::path, std::vector<Diagnostic>> slips_;
  std::map<std::filesystem::path, std::string> published_;
  struct KnownRun {
    std::filesystem::file_time_type time;
    std::optional<language::LastRun> run;
  };
  std::map<std::filesystem::path, KnownRun> runs_;
};

/// Serves on two file descriptors until the client says `exit` or closes its end. Returns the process's exit code.
int ServeLsp(int in, int out, const sim::DataFolders* data);

}  // namespace soarbox::editors
