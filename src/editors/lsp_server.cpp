// SPDX-License-Identifier: BSD-2-Clause
#include "editors/lsp_server.h"

#include <algorithm>

#include "editors/file_uri.h"
#include "editors/lsp_json.h"

namespace soarbox::editors {
namespace {

namespace fs = std::filesystem;
using language::Position;

// Error codes of JSON-RPC and of the protocol.
constexpr int kLspParseError = -32700, kLspInvalidRequest = -32600, kLspNoSuchMethod = -32601,
              kLspInvalidParams = -32602, kLspInternalError = -32603, kLspNotInitialized = -32002;

/// Maximum number of published problems per file, because more make editors slow.
constexpr std::size_t kMostProblems = 500;

/// Programs without an open file are checked only in folders with at most kMostChecked files of rules. One call of
/// Idle() checks at most kCheckedAtOnce of them, because the editor waits for answers during the call.
constexpr std::size_t kMostChecked = 1000, kCheckedAtOnce = 4;

constexpr int kWarningMessage = 2;  ///< A type of window/showMessage.

/// The error with which a request is refused.
struct LspRefusal {
  int code;
  std::string message;
};

Json LspError(const Json& id, int code, const std::string& message) {
  return {{"jsonrpc", "2.0"}, {"id", id}, {"error", {{"code", code}, {"message", message}}}};
}

Position PositionIn(const Json& json) {
  const auto number = [&](const char* name) {
    const Json& value = json.at(name);
    if (!value.is_number_unsigned()) throw LspRefusal{kLspInvalidParams, std::string(name) + " is not a position"};
    return value.get<std::size_t>();
  };
  return {number("line"), number("character")};
}

/// The paths of a list of WorkspaceFolder. URIs with another scheme than "file" are left out.
std::vector<fs::path> FoldersIn(const Json& list) {
  std::vector<fs::path> folders;
  for (const Json& one : list) {
    fs::path folder = PathOfUri(one.at("uri").get<std::string>());
    // Removes a slash at the end: "file:///home/me/" and "file:///home/me" are the same folder.
    if (!folder.has_filename()) folder = folder.parent_path();
    if (!folder.empty()) folders.push_back(std::move(folder));
  }
  return folders;
}

bool IsBelowOneOf(const std::vector<fs::path>& folders, const fs::path& file) {
  return std::ranges::any_of(
      folders, [&](const fs::path& folder) { return std::ranges::mismatch(folder, file).in1 == folder.end(); });
}

}  // namespace

Json LspServer::Fault(const std::string& what) {
  return LspError(nullptr, kLspParseError, what);
}

std::vector<Json> LspServer::Handle(const std::string& text) {
  out_.clear();
  const Json message = Json::parse(text, nullptr, false);
  if (message.is_discarded()) {
    out_.push_back(LspError(nullptr, kLspParseError, "this message is not JSON"));
  } else if (!message.is_object()) {
    out_.push_back(LspError(nullptr, kLspInvalidRequest, "this message is not an object"));
  } else {
    Dispatch(message);
  }
  return std::move(out_);
}

void LspServer::Dispatch(const Json& message) {
  const auto id_field = message.find("id");
  const bool is_request = id_field != message.end() && (id_field->is_string() || id_field->is_number_integer());
  const Json id = is_request ? *id_field : Json();
  const auto method = message.find("method");
  if (method == message.end() || !method->is_string()) {
    // The server sends no requests, so it ignores replies.
    const bool is_answer = message.contains("result") || message.contains("error");
    if (!is_answer) out_.push_back(LspError(id, kLspInvalidRequest, "this message has no method"));
    return;
  }
  const auto params_field = message.find("params");
  const Json params = params_field == message.end() ? Json::object() : *params_field;
  try {
    if (!is_request) return Notify(method->get<std::string>(), params);
    Json result = Request(method->get<std::string>(), params);
    out_.push_back({{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}});
  } catch (const LspRefusal& refused) {
    if (is_request) out_.push_back(LspError(id, refused.code, refused.message));
  } catch (const Json::exception& wrong) {
    if (is_request) out_.push_back(LspError(id, kLspInvalidParams, wrong.what()));
  } catch (const std::exception& wrong) {
    if (is_request) out_.push_back(LspError(id, kLspInternalError, wrong.what()));
  }
}

Json LspServer::Request(const std::string& method, const Json& params) {
  if (method == "initialize") return Initialize(params);
  if (!initialized_) throw LspRefusal{kLspNotInitialized, "initialize comes first"};
  if (shut_down_) throw LspRefusal{kLspInvalidRequest, "the server was shut down"};
  if (method == "shutdown") {
    shut_down_ = true;
    return nullptr;
  }
  using Handler = Json (LspServer::*)(const Json&);
  static const std::map<std::string, Handler> kHandlers = {
      {"soarbox/datamap", &LspServer::DatamapOf},
      {"soarbox/operators", &LspServer::OperatorTree},
      {"textDocument/codeAction", &LspServer::CodeActions},
      {"textDocument/codeLens", &LspServer::CodeLenses},
      {"textDocument/completion", &LspServer::CompletionAt},
      {"textDocument/definition", &LspServer::Definition},
      {"textDocument/documentHighlight", &LspServer::Highlights},
      {"textDocument/documentSymbol", &LspServer::DocumentSymbols},
      {"textDocument/foldingRange", &LspServer::Folding},
      {"textDocument/formatting", &LspServer::Formatting},
      {"textDocument/hover", &LspServer::HoverAt},
      {"textDocument/prepareRename", &LspServer::PrepareRename},
      {"textDocument/references", &LspServer::References},
      {"textDocument/rename", &LspServer::RenameAt},
      {"textDocument/semanticTokens/full", &LspServer::SemanticTokens},
      {"workspace/executeCommand", &LspServer::ExecuteCommand},
      {"workspace/symbol", &LspServer::WorkspaceSymbols},
  };
  const auto handler = kHandlers.find(method);
  if (handler == kHandlers.end()) throw LspRefusal{kLspNoSuchMethod, "there is no method " + method};
  return (this->*handler->second)(params);
}

void LspServer::Notify(const std::string& method, const Json& params) {
  if (method == "exit") {
    over_ = true;
    return;
  }
  if (!initialized_) return;
  const auto path_in = [&] { return PathOfUri(params.at("textDocument").at("uri").get<std::string>()); };
  if (method == "textDocument/didOpen") {
    const fs::path path = path_in();
    if (path.empty()) return;
    workspace_.Open(path, params.at("textDocument").at("text").get<std::string>());
    workspace_.LookAgain();
    unchecked_.insert(path);
    Publish(path);
  } else if (method == "textDocument/didChange") {
    Changed(params);
  } else if (method == "textDocument/didSave") {
    workspace_.LookAgain();
    unchecked_.insert(path_in());
  } else if (method == "textDocument/didClose") {
    Closed(path_in());
  } else if (method == "workspace/didChangeWatchedFiles") {
    ChangedOnDisk(params);
  } else if (method == "initialized") {
    CheckFolders();
  } else if (method == "workspace/didChangeWorkspaceFolders") {
    ChangeFolders(params.at("event"));
  }
}

void LspServer::Closed(const fs::path& path) {
  workspace_.Close(path);
  unchecked_.erase(path);
  slips_.erase(path);
  PublishNothing(path);
  const std::vector<fs::path> open = workspace_.OpenFiles();
  unchecked_.insert(open.begin(), open.end());
  if (IsBelowOneOf(workspace_.folders(), path)) closed_.insert(path);
  if (open.empty()) ForgetOthers();
}

void LspServer::ForgetOthers() {
  std::vector<fs::path> told;
  for (const auto& [file, text] : published_)
    if (!IsBelowOneOf(workspace_.folders(), file)) told.push_back(file);
  for (const fs::path& file : told) PublishNothing(file);
  std::erase_if(slips_, [&](const auto& entry) { return !IsBelowOneOf(workspace_.folders(), entry.first); });
}

void LspServer::ChangedOnDisk(const Json& params) {
  workspace_.LookAgain();
  for (const fs::path& path : workspace_.OpenFiles()) unchecked_.insert(path);
  const auto changes = params.find("changes");
  if (changes == params.end() || !changes->is_array()) return;
  bool is_other = false;
  for (const Json& change : *changes) {
    const fs::path path = PathOfUri(change.at("uri").get<std::string>());
    if (workspace_.IsOpen(path) || !IsBelowOneOf(workspace_.folders(), path) || path.extension() == ".soarrec")
      continue;
    is_other = true;
    if (published_.contains(path) && workspace_.Find(path) == nullptr) {
      slips_.erase(path);
      PublishNothing(path);
    }
  }
  // A file may load other files than before. A project or a scenario may define other names than before.
  if (is_other) CheckFolders();
}

void LspServer::CheckFolders() {
  for (fs::path& file : workspace_.FilesOfPrograms(kMostChecked)) closed_.insert(std::move(file));
}

void LspServer::PublishNothing(const fs::path& path) {
  published_.erase(path);
  out_.push_back({{"jsonrpc", "2.0"},
                  {"method", "textDocument/publishDiagnostics"},
                  {"params", {{"uri", UriOf(path)}, {"diagnostics", Json::array()}}}});
}

void LspServer::ChangeFolders(const Json& event) {
  std::vector<fs::path> folders = workspace_.folders();
  for (const Json& one : event.at("removed")) std::erase(folders, PathOfUri(one.at("uri").get<std::string>()));
  for (const fs::path& one : FoldersIn(event.at("added"))) folders.push_back(one);
  workspace_.SetFolders(std::move(folders));
  for (const fs::path& path : workspace_.OpenFiles()) unchecked_.insert(path);
  ForgetOthers();
  CheckFolders();
}

Json LspServer::Initialize(const Json& params) {
  if (initialized_) throw LspRefusal{kLspInvalidRequest, "the server is initialized already"};
  initialized_ = true;
  std::vector<fs::path> folders;
  const auto named = params.find("workspaceFolders"), root = params.find("rootUri");
  if (named != params.end() && named->is_array()) {
    folders = FoldersIn(*named);
  } else if (root != params.end() && root->is_string()) {
    folders = FoldersIn(Json::array({{{"uri", *root}}}));
  }
  workspace_.SetFolders(std::move(folders));
  return {{"serverInfo", {{"name", "soarbox"}}},
          {"capabilities",
           {{"positionEncoding", "utf-16"},
            {"textDocumentSync", {{"openClose", true}, {"change", 2}, {"save", true}}},
            {"completionProvider", {{"triggerCharacters", {"^", ".", "<", " "}}}},
            {"hoverProvider", true},
            {"definitionProvider", true},
            {"referencesProvider", true},
            {"documentHighlightProvider", true},
            {"documentSymbolProvider", true},
            {"workspaceSymbolProvider", true},
            {"workspace", {{"workspaceFolders", {{"supported", true}, {"changeNotifications", true}}}}},
            {"foldingRangeProvider", true},
            {"documentFormattingProvider", true},
            {"renameProvider", {{"prepareProvider", true}}},
            {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}},
            {"codeLensProvider", Json::object()},
            {"executeCommandProvider", {{"commands", {"soarbox.why"}}}},
            {"semanticTokensProvider",
             {{"legend", {{"tokenTypes", TokenTypes()}, {"tokenModifiers", Json::array()}}}, {"full", true}}}}}};
}

void LspServer::Changed(const Json& params) {
  const fs::path path = PathOfUri(params.at("textDocument").at("uri").get<std::string>());
  if (!workspace_.IsOpen(path)) return;
  std::string text = workspace_.Find(path)->text();
  for (const Json& change : params.at("contentChanges")) {
    const std::string& replacement = change.at("text").get_ref<const std::string&>();
    if (!change.contains("range")) {
      text = replacement;
      continue;
    }
    const language::Lines lines(text);
    const std::size_t begin = lines.OffsetOf(PositionIn(change.at("range").at("start")));
    const std::size_t end = lines.OffsetOf(PositionIn(change.at("range").at("end")));
    if (end < begin) throw LspRefusal{kLspInvalidParams, "this range ends before it begins"};
    text.replace(begin, end - begin, replacement);
  }
  // Slips below the edit move with their lines. Those in its first line are removed.
  const std::shared_ptr<const Document> before = workspace_.Find(path);
  const std::string& old = before->text();
  std::size_t same = 0;
  while (same < old.size() && same < text.size() && old[same] == text[same]) ++same;
  const int first_line = static_cast<int>(before->lines().LineOf(same)) + 1;
  const auto lines_of = [](const std::string& of) { return static_cast<int>(std::ranges::count(of, '\n')); };
  const int moved = lines_of(text) - lines_of(old);
  for (Diagnostic& slip : slips_[path])
    if (slip.line > first_line) slip.line += moved;
  std::erase_if(slips_[path], [&](const Diagnostic& slip) { return slip.line == first_line; });
  workspace_.Open(path, std::move(text));
  unchecked_.insert(path);
  Publish(path);
}

void LspServer::Publish(const fs::path& path) {
  const DocumentPtr document = workspace_.Find(path);
  if (document == nullptr) return;
  Json list = Json::array();
  std::set<std::string> told;
  const auto add = [&](const Diagnostic& problem) {
    if (list.size() < kMostProblems && told.insert(std::to_string(problem.line) + ":" + problem.message).second)
      list.push_back(ToLsp(problem, *document));
  };
  for (const Diagnostic& problem : document->problems()) add(problem);
  for (const Diagnostic& problem : workspace_.MissingFiles(*document)) add(problem);
  if (const auto slips = slips_.find(path); slips != slips_.end())
    for (const Diagnostic& problem : slips->second) add(problem);
  std::string text = list.dump(-1, ' ', false, Json::error_handler_t::replace);
  const auto known = published_.find(path);
  if (known == published_.end() && list.empty() && !workspace_.IsOpen(path)) return;
  if (known != published_.end() && known->second == text) return;
  published_[path] = std::move(text);
  out_.push_back({{"jsonrpc", "2.0"},
                  {"method", "textDocument/publishDiagnostics"},
                  {"params", {{"uri", UriOf(path)}, {"diagnostics", std::move(list)}}}});
}

std::vector<Json> LspServer::Idle() {
  out_.clear();
  std::set<std::vector<fs::path>> checked;
  const bool has_edits = !unchecked_.empty();
  for (const fs::path& path : std::exchange(unchecked_, {}))
    if (workspace_.IsOpen(path)) CheckProgramOf(path, checked);
  if (has_edits) return std::move(out_);
  for (std::size_t i = 0; i < kCheckedAtOnce && !closed_.empty(); ++i)
    CheckProgramOf(closed_.extract(closed_.begin()).value(), checked);
  return std::move(out_);
}

void LspServer::CheckProgramOf(const fs::path& path, std::set<std::vector<fs::path>>& checked) {
  if (workspace_.Find(path) == nullptr) return;
  const language::Program program = workspace_.ProgramOf(path);
  for (const std::string& notice : workspace_.TakeNotices())
    out_.push_back({{"jsonrpc", "2.0"},
                    {"method", "window/showMessage"},
                    {"params", {{"type", kWarningMessage}, {"message", notice}}}});
  if (!checked.insert(program.roots).second) return;
  for (auto& [file, slips] : workspace_.Slips(program)) {
    // A file can belong to several programs, and a slip in one need not be a slip in all. Therefore, the slips of a
    // file are published only by a check of all its programs.
    if (workspace_.RootsOf(file) != program.roots) continue;
    slips_[file] = std::move(slips);
    Publish(file);
  }
}

LspServer::DocumentPtr LspServer::DocumentOf(const Json& params) {
  const fs::path path = PathOfUri(params.at("textDocument").at("uri").get<std::string>());
  DocumentPtr document = path.empty() ? nullptr : workspace_.Find(path);
  if (document == nullptr) throw LspRefusal{kLspInvalidParams, "there is no such file"};
  return document;
}

LspServer::Place LspServer::PlaceOf(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  return {document->path(), document, document->lines().OffsetOf(PositionIn(params.at("position")))};
}

Json LspServer::LocationOf(const language::Use& use) {
  const DocumentPtr document = workspace_.Find(use.file);
  if (document == nullptr) return nullptr;
  return {{"uri", UriOf(use.file)}, {"range", RangeOf(document->lines(), use.span)}};
}

Json LspServer::RenameAt(const Json& params) {
  const Place place = PlaceOf(params);
  const language::Program program = workspace_.ProgramOf(place.path);
  const Result<language::Renaming> renaming =
      language::Rename(program, *place.document, place.offset, params.at("newName").get<std::string>());
  if (!renaming) {
    const Diagnostic& problem = renaming.error();
    throw LspRefusal{kLspInvalidParams, problem.message + (problem.hint.empty() ? "" : ": " + problem.hint)};
  }
  Json changes = Json::object();
  for (const language::Use& use : renaming->uses) {
    const language::Document* document = program.Find(use.file);
    if (document == nullptr) continue;
    changes[UriOf(use.file)].push_back({{"range", RangeOf(document->lines(), use.span)}, {"newText", renaming->text}});
  }
  return {{"changes", std::move(changes)}};
}

Json LspServer::PrepareRename(const Json& params) {
  const Place place = PlaceOf(params);
  const std::optional<language::Name> name = language::NameAt(*place.document, place.offset);
  if (!name) return nullptr;
  if (const std::string why = language::WhyNotRenamed(*name); !why.empty()) throw LspRefusal{kLspInvalidParams, why};
  return {{"range", RangeOf(place.document->lines(), name->span)}, {"placeholder", name->text}};
}

Json LspServer::Definition(const Json& params) {
  const Place place = PlaceOf(params);
  Json list = Json::array();
  for (const language::Use& use :
       language::DefinitionsOf(workspace_.ProgramOf(place.path), *place.document, place.offset))
    if (Json location = LocationOf(use); !location.is_null()) list.push_back(std::move(location));
  return list;
}

Json LspServer::References(const Json& params) {
  const Place place = PlaceOf(params);
  const std::optional<language::Name> name = language::NameAt(*place.document, place.offset);
  Json list = Json::array();
  if (!name) return list;
  const bool with_definitions = params.value("/context/includeDeclaration"_json_pointer, true);
  for (const language::Use& use : language::UsesOf(workspace_.ProgramOf(place.path), *name, place.path)) {
    if (use.defines && !with_definitions) continue;
    if (Json location = LocationOf(use); !location.is_null()) list.push_back(std::move(location));
  }
  return list;
}

Json LspServer::Highlights(const Json& params) {
  const Place place = PlaceOf(params);
  const std::optional<language::Name> name = language::NameAt(*place.document, place.offset);
  Json list = Json::array();
  if (!name) return list;
  language::Program alone;
  alone.root = place.path;
  alone.documents = {place.document};
  constexpr int kRead = 2, kWrite = 3;
  for (const language::Use& use : language::UsesOf(alone, *name, place.path))
    list.push_back({{"range", RangeOf(place.document->lines(), use.span)}, {"kind", use.defines ? kWrite : kRead}});
  return list;
}

}  // namespace soarbox::editors
