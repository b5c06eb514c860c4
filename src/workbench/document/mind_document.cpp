// SPDX-License-Identifier: BSD-2-Clause
// Mind: the goal stack of the selected agent, and the operators of one of its states. Minds: several minds side by
// side.
#include <algorithm>
#include <cstdio>
#include <iterator>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/glossary.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::OperatorRow;
using debugger::StackLevel;

std::string TitleOf(const OperatorRow& row) {
  return (row.selected ? "\xe2\x9c\x93 " : "") + NamedAs(row.name, row.id);
}

void AddPhases(const debugger::StackView& stack, Nodes& nodes) {
  Spans spans;
  if (!stack.phase.empty()) {
    for (const std::string& phase : debugger::Phases()) {
      const bool is_next = phase == stack.phase;
      if (!spans.empty()) spans.push_back(Quiet(" \xe2\x86\x92 "));
      spans.push_back({phase, is_next ? Role::kTag : Role::kQuiet, std::nullopt,
                       std::string(MeaningOf(phase)) + (is_next ? " It runs next." : "")});
    }
    nodes.push_back(Text(std::move(spans)));
  }
  std::string counts = "decision " + std::to_string(stack.decisions);
  if (stack.elements > 0) counts += ", " + Count(stack.elements, "element", "elements");
  if (stack.rules > 0) counts += ", " + Count(stack.rules, "rule", "rules");
  if (stack.firings > 0) counts += ", " + Count(stack.firings, "firing", "firings");
  nodes.push_back(Text(counts, Role::kQuiet));
  if (!stack.breakdown.empty())
    nodes.push_back(Text("At its end: " + stack.breakdown, Role::kBad));
  else if (stack.halted)
    nodes.push_back(Text("The agent has halted.", Role::kBad));
  if (!stack.note.empty()) nodes.push_back(Text(stack.note, Role::kQuiet));
}

Spans OperatorOf(const StackLevel& level, const std::string& goes_on) {
  if (!level.operator_id.empty())
    return {{"\xe2\x96\xb8 " + NamedAs(level.operator_name, level.operator_id), Role::kGood}};
  return {Quiet(goes_on.empty() ? "no operator" : "no operator; the body continues: " + goes_on)};
}

Table StackTable(const debugger::StackView& stack, const std::string& chosen, const std::string& goes_on,
                 bool is_pressed) {
  Table table{"stack", {{"State"}, {"Operator", false, false, true}}};
  table.has_heads = false;
  if (is_pressed) table.press = RowAction{{StateRequest{}}, "state"};
  for (const StackLevel& level : stack.levels) {
    Cell state = TextCell(level.state, Role::kObject);
    if (!level.impasse.empty()) state.spans.push_back({" " + level.impasse, Role::kWarn});
    // A command continues after the operator that gave it is deselected.
    TableRow& row =
        table.Add(level.state, {std::move(state), {OperatorOf(level, level.level == 1 ? goes_on : std::string())}});
    row.depth = std::max(0, level.level - 1);
    row.is_chosen = level.state == chosen;
    row.hint = std::string(MeaningOf(level.impasse));
  }
  return table;
}

void AddPreference(const mind::PreferenceFact& preference, std::string key, Table& table) {
  std::string what = preference.sign + " " + preference.type;
  if (!preference.referent.empty())
    what += " " + (preference.other_name.empty() ? preference.referent : preference.other_name);
  table
      .Add(std::move(key),
           {{{Span{std::move(what), Role::kPlain, {}, std::string(MeaningOf(preference.type))}}},
            {{preference.maker.rule.empty() ? Quiet("the architecture") : RuleLink(preference.maker.rule)}}})
      .depth = 1;
}

void AddRows(const OperatorRow& one, Table& table) {
  const Role role = one.selected ? Role::kGood : Role::kPlain;
  TableRow row;
  row.key = one.id;
  row.folds = true;
  row.hint = "Unfold it to see each preference and the rule that made it";
  // `about`: the attributes that distinguish the operator from others of the same name.
  const std::string about = one.about.empty() || one.verdict.empty() ? one.about : one.about + ": ";
  row.cells = {TextCell(TitleOf(one), role), TextCell(about + one.verdict, one.selected ? Role::kGood : Role::kQuiet)};
  if (table.columns.size() > 2) {
    row.cells.push_back(one.value ? NumberCell(*one.value, Rounded(*one.value), Role::kNumber) : Cell());
    row.cells.push_back(one.probability ? NumberCell(*one.probability, Rounded(*one.probability * 100, 3) + " %")
                                        : Cell());
    row.cells.back().bar = one.probability;
  }
  table.rows.push_back(std::move(row));
  const Span ask{one.selected ? "Why?" : "Why not?", Role::kTag, AskWhy(WhyRequest::About::kOperator, one.id)};
  const Span look{"in memory", Role::kTag, Action{ObjectRequest{one.id, true}, PanelId::kMemory},
                  "Look at it in working memory"};
  table.Add(one.id + "/ask", {{{ask}}, {{look}}}).depth = 1;
  for (std::size_t i = 0; i < one.preferences.size(); ++i)
    AddPreference(one.preferences[i], one.id + "/" + std::to_string(i), table);
}

void AddOperators(const debugger::OperatorsView& view, Nodes& nodes) {
  nodes.push_back(Heading("Operators of " + (view.state.empty() ? "the lowest state" : view.state),
                          std::string(MeaningOf("operator"))));
  if (!view.note.empty()) nodes.push_back(Text(view.note, Role::kQuiet));
  if (!view.sentence.empty()) nodes.push_back(Text(view.sentence, view.selected.empty() ? Role::kWarn : Role::kGood));
  if (view.rows.empty()) {
    if (view.sentence.empty() && view.note.empty())
      nodes.push_back(
          Text("No operator is proposed here. In the panel Why, you can ask why an operator is not proposed.",
               Role::kQuiet));
    return;
  }
  Table table;
  table.key = "operators";
  table.columns = {{"Operator"}, {"Standing", false, false, true}};
  if (std::ranges::any_of(view.rows, [](const OperatorRow& row) { return row.value.has_value(); })) {
    table.columns.push_back({"Value", true, false, false, std::string(MeaningOf("value"))});
    table.columns.push_back({"Chance", true, false, false, std::string(MeaningOf("chance"))});
  }
  for (const OperatorRow& row : view.rows) AddRows(row, table);
  nodes.push_back(std::move(table));
}

/// Adds the operators that were selected last, because most operators last for a tick or two.
void AddBefore(const Contents& contents, Nodes& nodes) {
  constexpr std::size_t kMost = 5, kMostLookedAt = 200;
  const debugger::TimelineTrack* track =
      contents.timeline == nullptr ? nullptr : contents.timeline->Find(contents.agent);
  if (track == nullptr || contents.agent.empty()) return;
  std::size_t shown = 0, seen = 0;
  for (auto span = track->spans.rbegin(); span != track->spans.rend() && shown < kMost && ++seen < kMostLookedAt;
       ++span) {
    if (span->is_state || span->last_tick > contents.moment.shown_tick) continue;
    if (shown++ == 0) nodes.push_back(Heading("Before", "The operators that were selected last, the newest first"));
    nodes.push_back(Text(Spans{Time(span->first_tick), {" " + NamedAs(span->text, span->id)}}));
  }
}

/// Adds what the agent's script shows of its state. Rows of the active path are highlighted.
void AddShown(const Contents& contents, Nodes& nodes) {
  if (contents.shown.rows.empty()) return;
  Table table{"shown", {{"State"}, {"Value", false, false, true}}};
  table.has_heads = false;
  for (const world::ShownRow& shown : contents.shown.rows) {
    char since[40];
    std::snprintf(since, sizeof since, "since %.2f s", static_cast<double>(shown.since_tick) * contents.moment.step_s);
    const Role role = shown.active ? Role::kGood : shown.depth == 0 ? Role::kStrong : Role::kPlain;
    TableRow& row = table.Add(std::to_string(table.rows.size()),
                              {TextCell(shown.name, role), TextCell(shown.value, Role::kNumber)});
    row.depth = shown.depth;
    row.is_chosen = shown.active;
    row.hint = since;
  }
  nodes.push_back(Heading("State", "What the agent's script shows of its state"));
  nodes.push_back(std::move(table));
}

}  // namespace

Nodes MindDocument(const Contents& contents) {
  Nodes nodes;
  AddShown(contents, nodes);
  if (!contents.has_mind && !nodes.empty()) return nodes;
  if (auto without = WithoutMind(contents)) {
    std::ranges::move(*without, std::back_inserter(nodes));
    return nodes;
  }
  NoteRecorded(contents, nodes);
  AddPhases(contents.stack, nodes);
  const auto self = std::ranges::find(contents.agents, contents.agent, &debugger::AgentRow::name);
  const auto doing = self == contents.agents.end() ? contents.activities.end() : contents.activities.find(self->id);
  nodes.push_back(Heading("Goal stack", std::string(MeaningOf("goal stack"))));
  nodes.push_back(StackTable(contents.stack, contents.operators.state,
                             doing == contents.activities.end() ? std::string() : doing->second, true));
  AddOperators(contents.operators, nodes);
  AddBefore(contents, nodes);
  return nodes;
}

Nodes MindsDocument(const Contents& contents) {
  Nodes nodes{BesideLine(contents)};
  if (contents.minds.empty()) {
    nodes.push_back(
        Empty("No mind is shown.", "Choose agents above: their goal stacks and operators appear side by side."));
    return nodes;
  }
  Columns columns;
  for (const MindColumn& mind : contents.minds) {
    Section part{mind.agent, {AgentLink(mind.agent)}, {}};
    part.nodes.push_back(Text(
        Spans{{"select", Role::kQuiet, Action{SelectRequest{mind.agent}}, "All other panels then show this agent"}}));
    if (!mind.note.empty()) {
      part.nodes.push_back(Text(mind.note, Role::kQuiet));
    } else {
      part.nodes.push_back(StackTable(mind.stack, {}, {}, false));
      if (!mind.operators.sentence.empty())
        part.nodes.push_back(
            Text(mind.operators.sentence, mind.operators.selected.empty() ? Role::kWarn : Role::kGood));
      for (const OperatorRow& row : mind.operators.rows)
        part.nodes.push_back(Text(TitleOf(row) + ": " + row.verdict, row.selected ? Role::kGood : Role::kQuiet));
      if (!mind.command.empty())
        part.nodes.push_back(Text(mind.command == "dead" ? "dead" : "gave " + mind.command, Role::kNumber));
    }
    columns.parts.push_back(std::move(part));
  }
  nodes.push_back(std::move(columns));
  return nodes;
}

}  // namespace soarbox::workbench::document
