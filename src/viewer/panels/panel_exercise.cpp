// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/palette.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using workbench::ExerciseContents;

std::string Count(std::uint64_t count, double per_s) {
  return std::to_string(count) + Formatted(" PDUs, %.1f per second", per_s);
}

/// What was dropped and why, "12 too short, 3 another version".
std::string DroppedText(const ExerciseContents& exercise) {
  std::string text;
  for (const auto& [why, count] : exercise.dropped)
    text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + why;
  return text.empty() ? "nothing" : text;
}

std::string EntityCount(const ExerciseContents& exercise) {
  const std::size_t count = exercise.entity_count, listed = exercise.entities.size();
  return std::to_string(count) + (count == 1 ? " entity" : " entities") + " of others" +
         (listed < count ? ", the first " + std::to_string(listed) + " of them:" : "");
}

/// The exercise of other simulations that the run takes part in.
class ExercisePanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (!frame.contents.exercise) {
      if (frame.contents.moment.is_recording)
        EmptyNote("A recording takes part in no exercise.", "What came from others is in it, and moves their bodies.");
      else
        EmptyNote("This run takes part in no exercise of other simulations.",
                  "Begin it with --dis ADDRESS:PORT, or write [dis] into its scenario (docs/dis.md).");
      return;
    }
    const ExerciseContents& exercise = *frame.contents.exercise;
    Heading(frame, "Exercise " + std::to_string(exercise.exercise));
    if (exercise.is_frozen) WrappedText(theme::kWarn, "Frozen: the exercise's manager let the run stand still.");
    DrawFacts(exercise);
    Heading(frame, EntityCount(exercise));
    if (exercise.entities.empty()) return;
    const List list("entities", {{"Name", 3}, {"Id", 2}, {"Heard", 2}});
    if (!list) return;
    ForRowsInSight(exercise.entities.size(),
                   [&](int i) { DrawRow(frame, exercise.entities[static_cast<std::size_t>(i)]); });
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.exercise) return {};
    const ExerciseContents& exercise = *frame.contents.exercise;
    std::string text = "exercise " + std::to_string(exercise.exercise) + " at " + exercise.address + " as " +
                       exercise.as + "\nsent: " + Count(exercise.sent, exercise.sent_per_s) +
                       "\nreceived: " + Count(exercise.received, exercise.received_per_s) +
                       "\ndropped: " + DroppedText(exercise) + "\n" + EntityCount(exercise) + "\n";
    for (const ExerciseContents::Entity& one : exercise.entities)
      text += one.id + "  " + one.marking + "  " + one.team + "  " + one.body + "  " + one.type + "\n";
    return text;
  }

 private:
  static void DrawFacts(const ExerciseContents& exercise) {
    const FactTable facts("facts");
    facts.Row("Address", exercise.address + (exercise.is_of_this_machine ? " (this machine only)" : ""),
              exercise.is_of_this_machine ? theme::kText : theme::kWarn);
    facts.Row("We are", exercise.as + (exercise.listens_only ? ", and only listen" : "") +
                            (exercise.takes_orders ? ", and take orders" : ""));
    facts.Row("Sent", Count(exercise.sent, exercise.sent_per_s));
    if (exercise.not_sent > 0) facts.Row("Not sent", std::to_string(exercise.not_sent), theme::kWarn);
    facts.Row("Received", Count(exercise.received, exercise.received_per_s));
    facts.Row("Dropped", DroppedText(exercise), exercise.dropped.empty() ? theme::kText : theme::kWarn);
  }

  static void DrawRow(PanelFrame& frame, const ExerciseContents::Entity& one) {
    const IdScope id(one.id);
    NextRow();
    const auto body = std::ranges::find(frame.scene.agents, one.agent, &world::AgentSnapshot::name);
    const bool has_body = !one.agent.empty() && body != frame.scene.agents.end();
    const std::string name = has_body ? one.agent : one.marking.empty() ? one.id : one.marking;
    const world::Color color = TeamColor(one.team);
    if (ImGui::Selectable("##row", has_body && body->id == frame.selected,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap) &&
        has_body)
      frame.selected = body->id;
    Tooltip(one.team + ", " + one.body + ", type " + one.type +
            (has_body ? "" : "; it has no body here: it is too far away"));
    ImGui::SameLine(0, 0);
    ColoredText({color.r, color.g, color.b, 1}, "\xe2\x97\x87");
    ImGui::SameLine();
    CutText(name, has_body ? theme::kText : theme::kQuiet);
    CutCell(one.id, theme::kQuiet);
    Cell(one.silent_s >= 6 ? theme::kWarn : theme::kQuiet,
         one.silent_s == 0 ? "now" : std::to_string(one.silent_s) + " s ago");
  }
};

}  // namespace

std::unique_ptr<Panel> MakeExercisePanel() {
  return std::make_unique<ExercisePanel>();
}

}  // namespace soarbox::viewer
