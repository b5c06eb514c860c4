// SPDX-License-Identifier: BSD-2-Clause
// The JSON form of a document for pages. document_fields.h has the fields of its parts.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "workbench/document/document_fields.h"
#include "workbench/requests_json.h"

namespace soarbox::workbench::document {
namespace {

constexpr std::string_view kRoles[] = {"plain", "strong", "quiet", "code", "good", "warn", "bad",
                                       "new",   "gone",   "num",   "obj",  "name", "tag"};

/// A plain text is a string; other spans are [text, role], and with an action or a tooltip [text, role, action, hint].
/// For a span with a tick, the number of the tick replaces the text.
Json SpanJson(const Span& span) {
  if (span.tick) {
    Json json = Json::array({*span.tick});
    if (span.role != Role::kPlain) json.push_back(std::string(WordOf(span.role)));
    return json;
  }
  if (span.role == Role::kPlain && !span.action && span.hint.empty()) return span.text;
  Json json = Json::array({span.text, std::string(WordOf(span.role))});
  if (span.action || !span.hint.empty()) json.push_back(span.action ? ToJson(*span.action) : Json());
  if (!span.hint.empty()) json.push_back(span.hint);
  return json;
}

}  // namespace

/// A single plain text is a string; otherwise a list.
Json ToJson(const Spans& spans) {
  if (spans.size() == 1) {
    Json json = SpanJson(spans.front());
    if (json.is_string()) return json;
    return Json::array({std::move(json)});
  }
  Json json = Json::array();
  for (const Span& span : spans) json.push_back(SpanJson(span));
  return json;
}

NewestSpans NewestLines(const Transcript& transcript) {
  constexpr std::ptrdiff_t kMost = 500;
  const auto end = transcript.lines.end();
  return {{end - std::min(std::ssize(transcript.lines), kMost), end}};
}

Json ToJson(const NewestSpans& newest) {
  Json json = Json::array();
  for (const Span& span : newest.lines) json.push_back(SpanJson(span));
  return json;
}

/// The request and the panel that comes to the front: [{"request": "rule", "rule": "x"}, "rules"].
Json ToJson(const Action& action) {
  Json json = Json::array({workbench::ToJson(action.request)});
  if (action.panel) json.push_back(std::string(InfoOf(*action.panel).word));
  return json;
}

Json ToJson(const Cell& cell) {
  if (!cell.number && !cell.bar) return ToJson(cell.spans);
  CellValue value{cell.spans, cell.number, cell.bar};
  if (value.bar) value.bar = std::round(*value.bar * 1000) / 1000;
  return debugger::JsonOf(value);
}

Json ToJson(const BodySign& sign) {
  return Json::array({sign.team, sign.kind, sign.is_foreign});
}

std::vector<CodePart> PartsOf(const Code& code) {
  std::vector<CodePart> parts;
  if (code.tokens.empty()) return parts;
  std::size_t end = 0;
  for (const debugger::Token& token : code.tokens) {
    if (token.begin > end) parts.push_back({code.text.substr(end, token.begin - end)});
    end = token.begin + token.length;
    parts.push_back({code.text.substr(token.begin, token.length), debugger::NameOf(token.kind)});
  }
  if (end < code.text.size()) parts.push_back({code.text.substr(end)});
  return parts;
}

Json ToJson(const CodePart& part) {
  if (part.kind.empty()) return part.text;
  return Json::array({part.text, std::string(part.kind)});
}

std::string_view WordOf(Role role) {
  return kRoles[static_cast<std::size_t>(role)];
}

std::string_view WordOf(CheckResult result) {
  return kCheckResults[static_cast<std::size_t>(result)];
}

Json ToJson(const Nodes& nodes) {
  Json json = Json::array();
  for (const Node& node : nodes)
    json.push_back(std::visit([](const auto& kind) { return debugger::JsonOf(kind); }, node.is));
  return json;
}

}  // namespace soarbox::workbench::document
