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
    std::vector<ListColumn> columns{{"Watch", 2}};
    for (const std::string& agent : contents.beside) columns.push_back({agent.c_str(), 3});
    if (contents.beside.empty()) columns.push_back({""});
    // Each number of agents keeps its own widths.
    const List list("watches" + std::to_string(columns.size()), columns,
                    List::kUsual | ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersInnerV);
    if (!list) return;
    int number = 0;
    for (const workbench::WatchRow& row : contents.watches) DrawRow(frame, row, number++);
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
    if (WasEntered() && !what_.empty()) {
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
    const IdScope id(number);
    NextRow();
    if (ImGui::SmallButton("\xc3\x97")) frame.Ask(workbench::WatchRequest{row.what, false});
    Tooltip("No longer watch it");
    ImGui::SameLine();
    WrappedText(theme::kAccent, row.what);
    for (const workbench::WatchRow::Cell& cell : row.cells) {
      ImGui::TableNextColumn();
      const IdScope of_agent(cell.agent);
      ImGui::PushFont(frame.fonts.mono);
      const ImVec4 color = cell.is_error ? theme::kBad : cell.is_new ? theme::kWarn : theme::kText;
      if (cell.text.empty())
        ColoredText(theme::kQuiet, "nothing");
      else
        FoldedText("value", cell.text, color);
      ImGui::PopFont();
      if (cell.tick > 0) Tooltip("So since " + TimeOf(frame, cell.tick));
    }
  }

  std::string what_, fault_;
  bool wants_focus_ = false;
};

}  // namespace

std::unique_ptr<Panel> MakeWatchPanel() {
  return std::make_unique<WatchPanel>();
}

}  // namespace soarbox::viewer
