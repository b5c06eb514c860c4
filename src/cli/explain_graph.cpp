// SPDX-License-Identifier: BSD-2-Clause
#include "cli/explain_graph.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/graph_text.h"

namespace soarbox::cli {
namespace {

using kernel::ExplainedRule;

std::string GraphHead(const ExplainedRule& rule, std::string_view line_style) {
  return fmt::format(
      "digraph g {{\n  graph [rankdir=\"RL\" splines={} label={} labelloc=t];\n  node [fontname=Helvetica "
      "fontsize=10];\n",
      GraphQuoted(line_style), GraphQuoted(rule.name));
}

/// Escapes a text in a Graphviz table.
std::string InTable(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '&') {
      out += "&amp;";
    } else {
      out += c;
    }
  }
  return out;
}

std::string Cell(const ExplainedRule::Field& field, std::string_view prefix) {
  // Twelve colours on which text is legible.
  const std::string color =
      field.number == 0 ? std::string("white") : fmt::format("/set312/{}", (field.number - 1) % 12 + 1);
  const std::string text = InTable(field.text);
  return fmt::format("<TD BGCOLOR=\"{}\">{}{}</TD>", color, prefix, text.empty() ? " " : text);
}

std::string Row(const ExplainedRule::Condition& condition, std::size_t number) {
  if (condition.negated) return fmt::format("<TR><TD COLSPAN=\"3\">{}</TD></TR>", InTable(condition.id.text));
  std::string row = fmt::format("<TR>{}{}", Cell(condition.id, ""), Cell(condition.attribute, "^"));
  std::string value = Cell(condition.value, "");
  value.insert(3, fmt::format(" PORT=\"c{}\"", number));
  return row + value + "</TR>";
}

std::string Table(std::string_view node, std::string_view title,
                  const std::vector<ExplainedRule::Condition>& conditions,
                  const std::vector<ExplainedRule::Action>& actions) {
  std::string text = fmt::format(
      "  {} [shape=plain label=<<TABLE BORDER=\"1\" CELLBORDER=\"0\" CELLSPACING=\"0\">"
      "<TR><TD COLSPAN=\"3\" PORT=\"title\"><B>{}</B></TD></TR>",
      node, InTable(title));
  for (std::size_t n = 0; n < conditions.size(); ++n) text += Row(conditions[n], n);
  text += "<TR><TD COLSPAN=\"3\">--&gt;</TD></TR>";
  for (const ExplainedRule::Action& action : actions) {
    text += "<TR>" + Cell(action.id, "") + Cell(action.attribute, "^") + Cell(action.value, "") + "</TR>";
  }
  return text + "</TABLE>>];\n";
}

}  // namespace

std::string IdentityGraphText(const ExplainedRule& rule, std::string_view line_style) {
  std::string text = GraphHead(rule, line_style);
  std::vector<std::uint32_t> drawn;
  const auto draw = [&](std::uint32_t number) {
    if (std::ranges::find(drawn, number) != drawn.end()) return;
    drawn.push_back(number);
    const bool in_rule = std::ranges::binary_search(rule.identities, number);
    text += fmt::format("  identity{0} [label=\"{0}\" shape={1}];\n", number, in_rule ? "doublecircle" : "circle");
  };
  for (const std::uint32_t number : rule.identities) draw(number);
  std::size_t literal = 0;
  for (const ExplainedRule::Event& event : rule.events) {
    draw(event.from);
    if (event.to != 0) {
      draw(event.to);
      text += fmt::format("  identity{} -> identity{} [label=\"i {}\"];\n", event.from, event.to, event.firing);
    } else {
      text += fmt::format("  literal{} [label=\"literal\" shape=box];\n  identity{} -> literal{} [label=\"i {}\"];\n",
                          literal, event.from, literal, event.firing);
      ++literal;
    }
  }
  return text + "}\n";
}

std::string AnalysisGraphText(const ExplainedRule& rule, std::string_view line_style) {
  std::string text = GraphHead(rule, line_style);
  text += Table("learned", rule.name, rule.conditions, rule.actions);
  for (const ExplainedRule::Firing& firing : rule.firings) {
    text += Table(fmt::format("firing{}", firing.serial), fmt::format("i {} {}", firing.serial, firing.rule),
                  firing.conditions, firing.actions);
  }
  for (const ExplainedRule::Firing& firing : rule.firings) {
    for (std::size_t n = 0; n < firing.conditions.size(); ++n) {
      const std::uint32_t creator = firing.conditions[n].creator;
      if (creator == 0 || rule.FindFiring(creator) == nullptr) continue;
      text += fmt::format("  firing{}:c{} -> firing{}:title;\n", firing.serial, n, creator);
    }
    if (firing.made_result) text += fmt::format("  learned:title -> firing{}:title [style=bold];\n", firing.serial);
  }
  return text + "}\n";
}

}  // namespace soarbox::cli
