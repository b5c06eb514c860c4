// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/panels/beside.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/terms.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {

void DrawBeside(PanelFrame& frame) {
  const auto& beside = frame.contents.beside;
  ImGui::SetNextItemWidth(frame.Px(110));
  if (ImGui::BeginCombo("##beside", "Add agent")) {
    for (const world::AgentSnapshot& agent : frame.scene.agents) {
      const bool is_there = std::find(beside.begin(), beside.end(), agent.name) != beside.end();
      if (ImGui::Selectable(((is_there ? "- " : "+ ") + agent.name).c_str(), is_there))
        frame.Ask(workbench::BesideRequest{agent.name, !is_there});
    }
    ImGui::EndCombo();
  }
  Tooltip("Look at another mind beside this one");
  for (const std::string& agent : beside) {
    const std::string label = agent + " \xc3\x97";
    FlowLine(ButtonWidth(label.c_str()), frame.Px(4));
    if (ImGui::Button(label.c_str())) frame.Ask(workbench::BesideRequest{agent, false});
    Tooltip("Click to take it away");
  }
}

namespace {

/// Several minds beside each other: what each is about, and why.
class MindsPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    DrawBeside(frame);
    const auto& minds = frame.contents.minds;
    if (minds.empty()) {
      EmptyNote("No mind is looked at.", "Add agents above: their goal stacks and operators appear side by side.");
      return;
    }
    std::vector<ListColumn> columns;
    for (const workbench::MindColumn& mind : minds) columns.push_back({mind.agent.c_str()});
    const List list("minds" + std::to_string(columns.size()), columns,
                    ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_ScrollY |
                        ImGuiTableFlags_SizingStretchSame);
    if (!list) return;
    ImGui::TableNextRow();
    for (const workbench::MindColumn& mind : minds) {
      ImGui::TableNextColumn();
      const IdScope id(mind.agent);
      DrawMind(frame, mind);
    }
  }

  std::string Text(const PanelFrame& frame) const override {
    std::string text;
    for (const workbench::MindColumn& mind : frame.contents.minds) {
      text += mind.agent + "\n";
      text += mind.note.empty() ? debugger::ToText(mind.stack) + debugger::ToText(mind.operators) : mind.note + "\n";
    }
    return text;
  }

 private:
  static void DrawMind(PanelFrame& frame, const workbench::MindColumn& mind) {
    if (Link("select", "select", theme::kQuiet)) frame.Select(mind.agent);
    Tooltip("All other panels are about this agent then");
    if (!mind.note.empty()) {
      WrappedText(theme::kQuiet, mind.note);
      return;
    }
    for (const debugger::StackLevel& level : mind.stack.levels) {
      std::string line(static_cast<std::size_t>(std::max(0, level.level - 1)) * 2, ' ');
      line += level.state;
      if (!level.impasse.empty()) line += " " + level.impasse;
      if (!level.operator_id.empty())
        line += " \xe2\x96\xb8 " + (level.operator_name.empty() ? level.operator_id : level.operator_name);
      CutText(line, level.impasse.empty() ? theme::kText : theme::kWarn);
    }
    if (!mind.operators.sentence.empty())
      WrappedText(mind.operators.selected.empty() ? theme::kWarn : theme::kGood, mind.operators.sentence);
    for (const debugger::OperatorRow& row : mind.operators.rows) {
      const std::string name = row.name.empty() ? row.id : row.name + " (" + row.id + ")";
      CutText((row.selected ? "\xe2\x9c\x93 " : "  ") + name + ": " + row.verdict,
              row.selected ? theme::kGood : theme::kQuiet);
    }
    if (!mind.command.empty()) WrappedText(theme::kNumber, mind.command == "dead" ? "dead" : "gave " + mind.command);
  }
};

}  // namespace

std::unique_ptr<Panel> MakeMindsPanel() {
  return std::make_unique<MindsPanel>();
}

}  // namespace soarbox::viewer
