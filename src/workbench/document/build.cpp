// SPDX-License-Identifier: BSD-2-Clause
#include "workbench/document/build.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <utility>

#include "debugger/file_place.h"
#include "workbench/document/glossary.h"

namespace soarbox::workbench::document {
namespace {

using debugger::WhyKind;
using debugger::WhyNode;

constexpr int kDeepestReason = 40;

Role RoleOf(WhyKind kind) {
  switch (kind) {
    case WhyKind::kAgent:
      return Role::kStrong;
    case WhyKind::kCondition:
      return Role::kCode;
    case WhyKind::kCommand:
    case WhyKind::kImagined:
      return Role::kNumber;
    case WhyKind::kOperator:
    case WhyKind::kPercept:
      return Role::kGood;
    case WhyKind::kPreference:
    case WhyKind::kLearned:
      return Role::kWarn;
    case WhyKind::kRule:
      return Role::kName;
    case WhyKind::kElement:
      return Role::kObject;
    case WhyKind::kReason:
    case WhyKind::kRecall:
    case WhyKind::kTopic:
      break;
  }
  return Role::kPlain;
}

bool IsTimeTag(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The action and the tooltip of a reason.
std::pair<std::optional<Action>, std::string> FollowUp(const Contents& contents, const WhyNode& node) {
  using About = WhyRequest::About;
  if (node.link.empty()) return {};
  switch (node.kind) {
    case WhyKind::kRule:
      return {Action{RuleRequest{node.link}, PanelId::kRules}, "Look at this rule"};
    case WhyKind::kLearned:
      return {Action{LearnedRuleRequest{node.link}, PanelId::kLearning}, "Look at how it was learned"};
    case WhyKind::kImagined:
      return {Action{ImagineRequest{contents.imagined_state, node.link}, PanelId::kImagery}, "Show it in the picture"};
    case WhyKind::kAgent:
      return {Action{SelectRequest{node.link}}, "Select this agent"};
    case WhyKind::kOperator:
      return {AskWhy(About::kOperator, node.link), "Why this operator?"};
    case WhyKind::kCommand:
      return {AskWhy(About::kCommand, node.link), "Why this command?"};
    default:
      if (IsTimeTag(node.link)) return {AskWhy(About::kElement, node.link), "Where does this element come from?"};
  }
  return {};
}

TreeRow ReasonRow(const Contents& contents, const WhyNode& node, std::size_t number, int depth, int open_to) {
  TreeRow row;
  row.key = std::to_string(number);
  Span text{node.text, RoleOf(node.kind)};
  std::tie(text.action, text.hint) = FollowUp(contents, node);
  row.spans.push_back(std::move(text));
  if (node.time_s && contents.moment.can_go_back) {
    row.spans.push_back({" "});
    row.spans.push_back(Time(static_cast<std::uint64_t>(std::lround(*node.time_s / contents.moment.step_s))));
  }
  row.folds = !node.below.empty();
  row.is_open = depth < open_to;
  if (depth >= kDeepestReason) return row;
  std::size_t below = 0;
  for (const WhyNode& reason : node.below)
    row.below.push_back(ReasonRow(contents, reason, ++below, depth + 1, open_to));
  return row;
}

}  // namespace

Node Text(std::string text, Role role) {
  return Paragraph{Paragraph::Style::kText, {Span{std::move(text), role}}};
}

Node Text(Spans spans) {
  return Paragraph{Paragraph::Style::kText, std::move(spans)};
}

Node Named(const std::string& name, std::string value, Role role) {
  return Text(Spans{Quiet(name + ": "), {std::move(value), role}});
}

Node Heading(std::string text, std::string hint) {
  return Paragraph{Paragraph::Style::kHeading, {Span{std::move(text), Role::kStrong}}, std::move(hint)};
}

Node Empty(std::string what, std::string advice) {
  Spans spans{{std::move(what)}};
  if (!advice.empty()) spans.push_back({" " + std::move(advice), Role::kQuiet});
  return Paragraph{Paragraph::Style::kEmpty, std::move(spans)};
}

Span Quiet(std::string text) {
  return {std::move(text), Role::kQuiet};
}

Span Time(std::uint64_t tick) {
  Span span;
  span.action = Action{SeekRequest{tick}};
  span.tick = tick;
  return span;
}

Span RuleLink(const std::string& rule, Role role) {
  return {rule, role, Action{RuleRequest{rule}, PanelId::kRules}, "Look at this rule"};
}

Span AgentLink(const std::string& agent) {
  return {agent, Role::kPlain, Action{SelectRequest{agent}}, "Select this agent"};
}

Span ElementLink(const mind::ElementFact& element) {
  return {ElementText(element), Role::kObject, Action{ElementRequest{element.timetag}, PanelId::kMemory}, kElementHint};
}

Span FileLink(const Contents& contents, const std::string& file, int line, std::string text) {
  if (contents.moment.is_recording || !debugger::IsEditable(file))
    return {std::move(text), Role::kName, Action{OpenFileRequest{file, line}}, "Open it in your editor"};
  return {std::move(text), Role::kName, Action{EditRequest{file, line}, PanelId::kEdit}, "Edit it there"};
}

Action AskWhy(WhyRequest::About about, std::string what) {
  return {WhyRequest{about, std::move(what)}, PanelId::kWhy};
}

std::string ElementText(const mind::ElementFact& element) {
  return "(" + element.id + " ^" + element.attribute + " " + element.value + (element.acceptable ? " +)" : ")");
}

std::string NamedAs(const std::string& name, const std::string& id) {
  return name.empty() ? id : name + " (" + id + ")";
}

std::string Count(std::uint64_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

std::string ShortNumber(std::string_view text) {
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos || text.find_first_not_of("+-0123456789.") != std::string_view::npos)
    return std::string(text);
  while (text.back() == '0') text.remove_suffix(1);
  if (text.back() == '.') text.remove_suffix(1);
  return std::string(text);
}

std::string ClockText(double seconds) {
  const int minutes = static_cast<int>(seconds / 60);
  char text[32];
  std::snprintf(text, sizeof text, "%d:%05.2f", minutes, seconds - 60.0 * minutes);
  return text;
}

std::string Rounded(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

bool IsNumber(std::string_view text) {
  const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  return !text.empty() && (is_digit(text.front()) ||
                           (text.size() > 1 && (text.front() == '-' || text.front() == '.') && is_digit(text[1])));
}

Cell TextCell(std::string text, Role role) {
  return {{Span{std::move(text), role}}};
}

Cell NumberCell(double value, std::string text, Role role) {
  return {{Span{std::move(text), role}}, value};
}

Cell CountCell(std::uint64_t count) {
  return NumberCell(static_cast<double>(count), std::to_string(count), count > 0 ? Role::kPlain : Role::kQuiet);
}

Cell TimeCell(std::uint64_t tick) {
  return {{Time(tick)}, static_cast<double>(tick)};
}

Cell ButtonCell(std::string label, Request request, std::string hint) {
  return {{Span{std::move(label), Role::kTag, Action{std::move(request)}, std::move(hint)}}};
}

Node OrEmpty(Table table, std::string what, std::string advice) {
  if (table.rows.empty()) return Empty(std::move(what), std::move(advice));
  return table;
}

Form LineForm(std::string key, Request request, Field line, std::string button) {
  Form form{std::move(key), {std::move(request)}, {std::move(line)}, std::move(button)};
  form.fields.front().is_needed = !form.button.empty();
  return form;
}

std::optional<Nodes> WithoutMind(const Contents& contents) {
  if (contents.agent.empty() && contents.agent_count == 0)
    return Nodes{Empty("Nobody is in this world yet.",
                       "Some worlds wait for a key: click the picture, and press the key that the world names.")};
  const bool has_none = contents.agent_count > 0 && contents.soar_agents.empty();
  if (!contents.has_mind && has_none)
    return Nodes{Empty("No agent of this world has a Soar mind: scripts decide for them.",
                       "Read the scripts in the panel " + std::string(InfoOf(PanelId::kEdit).title) +
                           ", and watch what happens in Timeline and Trace.")};
  if (contents.agent.empty())
    return Nodes{Empty("No agent is selected.", "Click one in the picture or in the list of agents.")};
  if (!contents.has_mind) {
    Nodes nodes{Empty(contents.agent + " has no Soar mind: a script decides for it.", "Select an agent that has one:")};
    Line line;
    for (const std::string& agent : contents.soar_agents)
      line.nodes.push_back(Button{agent, Action{SelectRequest{agent}}});
    nodes.push_back(std::move(line));
    return nodes;
  }
  if (!contents.not_available.empty()) return Nodes{Empty(contents.not_available)};
  return std::nullopt;
}

void NoteRecorded(const Contents& contents, Nodes& nodes) {
  if (contents.past_note.empty()) return;
  nodes.push_back(Text(Spans{{"as recorded", Role::kTag, {}, "What the recording holds of this moment"},
                             Quiet(" " + contents.past_note)}));
}

Tree ReasonTree(const Contents& contents, const WhyNode& root, int open_to) {
  Tree tree;
  tree.key = "reasons";
  tree.label = "Reasons";
  tree.rows.push_back(ReasonRow(contents, root, 0, 0, open_to));
  return tree;
}

Line BesideLine(const Contents& contents) {
  Line line;
  line.nodes.push_back(Text("Side by side:", Role::kQuiet));
  const auto is_on = [&](const std::string& agent) {
    return std::ranges::find(contents.beside, agent) != contents.beside.end();
  };
  const auto add = [&](const std::string& agent) {
    Button button{is_on(agent) ? agent + " \xc3\x97" : "+ " + agent, Action{BesideRequest{agent, !is_on(agent)}}};
    button.hint = is_on(agent) ? "No longer look at it beside the others" : "Look at its mind beside the others";
    button.is_on = is_on(agent);
    line.nodes.push_back(std::move(button));
  };
  for (const std::string& agent : contents.beside) add(agent);
  for (const std::string& agent : contents.soar_agents)
    if (!is_on(agent)) add(agent);
  return line;
}

}  // namespace soarbox::workbench::document
