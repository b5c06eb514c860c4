// SPDX-License-Identifier: BSD-2-Clause
// Imagery: the scenes that the agent imagines, state by state: its commands, the answers, and the nodes.
#include <cstdio>
#include <utility>

#include "workbench/document/build.h"
#include "workbench/document/panels.h"

namespace soarbox::workbench::document {
namespace {

using debugger::SceneExtractRow;
using debugger::SceneNodeRow;
using debugger::SceneValueRow;
using debugger::SceneView;

/// The subject of an answer: its nodes, or the input of the filter.
std::string AboutOf(const SceneValueRow& value) {
  std::string text;
  for (const std::string& node : value.nodes) text += (text.empty() ? "" : ", ") + node;
  return value.nodes.empty() ? value.given : text;
}

/// Which parts are drawn over the world.
Line DrawnLine(const Contents& contents) {
  Line line{{Text("Draw", Role::kQuiet)}};
  const auto add = [&](const std::string& state, std::string label, std::string hint) {
    Button button{std::move(label), Action{ImagineRequest{state, contents.imagined_record}}, std::move(hint)};
    button.is_on = contents.imagined_state == state;
    line.nodes.push_back(std::move(button));
  };
  add({}, "made up", "Draw what the agent made up in any state: what does not come from the world");
  for (const SceneView& scene : contents.imagery.scenes)
    add(scene.state, "all of " + scene.state, "Draw the whole scene of this state over the world");
  return line;
}

void AddQuestion(const Contents& contents, const SceneExtractRow& question, Nodes& nodes) {
  Spans asked{{question.filter.empty() ? question.command : question.filter, Role::kNumber},
              Quiet(" " + question.id + (question.rule.empty() ? "" : ", asked by "))};
  if (!question.rule.empty()) asked.push_back(RuleLink(question.rule));
  nodes.push_back(Text(std::move(asked)));
  if (!question.problem.empty()) nodes.push_back(Text(question.problem + ": " + question.hint, Role::kBad));
  Tree answers{"answers " + question.id, "Answers", {}};
  for (const SceneValueRow& value : question.values) {
    const bool is_shown = !value.record.empty() && contents.imagined_record == value.record;
    TreeRow row;
    row.key = value.record.empty() ? value.text : value.record;
    Span text{ShortNumber(value.text), Role::kStrong};
    if (!value.record.empty()) {
      text.action = Action{ImagineRequest{contents.imagined_state, is_shown ? std::string() : value.record}};
      text.hint = value.lines.empty() ? "What it was made from" : "Show it in the picture, and what it was made from";
    }
    row.spans = {std::move(text), Quiet(" " + AboutOf(value))};
    row.folds = true;
    row.is_open = is_shown;
    row.below = ReasonTree(contents, value.why).rows;
    answers.rows.push_back(std::move(row));
  }
  if (!answers.rows.empty()) nodes.push_back(std::move(answers));
  if (!question.filter.empty() && question.count == 0) nodes.push_back(Text("no answer", Role::kQuiet));
  if (question.count > question.values.size())
    nodes.push_back(Text("and " + std::to_string(question.count - question.values.size()) + " more", Role::kQuiet));
}

Table NodesOf(const SceneView& scene) {
  Table table{"nodes " + scene.state, {{"Node"}, {"At"}, {"Tags"}}};
  for (const SceneNodeRow& node : scene.nodes) {
    char at[96] = "";
    if (node.depth > 0) std::snprintf(at, sizeof at, "%.2f, %.2f, %.2f", node.at[0], node.at[1], node.at[2]);
    std::string tags = node.shape == "hull" || node.depth == 0 ? "" : node.shape;
    for (const auto& [name, value] : node.tags) tags += (tags.empty() ? "^" : " ^") + name + " " + value;
    const Role role = node.tags.contains("solid") ? Role::kPlain : Role::kObject;
    table.Add(node.name, {TextCell(node.name, role), TextCell(at, Role::kQuiet), TextCell(tags, Role::kQuiet)}).depth =
        static_cast<int>(node.depth);
  }
  return table;
}

}  // namespace

Nodes ImageryDocument(const Contents& contents) {
  const debugger::ImageryView& view = contents.imagery;
  if (view.scenes.empty()) return {Empty(view.note.empty() ? "It imagines nothing." : view.note)};
  Nodes nodes{DrawnLine(contents)};
  for (const SceneView& scene : view.scenes) {
    nodes.push_back(Heading(scene.state));
    if (scene.extracts.empty()) nodes.push_back(Text("No rule asks anything of this scene.", Role::kQuiet));
    for (const SceneExtractRow& question : scene.extracts) AddQuestion(contents, question, nodes);
    nodes.push_back(Section{"nodes " + scene.state,
                            {{Count(scene.nodes.size(), "node", "nodes")}},
                            {NodesOf(scene)},
                            view.scenes.size() == 1});
  }
  return nodes;
}

}  // namespace soarbox::workbench::document
