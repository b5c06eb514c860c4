// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "debugger/json_fields.h"
#include "workbench/document/document.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {

/// The fields of a document in JSON (debugger/json_fields.h). The page's types and docs/workbench.md are generated from
/// these lists. Names are short, because a document is sent whenever its panel changes.

using debugger::Json;

// Parts with a form of their own (document_json.cpp), which web/src/document/document.ts declares.

/// A piece of code: a text, or a text with its kind.
struct CodePart {
  std::string text;
  std::string_view kind = {};
};
/// The pieces of a code with tokens; none if it has no tokens.
std::vector<CodePart> PartsOf(const Code& code);

/// The lines of a transcript that pages get.
struct NewestSpans {
  Spans lines;
};
NewestSpans NewestLines(const Transcript& transcript);

Json ToJson(const Spans& spans);
Json ToJson(const NewestSpans& newest);
Json ToJson(const Action& action);
Json ToJson(const Cell& cell);
Json ToJson(const BodySign& sign);
Json ToJson(const CodePart& part);

inline debugger::FieldType ScriptTypeOf(const Spans*) {
  return {"Spans", "spans"};
}
inline debugger::FieldType ScriptTypeOf(const NewestSpans*) {
  return {"readonly Span[]", "list of spans"};
}
inline debugger::FieldType ScriptTypeOf(const Action*) {
  return {"Action", "action"};
}
inline debugger::FieldType ScriptTypeOf(const Cell*) {
  return {"Cell", "spans or `CellValue`"};
}
inline debugger::FieldType ScriptTypeOf(const BodySign*) {
  return {"readonly [string, string, boolean]", "team, kind, and whether another simulation moves the body"};
}
inline debugger::FieldType ScriptTypeOf(const CodePart*) {
  return {"string | readonly [string, string]", "text, or pair of a text and its kind"};
}
inline debugger::FieldType ScriptTypeOf(const Nodes*) {
  return {"readonly DocumentNode[]", "list of nodes"};
}

inline constexpr std::string_view kParagraphKinds[] = {"text", "heading", "title", "empty"};
void Fields(auto& visit, const Paragraph& text) {
  visit.Type("Paragraph", "A text. `empty` says why a panel shows nothing, and what to do.");
  visit("is", text.style, kParagraphKinds, "what the node is");
  visit("s", text.spans, "the text");
  visit.Known("hint", text.hint, "tooltip");
}

void Fields(auto& visit, const Code& code) {
  visit.Type("Code", "A text in a monospaced font.");
  visit.Is("code");
  visit.If(code.tokens.empty(), "text", code.text, "the text, if it is not Soar code");
  visit.Known("tokens", PartsOf(code), "the text, if it is");
}

void Fields(auto& visit, const Line& line) {
  visit.Type("Line", "Buttons, forms and texts in one line.");
  visit.Is("line");
  visit("nodes", line.nodes, "one after another");
}

void Fields(auto& visit, const Button& button) {
  visit.Type("Button", "A button.");
  visit.Is("button");
  visit("label", button.label, "its label");
  visit.Known("do", button.action, "what it does");
  visit.Known("hint", button.hint, "tooltip");
  visit.Known("copies", button.copies, "or the text that it copies to the clipboard");
  visit.Known("on", button.is_on, "it is a toggle, and whether it is on");
  visit.Known("off", !button.is_enabled, "it cannot be pressed");
  visit.Known("main", button.is_main, "it is the most likely next thing to do");
}

void Fields(auto& visit, const CommandLine& command) {
  visit.Type("CommandLine", "What a command line needs. Its requests get the typed text as `line`.");
  visit("complete", command.complete, "asks for completions");
  visit("keep", command.keep, "stores a text that is not sent");
  visit("completed_line", command.completed_line, "the line for which completions were last requested");
  visit("begin", command.found.begin, "where the completed word begins in that line");
  visit("words", command.found.words, "its completions");
  visit("common", command.found.common, "what all of them begin with");
}
inline constexpr std::string_view kFormFieldKinds[] = {"line", "choice", "check", "suggested", "command"};
void Fields(auto& visit, const Field& field) {
  visit.Type("Field", "A field of a form.");
  visit("kind", field.kind, kFormFieldKinds, "how it is filled in");
  visit("name", field.name, "in the request");
  visit("label", field.label, "its label");
  visit.Known("placeholder", field.placeholder, "shown while it is empty");
  visit.Known("value", field.value, "initial value");
  visit.Known("options", field.options, "values and labels; of `check`: off, then on; of `suggested`: suggestions");
  visit.Known("needed", field.is_needed, "the form is not sent while it is empty");
  visit.Known("command", field.command, "of `command`: it has a history (arrow keys) and completion (Tab)");
  visit.Known("prompt", field.prompt, "of `command`: shown before the field instead of the label");
}
void Fields(auto& visit, const Form& form) {
  visit.Type("Form", "Fields that are sent together.");
  visit.Is("form");
  visit("key", form.key, "stays the same from one document to the next");
  visit("do", form.action, "its request gets the values of the fields");
  visit("fields", form.fields, "its fields");
  visit.Known("button", form.button, "label of the button; absent: it is sent while the user types");
  visit.Known("hint", form.hint, "tooltip of the button");
  visit.Known("refusal", form.refusal, "why it cannot be sent now");
  visit.Known("clears", form.clears, "sending it clears its fields");
}

void Fields(auto& visit, const RowAction& action) {
  visit.Type("RowAction", "What a click on a row does.");
  visit("do", action.action, "what it does");
  visit("field", action.field, "the field of the request that becomes the row's key, or its argument");
  visit.Known("argument", action.argument, "its number, from 1; absent: the key");
  visit.Known("hint", action.hint, "tooltip of rows of a tree");
}

void Fields(auto& visit, const Column& column) {
  visit.Type("Column", "A column of a table.");
  visit("title", column.title, "its title");
  visit.Known("number", column.is_number, "it has numbers");
  visit.Known("wide", column.is_wide, "it is shown only if there is room");
  visit.Known("wraps", column.wraps, "its texts may wrap");
  visit.Known("hint", column.hint, "tooltip");
}
/// A cell with a number or a bar.
struct CellValue {
  Spans spans = {};
  std::optional<double> number, bar;
};
void Fields(auto& visit, const CellValue& cell) {
  visit.Type("CellValue", "A cell that is sorted by a number, or has a bar.");
  visit("s", cell.spans, "its text");
  visit.Known("n", cell.number, "it is sorted by this");
  visit.Known("bar", cell.bar, "-1 to 1: length of a bar in the background");
}
void Fields(auto& visit, const TableRow& row) {
  visit.Type("TableRow", "A row of a table.");
  visit("k", row.key, "its key");
  visit("c", row.cells, "its cells");
  visit.Known("hint", row.hint, "tooltip");
  visit.Known("a", row.arguments, "arguments for `press`");
  visit.Known("sign", row.sign, "the body that is drawn before the first cell");
  visit.Known("depth", row.depth, "a deeper row belongs to the row above it");
  visit.If(row.groups != ~std::uint32_t{0}, "g", row.groups, "bits of the groups that it belongs to; absent: all");
  visit.Known("chosen", row.is_chosen, "it is selected");
  visit.If(row.folds, "open", row.is_open, "deeper rows fold, and whether they are initially shown");
}
void Fields(auto& visit, const Table& table) {
  visit.Type("Table", "A table.");
  visit.Is("table");
  visit("key", table.key, "stays the same from one document to the next");
  visit("columns", table.columns, "its columns");
  visit("rows", table.rows, "its rows");
  visit.Known("caption", table.caption, "its caption");
  visit.Known("filter", table.filter, "label of a field that filters rows");
  visit.Known("press", table.press, "what a click on a row does");
  visit.Known("groups", table.groups, "the user chooses one of them; initially the first");
  visit.If(!table.groups.empty(), "groups_hint", table.groups_hint, "tooltip of this choice");
  visit.If(!table.none_fits.first.empty(), "none", table.none_fits, "what is shown if no row passes the filter");
  visit.Known("sorts", table.is_sortable, "the user can sort it");
  visit.Known("headless", !table.has_heads, "titles of columns are not shown");
}

void Fields(auto& visit, const TreeRow& row) {
  visit.Type("TreeRow", "A row of a tree.");
  visit("k", row.key, "its key");
  visit("s", row.spans, "its text");
  visit.Known("a", row.arguments, "arguments for `press`");
  visit.If(row.folds, "open", row.is_open, "it can be unfolded, and whether it is");
  visit.Known("below", row.below, "the rows below it");
}
void Fields(auto& visit, const Tree& tree) {
  visit.Type("Tree", "A tree.");
  visit.Is("tree");
  visit("key", tree.key, "stays the same from one document to the next");
  visit("label", tree.label, "what it shows");
  visit("rows", tree.rows, "its rows");
  visit.Known("press", tree.press, "what a click on a row does");
  visit.Known("unfold", tree.unfold, "the run stores which rows are unfolded");
  visit.Known("filter", tree.filter, "label of a field that filters rows");
}

void Fields(auto& visit, const Curve& curve) {
  visit.Type("Curve", "A curve of a plot.");
  visit("name", curve.name, "its name");
  visit("points", curve.points, "tick and value of each");
}
void Fields(auto& visit, const Plot& plot) {
  visit.Type("Plot", "Curves over the time of the run.");
  visit.Is("plot");
  visit("key", plot.key, "stays the same from one document to the next");
  visit("title", plot.title, "its title");
  visit("value", plot.value, "the newest value, or why there is none");
  visit("curves", plot.curves, "its curves");
  visit.Known("stepped", plot.is_stepped, "values hold until the next one");
  visit.Known("range", plot.range, "the minimum and the maximum");
  visit.Known("button", plot.button, "a button next to the title");
}

void Fields(auto& visit, const Strip& strip) {
  visit.Type("Strip", "Numbers from 1 to `count`, of which one is chosen.");
  visit.Is("strip");
  visit("key", strip.key, "stays the same from one document to the next");
  visit("label", strip.label, "what a number means: \"Episode\"");
  visit("count", strip.count, "the last number");
  visit("chosen", strip.chosen, "0: none");
  visit("marks", strip.marks, "numbers that are marked");
  visit("mark", strip.mark, "what these are");
  visit("press", strip.press, "what a click on a number does");
}

inline constexpr std::string_view kCheckResults[] = {"open", "passed", "failed"};
void Fields(auto& visit, const Checklist::Item& item) {
  visit.Type("ChecklistItem", "A requirement.");
  visit("k", item.key, "its key");
  visit("result", item.result, kCheckResults, "its present result");
  visit("says", item.says, "the result in words");
  visit("s", item.spans, "its text");
  visit.Known("below", item.below, "a text in a line of its own");
  visit.Known("hint", item.hint, "tooltip");
}
void Fields(auto& visit, const Checklist& list) {
  visit.Type("Checklist", "Requirements, each with its present result.");
  visit.Is("checklist");
  visit("items", list.items, "the requirements");
}

void Fields(auto& visit, const Progress& progress) {
  visit.Type("Progress", "A text with a bar.");
  visit.Is("progress");
  visit("text", progress.text, "the text");
  visit("value", progress.value, "how many are done");
  visit("of", progress.of, "of how many");
}

void Fields(auto& visit, const Transcript& transcript) {
  visit.Type("Transcript", "Lines that are appended. The newest is visible, unless the user has scrolled back.");
  visit.Is("transcript");
  visit("key", transcript.key, "stays the same from one document to the next");
  visit("label", transcript.label, "what it shows");
  visit("lines", NewestLines(transcript), "the newest 500 lines, a span for each");
  visit("count", transcript.count, "changes when a line is appended");
}

void Fields(auto& visit, const Actions& actions) {
  visit.Type("Actions", "A line at the lower edge that does not scroll; the last node of a document.");
  visit.Is("actions");
  visit("nodes", actions.nodes, "one after another");
}

void Fields(auto& visit, const Section& section) {
  visit.Type("Section", "A part with a heading.");
  visit.Is("section");
  visit("key", section.key, "stays the same from one document to the next");
  visit("title", section.title, "its heading");
  visit("nodes", section.nodes, "what it contains");
  visit.Known("open", section.unfolds, "it folds, and whether it is initially open");
  visit.Known("story", section.is_story, "it shows all about one thing");
  visit.If(section.box.has_value(), "box", WordOf(section.box.value_or(Role::kPlain)),
           "it is set off in the colour of this role");
  visit.Known("news", section.news, "if this changes, the panel comes to the front and scrolls to it");
}

void Fields(auto& visit, const Tabs::Page& page) {
  visit.Type("Page", "One of several pages.");
  visit("title", page.title, "its title");
  visit("hint", page.hint, "tooltip");
  visit("nodes", page.nodes, "what it contains");
}
void Fields(auto& visit, const Tabs& tabs) {
  visit.Type("Tabs", "Several pages, of which one is shown.");
  visit.Is("tabs");
  visit("key", tabs.key, "stays the same from one document to the next");
  visit.Known("first", tabs.first, "the page that is shown initially, from 0");
  visit.Known("reason", tabs.reason, "if it changes, that page is shown again");
  visit("pages", tabs.pages, "the pages");
}

void Fields(auto& visit, const Columns& columns) {
  visit.Type("Columns", "Sections side by side.");
  visit.Is("columns");
  visit("parts", columns.parts, "the sections");
}

}  // namespace soarbox::workbench::document
