// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// The state of a check at the shown moment: if it is decided later, it is still open.
std::string_view StateAt(const workbench::CheckRow& check, const workbench::Moment& moment) {
  return check.tick > moment.shown_tick ? std::string_view("open") : std::string_view(check.state);
}

/// The tasks of agents and their progress, below the lesson that the world belongs to.
class MissionPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const workbench::Contents& contents = frame.contents;
    if (contents.lesson) DrawLesson(frame, *contents.lesson);
    if (contents.checks.empty()) {
      if (!contents.lesson)
        EmptyNote("This world has no mission.",
                  "Write what agents are to do as [[check]] tables into scenario.toml: docs/missions.md");
      return;
    }
    if (!contents.lesson) {
      DrawHead(frame);
      ImGui::Separator();
    }
    const Part checks("checks");
    int number = 0;
    for (const workbench::CheckRow& check : contents.checks) {
      const IdScope id(++number);
      DrawCheck(frame, check);
    }
  }

  std::string Text(const PanelFrame& frame) const override {
    std::string text;
    if (frame.contents.lesson) text = frame.contents.lesson->title + "\n" + frame.contents.lesson->task + "\n";
    for (const workbench::CheckRow& check : frame.contents.checks) {
      const std::string_view state = StateAt(check, frame.contents.moment);
      text += std::string(state) + "  " + check.name;
      if (state != "open") text += "  " + TimeText(check.time_s);
      text += "\n  " + check.expected + (check.was.empty() ? "" : "; " + check.was) + "\n";
    }
    return text;
  }

 private:
  static void DrawHead(PanelFrame& frame) {
    const workbench::Moment& moment = frame.contents.moment;
    std::size_t all = 0, good = 0, bad = 0;
    for (const workbench::CheckRow& check : frame.contents.checks) {
      if (check.is_marker) continue;
      const std::string_view state = StateAt(check, moment);
      ++all;
      good += state == "true" ? 1 : 0;
      bad += state == "false" || state == "untested" ? 1 : 0;
    }
    const std::string words = std::to_string(good) + " of " + std::to_string(all) + " checks" +
                              (bad > 0 ? ", " + std::to_string(bad) + " failed" : std::string());
    ColoredText(bad > 0 ? theme::kBad : good == all ? theme::kGood : theme::kText, words);
    if (moment.branches > 0)
      WrappedText(theme::kWarn,
                  "You went back in time and continued: these checks are from the earlier run. Begin again for a "
                  "run that is checked.");
  }

  static void DrawCheck(PanelFrame& frame, const workbench::CheckRow& check) {
    const std::string_view state = StateAt(check, frame.contents.moment);
    const bool is_open = state == "open", is_good = state == "true";
    const ImVec4 color = is_open                ? theme::kQuiet
                         : is_good              ? theme::kGood
                         : state == "undecided" ? theme::kWarn
                                                : theme::kBad;
    DrawMark(frame, color, is_open, is_good);
    ImGui::SameLine(0, frame.Px(6));
    const bool is_known = check.state != "open";  // It may have been decided after the shown moment.
    if (!is_known) {
      WrappedText(theme::kText, check.name);
    } else {
      ImGui::BeginGroup();
      WrappedText(is_open ? theme::kQuiet : theme::kText, check.name);
      ColoredText(theme::kAccent, TimeText(check.time_s));
      ImGui::EndGroup();
      if (ClickedLikeALink()) {
        frame.Ask(workbench::SeekRequest{check.tick});
        frame.Select(check.agent);
      }
      Tooltip("Click to see this moment");
    }
    ImGui::Indent(frame.Px(22));
    if (check.is_marker) {
      WrappedText(theme::kQuiet, "a moment that others refer to");
    } else if (is_open || !is_good) {
      WrappedText(theme::kQuiet, check.expected);
    }
    if (!is_open && !is_good && !check.was.empty()) WrappedText(color, check.was);
    ImGui::Unindent(frame.Px(22));
    ImGui::Spacing();
  }

  /// An empty box, a check mark or a cross: shapes, so that the meaning does not depend on colours.
  static void DrawMark(const PanelFrame& frame, ImVec4 color, bool is_open, bool is_good) {
    const float size = ImGui::GetTextLineHeight(), inset = size * 0.15f;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImU32 ink = ImGui::GetColorU32(color);
    const float line = std::max(1.0f, frame.Px(1.6f));
    const ImVec2 low{at.x + inset, at.y + inset}, high{at.x + size - inset, at.y + size - inset};
    if (is_open) {
      list.AddRect(low, high, ink, frame.Px(2));
    } else if (is_good) {
      const ImVec2 foot{at.x + size * 0.42f, high.y};
      list.AddLine({low.x, at.y + size * 0.55f}, foot, ink, line);
      list.AddLine(foot, {high.x, low.y}, ink, line);
    } else {
      list.AddLine(low, high, ink, line);
      list.AddLine({low.x, high.y}, {high.x, low.y}, ink, line);
    }
    ImGui::Dummy({size, size});
  }

  /// "New in the window: Memory (Alt+E), Edit (Alt+D)."
  static std::string NewPanels(const workbench::LessonContents& lesson) {
    std::string names;
    for (const std::string& word : lesson.new_panels) {
      const std::optional<workbench::PanelId> panel = workbench::FindPanel(word);
      if (!panel) continue;
      const workbench::PanelInfo& info = workbench::InfoOf(*panel);
      names += (names.empty() ? "" : ", ") + std::string(info.title) + " (Alt+" + std::string(1, info.key) + ")";
    }
    return names.empty() ? names : "New in the window: " + names + ".";
  }

  static void DrawLesson(PanelFrame& frame, const workbench::LessonContents& lesson) {
    WrappedText(theme::kAccent, lesson.title);
    WrappedText(lesson.task);
    if (const std::string panels = NewPanels(lesson); !panels.empty()) WrappedText(theme::kQuiet, panels);
    FoldedText("idea", lesson.idea, theme::kQuiet);
    using What = workbench::LessonRequest::What;
    const std::string hint = "Hint " + std::to_string(std::min(lesson.hints.size() + 1, lesson.hint_count)) + " of " +
                             std::to_string(lesson.hint_count);
    if (ButtonIf(lesson.hints.size() < lesson.hint_count, hint.c_str(),
                 "A nudge first, then the idea, then the outline of the rule"))
      frame.Ask(workbench::LessonRequest{What::kHint});
    FlowLine(ButtonWidth("Grade"));
    if (ButtonIf(!lesson.is_graded, "Grade",
                 "Runs your saved rules with ten seeds and says whether the lesson is done"))
      frame.Ask(workbench::LessonRequest{What::kGrade});
    if (lesson.is_graded) {
      FlowLine(ButtonWidth("Cancel"));
      if (ImGui::Button("Cancel")) frame.Ask(workbench::LessonRequest{What::kCancel});
    }
    if (!lesson.next.empty()) {
      FlowLine(ButtonWidth("Next lesson"));
      if (ImGui::Button("Next lesson")) frame.Ask(workbench::LessonRequest{What::kOpen, lesson.next});
      Tooltip("Every lesson is open, whether this one is done or not");
    }
    // Above the parts that may be long.
    if (!frame.contents.checks.empty()) DrawHead(frame);
    int number = 0;
    for (const std::string& text : lesson.hints) WrappedText(theme::kWarn, std::to_string(++number) + ". " + text);
    if (lesson.is_graded) ColoredText(theme::kQuiet, "Ten seeds are run ...");
    for (const std::string& line : lesson.grade) {
      const bool is_bad = line.starts_with("  no ");
      WrappedText(is_bad ? theme::kBad : theme::kText, line.substr(std::min(line.find_first_not_of(' '), line.size())));
    }
    if (lesson.is_passed) ColoredText(theme::kGood, "This lesson is done.");
    ImGui::Separator();
  }
};

}  // namespace

std::unique_ptr<Panel> MakeMissionPanel() {
  return std::make_unique<MissionPanel>();
}

}  // namespace soarbox::viewer
