// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::BreakKind;
using debugger::Breakpoint;

const std::vector<const char*>& Titles() {
  static const std::vector<const char*> titles = [] {
    std::vector<const char*> all;
    for (const debugger::BreakKindWords& kind : debugger::kBreakKinds) all.push_back(kind.title.data());
    return all;
  }();
  return titles;
}

/// When the world is to stand still.
class BreakpointsPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const workbench::Contents& contents = frame.contents;
    for (const debugger::BreakHit& hit : contents.hits) {
      Tag("stopped", theme::kWarn);
      ImGui::SameLine();
      WrappedText(theme::kWarn, hit.why);
    }
    if (contents.moment.is_recording) {
      EmptyNote("Nothing stops a recording.", "Breakpoints are for a run: search its trace or click in its timeline.");
      return;
    }
    ColoredText(theme::kText, "Stop the world when");
    ImGui::SetNextItemWidth(frame.Px(150));
    ImGui::Combo("##kind", &kind_, Titles().data(), static_cast<int>(Titles().size()));
    const std::string only = contents.agent.empty() ? "in any agent" : "in " + contents.agent + " only";
    FlowLine(ButtonWidth(only.c_str()) + ImGui::GetFrameHeight());
    ImGui::BeginDisabled(contents.agent.empty());
    ImGui::Checkbox(only.c_str(), &only_selected_);
    ImGui::EndDisabled();
    SearchField("##what", debugger::kBreakKinds[kind_].hint.data(), what_, ButtonWidth("Add") + ImGui::GetStyle().ItemSpacing.x);
    const bool entered = WasEntered();
    ImGui::SameLine();
    if (ImGui::Button("Add") || entered) {
      frame.Ask(workbench::BreakRequest{static_cast<BreakKind>(kind_), only_selected_ ? contents.agent : std::string{}, what_});
      what_.clear();
    }
    ImGui::Separator();
    if (contents.breakpoints.empty()) {
      EmptyNote("No breakpoints.", "The world pauses at the end of the tick in which what you wait for happens.");
      return;
    }
    DrawList(frame);
  }

  std::string Text(const PanelFrame& frame) const override {
    return frame.contents.breakpoints.empty() ? std::string() : debugger::ToText(frame.contents.breakpoints);
  }

 private:
  static void DrawList(PanelFrame& frame) {
    using What = workbench::ChangeBreakRequest::What;
    const List list("breakpoints", {{"On"}, {"When", 0, ImGuiTableColumnFlags_WidthStretch}, {"Hits"}, {""}},
                    ImGuiTableFlags_RowBg | ImGuiTableFlags_ScrollY | ImGuiTableFlags_SizingFixedFit);
    if (!list) return;
    for (const Breakpoint& point : frame.contents.breakpoints) {
      const IdScope id(point.number);
      NextRow();
      bool enabled = point.enabled;
      if (ImGui::Checkbox("##on", &enabled))
        frame.Ask(workbench::ChangeBreakRequest{point.number, enabled ? What::kEnable : What::kDisable});
      ImGui::TableNextColumn();
      const std::string where = point.agent.empty() ? "any agent" : point.agent;
      WrappedText(
          point.enabled ? theme::kText : theme::kQuiet,
          where + ": " + std::string(debugger::kBreakKinds[static_cast<std::size_t>(point.kind)].title) + (point.what.empty() ? "" : ": ") + point.what);
      Cell(point.hits > 0 ? theme::kWarn : theme::kQuiet, std::to_string(point.hits));
      ImGui::TableNextColumn();
      if (ImGui::SmallButton("\xc3\x97")) frame.Ask(workbench::ChangeBreakRequest{point.number, What::kClear});
      Tooltip("Remove");
    }
  }

  int kind_ = 0;
  bool only_selected_ = false;
  std::string what_;
};

}  // namespace

std::unique_ptr<Panel> MakeBreakpointsPanel() {
  return std::make_unique<BreakpointsPanel>();
}

}  // namespace soarbox::viewer
