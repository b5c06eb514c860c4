// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <utility>

#include "debugger/watch.h"
#include "viewer/panels/beside.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// What somebody wants to see of minds again and again: a row for each, a column for each agent.
class WatchPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    DrawField(frame);
    DrawBeside(frame);
    const workbench::Contents& contents = frame.contents;
    if (contents.watches.empty()) {
      EmptyNote("Nothing is watched yet.",
                "Type a path above (io.input-link.self.health, <s>.operator.name) or a command that prints (print s1 "
                "-d 2, preferences, matches RULE). It is looked at again at each decision.");
      return;
    }
    const int columns = 1 + static_cast<int>(std::max<std::size_t>(1, contents.beside.size()));
    constexpr ImGuiTableFlags kFlags = ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_Resizable |
                                       ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchProp;
    // Each number of agents keeps its own widths.
    if (!ImGui::BeginTable(("watches" + std::to_string(columns)).c_str(), columns, kFlags)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Watch", 0, 2);
    for (const std::string& agent : contents.beside) ImGui::TableSetupColumn(agent.c_str(), 0, 3);
    ImGui::TableHeadersRow();
    int number = 0;
    for (const workbench::WatchRow& row : contents.watches) DrawRow(frame, row, number++);
    ImGui::EndTable();
  }

  std::string Text(const PanelFrame& frame) const override {
    std::string text;
    for (const workbench::WatchRow& row : frame.contents.watches) {
      for (const workbench::WatchRow::Cell& cell : row.cells)
        text += cell.agent + "  " + row.what + ": " + cell.text + "\n";
    }
    return text;
  }

 private:
  void DrawField(PanelFrame& frame) {
    if (std::exchange(wants_focus_, false)) FocusNextField();
    const bool changed = SearchField("##watch", "Watch: a path, or print s1 -d 2", what_);
    Tooltip(
        "Enter adds it. A path is followed from the top state: io.input-link.self.health; <s> is the lowest state, "
        "<o> its operator");
    if (changed) fault_.clear();
    if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter)) && !what_.empty()) {
      fault_ = debugger::WatchFault(what_);
      if (fault_.empty()) {
        frame.Ask(workbench::WatchRequest{what_, true});
        what_.clear();
      }
      wants_focus_ = true;
    }
    if (!fault_.empty()) WrappedText(theme::kBad, fault_);
  }

  static void DrawRow(PanelFrame& frame, const workbench::WatchRow& row, int number) {
    ImGui::PushID(number);
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    if (ImGui::SmallButton("\xc3\x97")) frame.Ask(workbench::WatchRequest{row.what, false});
    Tooltip("No longer watch it");
    ImGui::SameLine();
    WrappedText(theme::kAccent, row.what);
    for (const workbench::WatchRow::Cell& cell : row.cells) {
      ImGui::TableNextColumn();
      ImGui::PushID(cell.agent.c_str());
      ImGui::PushFont(frame.fonts.mono);
      const ImVec4 color = cell.is_error ? theme::kBad : cell.is_new ? theme::kWarn : theme::kText;
      if (cell.text.empty())
        ColoredText(theme::kQuiet, "nothing");
      else
        FoldedText("value", cell.text, color);
      ImGui::PopFont();
      if (cell.tick > 0) Tooltip("So since " + TimeText(static_cast<double>(cell.tick) * frame.contents.moment.step_s));
      ImGui::PopID();
    }
    ImGui::PopID();
  }

  std::string what_, fault_;
  bool wants_focus_ = false;
};

}  // namespace

std::unique_ptr<Panel> MakeWatchPanel() {
  return std::make_unique<WatchPanel>();
}

}  // namespace soarbox::viewer
