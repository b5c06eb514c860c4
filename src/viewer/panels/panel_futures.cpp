// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/graph.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// The old future beside the new one.
class FuturesPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (frame.contents.moment.is_recording) {
      EmptyNote("A recording has one future.",
                "soarbox resume FILE --at SECONDS continues from a moment of it, soarbox compare shows where two "
                "recordings differ first.");
      return;
    }
    if (!frame.contents.futures) {
      EmptyNote("There is only one future so far.",
                "Drag the scrubber below to an earlier moment, change a rule in the panel Edit if you like, and press "
                "Resume here. What happened before stays as ghosts in the scene, and this panel shows where the two "
                "differ first.");
      return;
    }
    const workbench::FuturesContents& futures = *frame.contents.futures;
    const record::Comparison& found = futures.comparison;
    // The answer first: who decided otherwise, and why.
    if (found.decision) {
      DrawDifference(frame, "First other decision or command", *found.decision);
      for (const std::string& percept : found.percepts) {
        ImGui::Bullet();
        WrappedText(theme::kVariable, "perceived " + percept);
      }
    } else {
      WrappedText(theme::kGood,
                  found.difference ? "So far everybody decides as before." : "So far both futures are the same.");
    }
    WrappedText(theme::kQuiet,
                "The run went back to " + TimeOf(frame, futures.branch_tick) + ". " +
                    (futures.old_is_known ? "Ghosts show where everybody was at this time before."
                                          : "Before, the run did not come this far: there are no ghosts."));
    if (found.difference && !IsSame(found.difference, found.decision)) DrawFirst(frame, *found.difference);
    DrawCourse(frame, found);
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.futures) return {};
    const record::Comparison& found = frame.contents.futures->comparison;
    const auto tell = [](const char* title, const std::optional<record::Difference>& one) {
      if (!one) return std::string();
      return std::string(title) + ": tick " + std::to_string(one->tick) + ", " + one->agent + " " + one->element +
             "\n  before: " + one->recorded + "\n  now: " + one->now + "\n";
    };
    std::string text =
        tell("first difference", found.difference) + tell("first other decision or command", found.decision);
    for (const std::string& percept : found.percepts) text += "  perceived " + percept + "\n";
    return text.empty() ? "So far both futures are the same.\n" : text;
  }

 private:
  static bool IsSame(const std::optional<record::Difference>& a, const std::optional<record::Difference>& b) {
    return a && b && a->tick == b->tick && a->agent == b->agent && a->element == b->element;
  }

  /// What differed first of all is mostly the edit that made this future: a line that unfolds.
  static void DrawFirst(PanelFrame& frame, const record::Difference& difference) {
    const std::string what = difference.agent + (difference.agent.empty() ? "" : " ") + difference.element;
    const std::string title = "What differed first: " + TimeOf(frame, difference.tick) + "  " + what;
    if (!ImGui::TreeNodeEx("first", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", title.substr(0, 120).c_str())) return;
    DrawDifference(frame, "What differed first", difference);
    ImGui::TreePop();
  }

  static void DrawDifference(PanelFrame& frame, const char* title, const record::Difference& difference) {
    Heading(frame, title);
    const IdScope id(title);
    TimeLink(frame, difference.tick);
    ImGui::SameLine();
    ColoredText(theme::kText, difference.agent + "  " + difference.element);
    const FactTable both("both");
    const auto row = [&](const char* which, const std::string& what, ImVec4 color) {
      if (both.Name(which)) FoldedText(which, what.empty() ? "nothing" : what, color);
    };
    row("before", difference.recorded, theme::kWarn);
    row("now", difference.now, theme::kAccent);
  }

  /// Which curve is which, in words of its colour.
  static void Legend(const GraphCurve& one, const GraphCurve& other) {
    ColoredText(one.color, "\xe2\x80\x94 " + one.name);
    FlowLine(ImGui::CalcTextSize(other.name.c_str()).x + ImGui::GetFontSize() * 1.5f);
    ColoredText(other.color, "\xe2\x80\x94 " + other.name);
  }

  static void DrawCourse(PanelFrame& frame, const record::Comparison& found) {
    if (found.course.size() < 2) return;
    const double step_s = frame.contents.moment.step_s;
    GraphCurve mean{"mean distance (m)", theme::kAccent, {}}, most{"greatest distance (m)", theme::kWarn, {}};
    GraphCurve before{"health before", theme::kWarn, {}}, now{"health now", theme::kAccent, {}};
    for (const record::Comparison::Moment& moment : found.course) {
      const double tick = moment.time_s / step_s;
      mean.points.emplace_back(tick, moment.mean_distance_m);
      most.points.emplace_back(tick, moment.greatest_distance_m);
      before.points.emplace_back(tick, moment.health_a);
      now.points.emplace_back(tick, moment.health_b);
    }
    const double first = mean.points.front().first, last = mean.points.back().first;
    Heading(frame, "How far apart");
    Legend(mean, most);
    const GraphCurve distances[] = {mean, most};
    DrawGraph(frame, "distance", distances, frame.Px(80), first, last);
    Heading(frame, "Health of all");
    Legend(before, now);
    const GraphCurve healths[] = {before, now};
    DrawGraph(frame, "health", healths, frame.Px(60), first, last);
  }
};

}  // namespace

std::unique_ptr<Panel> MakeFuturesPanel() {
  return std::make_unique<FuturesPanel>();
}

}  // namespace soarbox::viewer
