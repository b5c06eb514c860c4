// SPDX-License-Identifier: BSD-2-Clause
// Requests of the language server: completion, hover, symbols, folding, formatting, colors, quick fixes, and code
// lenses with the firings in the last run.
#include <algorithm>

#include "debugger/why.h"
#include "editors/file_uri.h"
#include "editors/last_run.h"
#include "editors/lsp_json.h"
#include "editors/lsp_server.h"
#include "language/complete.h"
#include "language/format_rules.h"
#include "language/soar_help.h"
#include "record/reader.h"
#include "record/rerun.h"

namespace soarbox::editors {
namespace {

namespace fs = std::filesystem;

constexpr int kFunctionSymbol = 12;

}  // namespace

Json LspServer::CompletionAt(const Json& params) {
  const Place place = PlaceOf(params);
  const language::Proposals proposals =
      language::Complete(workspace_.ProgramOf(place.path), *place.document, place.offset);
  const Json range = RangeOf(place.document->lines(), proposals.replaced);
  Json items = Json::array();
  for (const language::Proposal& proposal : proposals.list) items.push_back(ToLsp(proposal, range, items.size()));
  return {{"isIncomplete", false}, {"items", std::move(items)}};
}

Json LspServer::HoverAt(const Json& params) {
  const Place place = PlaceOf(params);
  const std::optional<language::Name> name = language::NameAt(*place.document, place.offset);
  if (!name || name->kind == language::Name::Kind::kValue) {
    const std::optional<language::SoarWord> word = language::SoarWordAt(*place.document, place.offset);
    if (word)
      return {{"contents", {{"kind", "markdown"}, {"value", word->text}}},
              {"range", RangeOf(place.document->lines(), word->span)}};
  }
  if (!name) return nullptr;
  const std::string text =
      language::Hover(workspace_.ProgramOf(place.path), *place.document, *name, LastRunBeside(place.path));
  if (text.empty()) return nullptr;
  return {{"contents", {{"kind", "markdown"}, {"value", text}}},
          {"range", RangeOf(place.document->lines(), name->span)}};
}

Json LspServer::DocumentSymbols(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  Json list = Json::array();
  for (const language::DocumentRule& rule : document->rules()) {
    const language::Span& name = rule.words->name_span;
    const language::Span placed{rule.span.begin + name.begin, rule.span.begin + name.end};
    list.push_back({{"name", rule.words->name.empty() ? "(no name)" : rule.words->name},
                    {"kind", kFunctionSymbol},
                    {"range", RangeOf(document->lines(), rule.body)},
                    {"selectionRange", RangeOf(document->lines(), rule.words->name.empty() ? rule.body : placed)}});
  }
  return list;
}

Json LspServer::WorkspaceSymbols(const Json& params) {
  const std::string query = params.value("query", "");
  constexpr std::size_t kMost = 1'000;
  Json list = Json::array();
  std::set<fs::path> roots;
  for (const fs::path& open : workspace_.OpenFiles()) {
    const language::Program program = workspace_.ProgramOf(open);
    if (!roots.insert(program.root).second) continue;
    for (const DocumentPtr& document : program.documents)
      for (const language::DocumentRule& rule : document->rules()) {
        if (list.size() >= kMost || rule.words->name.find(query) == std::string::npos) continue;
        list.push_back(
            {{"name", rule.words->name},
             {"kind", kFunctionSymbol},
             {"location", {{"uri", UriOf(document->path())}, {"range", RangeOf(document->lines(), rule.body)}}}});
      }
  }
  return list;
}

Json LspServer::Folding(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  const language::Lines& lines = document->lines();
  Json list = Json::array();
  for (const language::DocumentRule& rule : document->rules()) {
    const std::size_t first = lines.LineOf(rule.body.begin), last = lines.LineOf(rule.body.end);
    if (last > first) list.push_back({{"startLine", first}, {"endLine", last}});
  }
  // Two or more consecutive lines of comments can be folded.
  for (std::size_t line = 0; line < lines.count(); ++line) {
    std::size_t end = line;
    while (end < lines.count() && lines.Line(end).starts_with('#')) ++end;
    if (end > line + 1) list.push_back({{"startLine", line}, {"endLine", end - 1}, {"kind", "comment"}});
    line = std::max(line, end > 0 ? end - 1 : 0);
  }
  return list;
}

Json LspServer::Formatting(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  const std::string made = language::FormatRules(document->text());
  if (made == document->text()) return Json::array();
  return Json::array({{{"range", RangeOf(document->lines(), {0, document->text().size()})}, {"newText", made}}});
}

Json LspServer::SemanticTokens(const Json& params) {
  return {{"data", PackTokens(*DocumentOf(params))}};
}

Json LspServer::CodeActions(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  Json list = Json::array();
  for (const Json& problem : params.at("context").at("diagnostics")) {
    const std::string hint = problem.value("/data/hint"_json_pointer, "");
    const std::string message = problem.value("message", "");
    const std::size_t line_end = message.find('\n');
    const std::string meant = MeantBy(!hint.empty()                   ? hint
                                      : line_end == std::string::npos ? std::string()
                                                                      : message.substr(line_end + 1));
    if (meant.empty()) continue;
    // The underlined range may include the ^, the replacement does not.
    Json range = problem.at("range");
    const auto offset = [&](const char* end) {
      const Json& at = range.at(end);
      return document->lines().OffsetOf({at.at("line").get<std::size_t>(), at.at("character").get<std::size_t>()});
    };
    std::size_t begin = offset("start");
    const std::size_t end = offset("end");
    if (begin < end && document->text()[begin] == '^') ++begin;
    range = RangeOf(document->lines(), {begin, end});
    list.push_back(
        {{"title", "Write " + meant},
         {"kind", "quickfix"},
         {"diagnostics", Json::array({problem})},
         {"isPreferred", true},
         {"edit", {{"changes", {{UriOf(document->path()), Json::array({{{"range", range}, {"newText", meant}}})}}}}}});
  }
  return list;
}

const language::LastRun* LspServer::LastRunBeside(const fs::path& file) {
  const fs::path recording = NewestRecording(file.parent_path());
  if (recording.empty()) return nullptr;
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(recording, error);
  KnownRun& known = runs_[recording];
  if (!known.run || known.time != time) known = {time, ReadFirings(recording)};
  return known.run ? &*known.run : nullptr;
}

Json LspServer::CodeLenses(const Json& params) {
  const DocumentPtr document = DocumentOf(params);
  Json list = Json::array();
  const language::LastRun* run = LastRunBeside(document->path());
  if (run == nullptr) return list;
  for (const language::DocumentRule& rule : document->rules()) {
    const std::string text = language::TellFirings(*run, rule.words->name);
    if (text.empty() || rule.words->name.empty()) continue;
    list.push_back(
        {{"range", RangeOf(document->lines(), {rule.span.begin, rule.span.begin + 2})},
         {"command",
          {{"title", text}, {"command", "soarbox.why"}, {"arguments", {rule.words->name, run->file.string()}}}}});
  }
  return list;
}

Json LspServer::ExecuteCommand(const Json& params) {
  const auto refuse = [](const std::string& text) { return Json{{"text", text}}; };
  if (params.at("command").get<std::string>() != "soarbox.why") return refuse("there is no such command");
  const Json& arguments = params.at("arguments");
  const std::string rule = arguments.at(0).get<std::string>();
  const fs::path recording = arguments.at(1).get<std::string>();
  if (data_ == nullptr) return refuse("the scenarios that come with the program are not found");
  Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(recording);
  if (!opened) return refuse(Format(opened.error()));
  // The moment of the explanation is the end of the recording from which the code lens was made.
  Result<record::Rerun> again = record::GoTo(**opened, (*opened)->last_tick(), *data_);
  if (!again) return refuse(Format(again.error()));
  sim::Simulation& world = *again->simulation;
  std::string text;
  for (std::size_t i = 0; i < world.soar_agents(); ++i) {
    const std::string agent = world.AgentOfMind(i);
    const Result<debugger::WhyNode> why = debugger::WhyName(world, agent, rule);
    if (why) text += agent + ": " + debugger::ToText(*why);
  }
  return refuse(text.empty() ? "no agent of this recording has rule " + rule : text);
}

}  // namespace soarbox::editors
