// SPDX-License-Identifier: BSD-2-Clause
// The JSON form of a document for pages. It is compact, because it is sent whenever the panel changes.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "workbench/document/panels.h"
#include "workbench/requests_json.h"

namespace soarbox::workbench::document {
namespace {

using debugger::Json;

constexpr std::string_view kRoles[] = {"plain", "strong", "quiet", "code", "good", "warn", "bad",
                                       "new",   "gone",   "num",   "obj",  "name", "tag"};
constexpr std::string_view kStyles[] = {"text", "heading", "title", "empty"};
constexpr std::string_view kResults[] = {"open", "passed", "failed"};
constexpr std::string_view kFields[] = {"line", "choice", "check", "suggested", "command"};

/// The request and the panel that comes to the front: [{"request": "rule", "rule": "x"}, "rules"].
Json ActionJson(const Action& action) {
  Json json = Json::array({workbench::ToJson(action.request)});
  if (action.panel) json.push_back(std::string(InfoOf(*action.panel).word));
  return json;
}

void Set(Json& json, const char* name, const std::string& text) {
  if (!text.empty()) json[name] = text;
}

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
  if (span.action || !span.hint.empty()) json.push_back(span.action ? ActionJson(*span.action) : Json());
  if (!span.hint.empty()) json.push_back(span.hint);
  return json;
}

/// A single plain text is a string; otherwise a list.
Json SpansJson(const Spans& spans) {
  if (spans.size() == 1) {
    Json json = SpanJson(spans.front());
    if (json.is_string()) return json;
    return Json::array({std::move(json)});
  }
  Json json = Json::array();
  for (const Span& span : spans) json.push_back(SpanJson(span));
  return json;
}

Json RowActionJson(const RowAction& action) {
  Json json{{"do", ActionJson(action.action)}, {"field", std::string(action.field)}};
  if (action.argument > 0) json["argument"] = action.argument;
  Set(json, "hint", action.hint);
  return json;
}

Json CellJson(const Cell& cell) {
  if (!cell.number && !cell.bar) return SpansJson(cell.spans);
  Json json{{"s", SpansJson(cell.spans)}};
  if (cell.number) json["n"] = *cell.number;
  if (cell.bar) json["bar"] = std::round(*cell.bar * 1000) / 1000;
  return json;
}

Json TableRowJson(const TableRow& row) {
  Json json{{"k", row.key}};
  Json& cells = json["c"] = Json::array();
  for (const Cell& cell : row.cells) cells.push_back(CellJson(cell));
  Set(json, "hint", row.hint);
  if (!row.arguments.empty()) json["a"] = row.arguments;
  if (row.sign) json["sign"] = Json::array({row.sign->team, row.sign->kind, row.sign->is_foreign});
  if (row.depth > 0) json["depth"] = row.depth;
  if (row.groups != ~std::uint32_t{0}) json["g"] = row.groups;
  if (row.is_chosen) json["chosen"] = true;
  if (row.folds) json["open"] = row.is_open;
  return json;
}

Json TreeRowJson(const TreeRow& row) {
  Json json{{"k", row.key}, {"s", SpansJson(row.spans)}};
  if (!row.arguments.empty()) json["a"] = row.arguments;
  if (row.folds) json["open"] = row.is_open;
  if (row.below.empty()) return json;
  Json& below = json["below"] = Json::array();
  for (const TreeRow& each : row.below) below.push_back(TreeRowJson(each));
  return json;
}

Json FieldJson(const Field& field) {
  Json json{{"kind", std::string(kFields[static_cast<std::size_t>(field.kind)])},
            {"name", field.name},
            {"label", field.label}};
  Set(json, "placeholder", field.placeholder);
  Set(json, "value", field.value);
  if (!field.options.empty()) json["options"] = field.options;
  if (field.is_needed) json["needed"] = true;
  if (const std::optional<CommandLine>& command = field.command)
    json["command"] = {{"complete", ActionJson(command->complete)},
                       {"keep", ActionJson(command->keep)},
                       {"completed_line", command->completed_line},
                       {"begin", command->found.begin},
                       {"words", command->found.words},
                       {"common", command->found.common}};
  return json;
}

struct Writer {
  Json operator()(const Paragraph& text) const {
    Json json{{"is", std::string(kStyles[static_cast<std::size_t>(text.style)])}, {"s", SpansJson(text.spans)}};
    Set(json, "hint", text.hint);
    return json;
  }
  Json operator()(const Code& code) const {
    Json json{{"is", "code"}, {"text", code.text}};
    if (code.tokens.empty()) return json;
    Json& tokens = json["tokens"] = Json::array();
    std::size_t end = 0;
    for (const debugger::Token& token : code.tokens) {
      if (token.begin > end) tokens.push_back(code.text.substr(end, token.begin - end));
      end = token.begin + token.length;
      tokens.push_back(
          Json::array({code.text.substr(token.begin, token.length), std::string(debugger::NameOf(token.kind))}));
    }
    if (end < code.text.size()) tokens.push_back(code.text.substr(end));
    json.erase("text");
    return json;
  }
  Json operator()(const Line& line) const { return {{"is", "line"}, {"nodes", ToJson(line.nodes)}}; }
  Json operator()(const Button& button) const {
    Json json{{"is", "button"}, {"label", button.label}};
    if (button.action) json["do"] = ActionJson(*button.action);
    Set(json, "hint", button.hint);
    Set(json, "copies", button.copies);
    if (button.is_on) json["on"] = *button.is_on;
    if (!button.is_enabled) json["off"] = true;
    if (button.is_main) json["main"] = true;
    return json;
  }
  Json operator()(const Form& form) const {
    Json json{{"is", "form"}, {"key", form.key}, {"do", ActionJson(form.action)}};
    Json& fields = json["fields"] = Json::array();
    for (const Field& field : form.fields) fields.push_back(FieldJson(field));
    Set(json, "button", form.button);
    Set(json, "hint", form.hint);
    Set(json, "refusal", form.refusal);
    if (form.clears) json["clears"] = true;
    return json;
  }
  Json operator()(const Table& table) const {
    Json json{{"is", "table"}, {"key", table.key}};
    Json& columns = json["columns"] = Json::array();
    for (const Column& column : table.columns) {
      Json& each = columns.emplace_back(Json{{"title", column.title}});
      if (column.is_number) each["number"] = true;
      if (column.is_wide) each["wide"] = true;
      if (column.wraps) each["wraps"] = true;
      Set(each, "hint", column.hint);
    }
    Json& rows = json["rows"] = Json::array();
    for (const TableRow& row : table.rows) rows.push_back(TableRowJson(row));
    Set(json, "caption", table.caption);
    Set(json, "filter", table.filter);
    if (table.press) json["press"] = RowActionJson(*table.press);
    if (!table.groups.empty()) json["groups"] = table.groups;
    if (!table.groups.empty()) json["groups_hint"] = table.groups_hint;
    if (!table.none_fits.first.empty()) json["none"] = Json::array({table.none_fits.first, table.none_fits.second});
    if (table.is_sortable) json["sorts"] = true;
    if (!table.has_heads) json["headless"] = true;
    return json;
  }
  Json operator()(const Tree& tree) const {
    Json json{{"is", "tree"}, {"key", tree.key}, {"label", tree.label}};
    Json& rows = json["rows"] = Json::array();
    for (const TreeRow& row : tree.rows) rows.push_back(TreeRowJson(row));
    if (tree.press) json["press"] = RowActionJson(*tree.press);
    if (tree.unfold) json["unfold"] = RowActionJson(*tree.unfold);
    Set(json, "filter", tree.filter);
    return json;
  }
  Json operator()(const Plot& plot) const {
    Json json{{"is", "plot"}, {"key", plot.key}, {"title", plot.title}, {"value", plot.value}};
    Json& curves = json["curves"] = Json::array();
    for (const Curve& curve : plot.curves) curves.push_back({{"name", curve.name}, {"points", curve.points}});
    if (plot.is_stepped) json["stepped"] = true;
    Set(json, "range", plot.range);
    if (plot.button) json["button"] = (*this)(*plot.button);
    return json;
  }
  Json operator()(const Strip& strip) const {
    return {{"is", "strip"},          {"key", strip.key},
            {"label", strip.label},   {"count", strip.count},
            {"chosen", strip.chosen}, {"marks", strip.marks},
            {"mark", strip.mark},     {"press", RowActionJson(strip.press)}};
  }
  Json operator()(const Checklist& list) const {
    Json json{{"is", "checklist"}};
    Json& items = json["items"] = Json::array();
    for (const Checklist::Item& item : list.items) {
      Json& each = items.emplace_back(Json{{"k", item.key},
                                           {"result", std::string(WordOf(item.result))},
                                           {"says", item.says},
                                           {"s", SpansJson(item.spans)}});
      if (!item.below.empty()) each["below"] = SpansJson(item.below);
      Set(each, "hint", item.hint);
    }
    return json;
  }
  Json operator()(const Progress& progress) const {
    return {{"is", "progress"}, {"text", progress.text}, {"value", progress.value}, {"of", progress.of}};
  }
  Json operator()(const Transcript& transcript) const {
    // A page gets the newest lines.
    constexpr std::ptrdiff_t kMost = 500;
    const auto size = std::ssize(transcript.lines);
    Json json{{"is", "transcript"}, {"key", transcript.key}, {"label", transcript.label}, {"count", transcript.count}};
    Json& lines = json["lines"] = Json::array();
    for (auto line = transcript.lines.end() - std::min(size, kMost); line != transcript.lines.end(); ++line)
      lines.push_back(SpanJson(*line));
    return json;
  }
  Json operator()(const Actions& actions) const { return {{"is", "actions"}, {"nodes", ToJson(actions.nodes)}}; }
  Json operator()(const Section& section) const {
    Json json{
        {"is", "section"}, {"key", section.key}, {"title", SpansJson(section.title)}, {"nodes", ToJson(section.nodes)}};
    if (section.unfolds) json["open"] = *section.unfolds;
    if (section.is_story) json["story"] = true;
    if (section.box) json["box"] = std::string(WordOf(*section.box));
    if (section.news) json["news"] = *section.news;
    return json;
  }
  Json operator()(const Tabs& tabs) const {
    Json json{{"is", "tabs"}, {"key", tabs.key}};
    if (tabs.first > 0) json["first"] = tabs.first;
    Set(json, "reason", tabs.reason);
    Json& pages = json["pages"] = Json::array();
    for (const Tabs::Page& page : tabs.pages)
      pages.push_back({{"title", page.title}, {"hint", page.hint}, {"nodes", ToJson(page.nodes)}});
    return json;
  }
  Json operator()(const Columns& columns) const {
    Json json{{"is", "columns"}};
    Json& parts = json["parts"] = Json::array();
    for (const Section& part : columns.parts) parts.push_back((*this)(part));
    return json;
  }
  Json operator()(const Facts& facts) const {
    Json json{{"is", "facts"}};
    Json& rows = json["rows"] = Json::array();
    for (const auto& [name, spans] : facts.rows) rows.push_back(Json::array({name, SpansJson(spans)}));
    return json;
  }
};

}  // namespace

std::string_view WordOf(Role role) {
  return kRoles[static_cast<std::size_t>(role)];
}

std::string_view WordOf(CheckResult result) {
  return kResults[static_cast<std::size_t>(result)];
}

Json ToJson(const Nodes& nodes) {
  Json json = Json::array();
  for (const Node& node : nodes) json.push_back(std::visit(Writer(), node.is));
  return json;
}

}  // namespace soarbox::workbench::document
