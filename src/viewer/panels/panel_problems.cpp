// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "debugger/file_place.h"
#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

const char* Word(Severity severity) {
  return severity == Severity::kError ? "error" : severity == Severity::kWarning ? "warning" : "note";
}

std::string Place(const Diagnostic& what) {
  if (what.file.empty()) return {};
  std::string place = what.file;
  for (const int number : {what.line, what.column})
    if (number > 0) place.append(1, ':').append(std::to_string(number));
  return place;
}

class ProblemsPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const auto& problems = frame.contents.problems;
    if (problems.empty()) {
      EmptyNote("No problems.", "Errors and warnings of rules, scripts and commands appear here in full.");
      return;
    }
    const world::AgentSnapshot* agent = frame.Selected();
    if (agent != nullptr) {
      ImGui::Checkbox("selected agent", &only_selected_);
      Tooltip("Only the problems of the selected agent");
      FlowLine(ButtonWidth("Clear"));
    }
    if (ImGui::SmallButton("Clear")) frame.Ask(workbench::ClearProblemsRequest{});
    const Part list("list");
    int number = 0;
    for (const workbench::ProblemRow& problem : problems) {  // The cause first.
      ++number;
      if (only_selected_ && agent != nullptr && problem.agent != agent->name) continue;
      const IdScope id(number);
      DrawProblem(frame, problem);
    }
  }

  std::string Text(const PanelFrame& frame) const override {
    std::string text;
    for (const workbench::ProblemRow& problem : frame.contents.problems)
      text += TimeText(problem.time_s) + (problem.agent.empty() ? "" : "  " + problem.agent) + "\n" +
              Format(problem.diagnostic);
    return text;
  }

 private:
  static void DrawProblem(PanelFrame& frame, const workbench::ProblemRow& problem) {
    const Diagnostic& what = problem.diagnostic;
    Tag(Word(what.severity), theme::ColorOf(what.severity));
    ImGui::SameLine();
    ColoredText(theme::kQuiet, TimeText(problem.time_s) + (problem.agent.empty() ? "" : "  " + problem.agent));
    if (ImGui::IsItemClicked()) frame.Select(problem.agent);
    WrappedText(what.message);
    if (!what.excerpt.empty()) DrawExcerpt(frame, what);
    if (!what.hint.empty()) WrappedText(theme::kGood, what.hint);
    if (what.more > 0) WrappedText(theme::kQuiet, "the same in " + std::to_string(what.more) + " further places");
    if (const std::string place = Place(what); !place.empty()) {
      WrappedText(theme::kAccent, place);
      if (ClickedLikeALink()) GoToFile(frame, what.file, what.line);
      Tooltip("Click to go there");
      if (!frame.contents.moment.is_recording && debugger::IsEditable(what.file)) {
        if (ImGui::SmallButton("Edit")) GoToFile(frame, what.file, what.line);
        Tooltip("Opens it in the panel Edit, at this line");
        ImGui::SameLine();
      }
      if (ImGui::SmallButton("Open in editor")) frame.Ask(workbench::OpenFileRequest{what.file, what.line});
      Tooltip("Opens the file with $VISUAL, $EDITOR or your desktop's editor");
    }
    ImGui::Separator();
  }

  static void DrawExcerpt(PanelFrame& frame, const Diagnostic& what) {
    const FontScope mono(frame.fonts.mono);
    ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kField);
    const float line = ImGui::GetTextLineHeight();
    ImGui::BeginChild("excerpt", {0, line * 2 + frame.Px(18)}, false, ImGuiWindowFlags_HorizontalScrollbar);
    ImGui::SetCursorPos({frame.Px(5), frame.Px(3)});
    ColoredText(theme::kText, what.excerpt);
    if (what.column > 0) {
      ImGui::SetCursorPosX(frame.Px(5));
      const auto before = static_cast<std::size_t>(what.column - 1);
      ColoredText(theme::kBad, std::string(before, ' ') +
                                   std::string(static_cast<std::size_t>(std::max(1, what.excerpt_length)), '^'));
    }
    ImGui::EndChild();
    ImGui::PopStyleColor();
  }

  bool only_selected_ = false;
};

}  // namespace

std::unique_ptr<Panel> MakeProblemsPanel() {
  return std::make_unique<ProblemsPanel>();
}

}  // namespace soarbox::viewer
