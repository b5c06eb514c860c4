// SPDX-License-Identifier: BSD-2-Clause
// Prints a document as text: for tests, for the clipboard and for coding assistants.
#include <algorithm>
#include <cstdio>

#include "debugger/facts_text.h"
#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

class TextWriter {
 public:
  explicit TextWriter(double step_s) : step_s_(step_s) {}

  void Add(const Nodes& nodes, int indent) {
    for (const Node& node : nodes) {
      indent_ = indent;
      std::visit(*this, node.is);
    }
    indent_ = indent;
  }

  void operator()(const Paragraph& text) { Put(TextOf(text.spans)); }
  void operator()(const Code& code) { Put(code.text); }
  void operator()(const Line& line) { Put(Inline(line.nodes)); }
  void operator()(const Button& button) { Put(ButtonText(button)); }
  void operator()(const Form& form) { Put(FormText(form)); }
  void operator()(const Table& table) {
    if (!table.caption.empty()) Put(table.caption + ":");
    std::vector<std::vector<std::string>> rows;
    if (table.has_heads) {
      std::vector<std::string>& heads = rows.emplace_back();
      for (const Column& column : table.columns) heads.push_back(column.title);
    }
    for (const TableRow& row : table.rows) {
      std::vector<std::string>& cells = rows.emplace_back();
      for (const Cell& cell : row.cells)
        cells.push_back(std::string(cells.empty() ? static_cast<std::size_t>(row.depth) * 2 : 0, ' ') +
                        TextOf(cell.spans));
    }
    Put(debugger::Table(rows));
  }
  void operator()(const Tree& tree) {
    for (const TreeRow& row : tree.rows) AddRow(row, indent_);
  }
  void operator()(const Plot& plot) {
    Put(plot.title + ": " + plot.value + (plot.range.empty() ? "" : " (" + plot.range + ")"));
    for (const Curve& curve : plot.curves) {
      if (curve.points.empty()) continue;
      double least = curve.points.front().second, most = least;
      for (const auto& point : curve.points) {
        least = std::min(least, point.second);
        most = std::max(most, point.second);
      }
      char range[160];
      std::snprintf(range, sizeof range, "%zu points, %.4g to %.4g, last %.4g", curve.points.size(), least, most,
                    curve.points.back().second);
      ++indent_;
      Put((curve.name.empty() ? "" : curve.name + ": ") + range);
      --indent_;
    }
  }
  void operator()(const Strip& strip) {
    std::string marks;
    for (const std::size_t mark : strip.marks) marks += (marks.empty() ? "; " : ", ") + std::to_string(mark);
    Put("1 to " + std::to_string(strip.count) + marks + (marks.empty() ? "" : " " + strip.mark));
  }
  void operator()(const Checklist& list) {
    for (const Checklist::Item& item : list.items) {
      Put(item.says + ": " + TextOf(item.spans));
      ++indent_;
      Put(TextOf(item.below));
      --indent_;
    }
  }
  void operator()(const Progress& progress) { Put(progress.text); }
  void operator()(const Transcript& transcript) {
    for (const Span& line : transcript.lines) Put(line.text);
  }
  void operator()(const Actions& actions) { Put(Inline(actions.nodes)); }
  void operator()(const Section& section) {
    Put(TextOf(section.title));
    const int indent = indent_;
    Add(section.nodes, indent + 1);
    indent_ = indent;
  }
  void operator()(const Tabs& tabs) {
    const int indent = indent_;
    for (const Tabs::Page& page : tabs.pages) {
      Put("= " + page.title);
      Add(page.nodes, indent);
    }
  }
  void operator()(const Columns& columns) {
    for (const Section& part : columns.parts) (*this)(part);
  }

  std::string text;

 private:
  std::string TextOf(const Spans& spans) const {
    std::string all;
    for (const Span& span : spans) all += span.tick ? ClockText(static_cast<double>(*span.tick) * step_s_) : span.text;
    return all;
  }
  static std::string ButtonText(const Button& button) {
    return (button.is_on ? *button.is_on ? "[x " : "[  " : "[") + button.label + "]";
  }
  static std::string FormText(const Form& form) {
    std::string all;
    for (const Field& field : form.fields)
      all += (all.empty() ? "" : " ") + (field.prompt.empty() ? field.label : field.prompt) + "{" +
             (field.value.empty() ? field.placeholder : field.value) + "}";
    return form.button.empty() ? all : all + " [" + form.button + "]";
  }
  std::string Inline(const Nodes& nodes) const {
    std::string all;
    for (const Node& node : nodes) {
      if (!all.empty()) all += " ";
      if (const auto* button = std::get_if<Button>(&node.is)) all += ButtonText(*button);
      if (const auto* form = std::get_if<Form>(&node.is)) all += FormText(*form);
      if (const auto* words = std::get_if<Paragraph>(&node.is)) all += TextOf(words->spans);
    }
    return all;
  }
  void AddRow(const TreeRow& row, int indent) {
    indent_ = indent;
    Put(TextOf(row.spans));
    for (const TreeRow& below : row.below) AddRow(below, indent + 1);
    indent_ = indent;
  }
  /// Prints lines, indented.
  void Put(const std::string& lines) {
    std::size_t begin = 0;
    while (begin < lines.size()) {
      std::size_t end = lines.find('\n', begin);
      if (end == std::string::npos) end = lines.size();
      std::string line = lines.substr(begin, end - begin);
      line.erase(line.find_last_not_of(" \t") + 1);
      text += std::string(static_cast<std::size_t>(indent_) * 2, ' ') + line + "\n";
      begin = end + 1;
    }
  }

  const double step_s_;
  int indent_ = 0;
};

}  // namespace

std::string ToText(const Nodes& nodes, double step_s) {
  TextWriter writer(step_s);
  writer.Add(nodes, 0);
  return std::move(writer.text);
}

}  // namespace soarbox::workbench::document
