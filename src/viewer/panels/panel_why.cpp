// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/why_tree.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// Why the agent does what it does, as a tree of reasons.
class WhyPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const workbench::Contents& contents = frame.contents;
    if (contents.agent.empty()) {
      EmptyNote("No agent is selected.", "Click one: this panel then explains why it does what it does.");
      return;
    }
    if (ImGui::Button("Why this?")) frame.Ask(workbench::WhyRequest{});
    Tooltip("Why does the agent do what it does now?");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    DrawField(frame);
    Tooltip("The name of an operator or a command, then Enter: why is it not chosen?");
    ImGui::Separator();
    ImGui::PushFont(frame.fonts.bold);
    WrappedText(contents.why.question);
    ImGui::PopFont();
    if (!contents.past_note.empty()) CutText("As recorded. " + contents.past_note, theme::kQuiet);
    if (!contents.why.answer) {
      WrappedText(theme::kQuiet,
                  contents.not_available.empty() ? "There is no answer to this." : contents.not_available);
      return;
    }
    ImGui::BeginChild("tree", {0, 0}, false, ImGuiWindowFlags_NoNav);
    DrawWhyTree(frame, *contents.why.answer);
    ImGui::EndChild();
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.why.answer) return {};
    return frame.contents.why.question + "\n" + debugger::ToText(*frame.contents.why.answer, 1);
  }

 private:
  void DrawField(PanelFrame& frame) {
    SearchField("##not", "Why not ...", not_);
    const bool entered = ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter));
    if (entered && !not_.empty()) frame.Ask(workbench::WhyRequest{workbench::WhyRequest::About::kNot, not_});
  }

  std::string not_;
};

}  // namespace

std::unique_ptr<Panel> MakeWhyPanel() {
  return std::make_unique<WhyPanel>();
}

}  // namespace soarbox::viewer
