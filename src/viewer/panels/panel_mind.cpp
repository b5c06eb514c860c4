// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>

#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/terms.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::OperatorRow;

/// The goal stack, and the operators of one of its states.
class MindPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    DrawShown(frame);
    if (!frame.contents.has_mind && !frame.contents.shown.rows.empty()) return;
    if (!HasMind(frame)) return;
    DrawPhases(frame);
    DrawStack(frame);
    ImGui::Separator();
    DrawOperators(frame);
    DrawLast(frame);
  }

  std::string Text(const PanelFrame& frame) const override {
    const std::string shown = debugger::ToText(frame.contents.shown);
    if (!frame.contents.has_mind || !frame.contents.not_available.empty()) return shown;
    return shown + debugger::ToText(frame.contents.stack) + debugger::ToText(frame.contents.operators);
  }

 private:
  /// What the agent's script shows of its state; the active path stands out.
  static void DrawShown(PanelFrame& frame) {
    const debugger::ShownView& shown = frame.contents.shown;
    if (shown.rows.empty()) return;
    Heading(frame, "State");
    for (const world::ShownRow& row : shown.rows) {
      ImGui::SetCursorPosX(ImGui::GetCursorPosX() + frame.Px(12) * static_cast<float>(row.depth));
      ColoredText(row.active ? theme::kGood : row.depth == 0 ? theme::kVariable : theme::kText, row.name);
      if (!row.value.empty()) {
        ImGui::SameLine();
        ColoredText(theme::kAccent, row.value);
      }
      if (shown.tick == 0) continue;
      const double since_s = shown.time_s * static_cast<double>(row.since_tick) / static_cast<double>(shown.tick);
      Tooltip(Formatted("since %.2f s", since_s));
    }
  }

  static void DrawPhases(PanelFrame& frame) {
    const debugger::StackView& stack = frame.contents.stack;
    const auto& phases = debugger::Phases();
    for (std::size_t i = 0; !stack.phase.empty() && i < phases.size(); ++i) {
      if (i > 0) {
        ImGui::SameLine(0, frame.Px(3));
        ColoredText(theme::kQuiet, "\xe2\x86\x92");
        ImGui::SameLine(0, frame.Px(3));
      }
      if (phases[i] == stack.phase)
        Tag(phases[i], theme::kAccent);
      else
        ColoredText(theme::kQuiet, phases[i]);
      Tooltip(std::string(MeaningOf(phases[i])) + (phases[i] == stack.phase ? " It runs next." : ""));
    }
    std::string counts = Formatted("decision %llu", static_cast<unsigned long long>(stack.decisions));
    if (stack.elements > 0) counts += Formatted(", %zu elements", stack.elements);
    if (stack.rules > 0) counts += Formatted(", %zu rules", stack.rules);
    ColoredText(theme::kQuiet, counts);
    Tooltip("Decisions so far; elements in working memory and rules now");
    if (!stack.breakdown.empty())
      WrappedText(theme::kBad, "At its end: " + stack.breakdown);
    else if (stack.halted)
      ColoredText(theme::kBad, "It has halted.");
    if (!stack.note.empty()) WrappedText(theme::kQuiet, stack.note);
  }

  static void DrawStack(PanelFrame& frame) {
    Heading(frame, "Goal stack");
    TermTooltip("goal stack");
    for (const debugger::StackLevel& level : frame.contents.stack.levels) {
      const IdScope id(level.state);
      const bool is_chosen = level.state == frame.contents.operators.state;
      const ImVec2 at = ImGui::GetCursorScreenPos();
      if (ImGui::Selectable("##state", is_chosen)) frame.Ask(workbench::StateRequest{level.state});
      Tooltip(level.impasse.empty() ? "Click to see the operators of this state"
                                    : std::string(MeaningOf(level.impasse)) + "\nClick to see its operators");
      ImGui::SetCursorScreenPos({at.x + frame.Px(12) * static_cast<float>(level.level - 1), at.y});
      ColoredText(theme::kVariable, level.state);
      if (!level.impasse.empty()) {
        ImGui::SameLine();
        ColoredText(theme::kWarn, level.impasse);
      }
      ImGui::SameLine();
      if (level.operator_id.empty()) {
        // A command goes on when the operator that said it has gone.
        const auto doing = frame.contents.activities.find(frame.selected);
        const bool goes_on = level.level == 1 && doing != frame.contents.activities.end();
        CutText(goes_on ? "no operator; the body continues: " + doing->second : "no operator", theme::kQuiet);
      } else {
        CutText("\xe2\x96\xb8 " + (level.operator_name.empty() ? level.operator_id
                                                               : level.operator_name + " (" + level.operator_id + ")"),
                theme::kGood);
      }
    }
  }

  /// Most operators last for a tick or two: what the last ones were, so that nobody has to be quick.
  static void DrawLast(PanelFrame& frame) {
    const debugger::TimelineTrack* track =
        frame.contents.timeline == nullptr ? nullptr : frame.contents.timeline->Find(frame.contents.agent);
    if (track == nullptr || frame.contents.agent.empty()) return;
    constexpr std::size_t kMost = 5, kLookAt = 200;
    const workbench::Moment& now = frame.contents.moment;
    std::size_t told = 0, seen = 0;
    for (auto span = track->spans.rbegin(); span != track->spans.rend() && told < kMost && ++seen < kLookAt; ++span) {
      if (span->is_state || span->last_tick > now.shown_tick) continue;
      if (told++ == 0) {
        ImGui::Separator();
        Heading(frame, "Before");
        Tooltip("The operators that were selected last, the newest first; click to go to that moment");
      }
      const IdScope id(static_cast<int>(told));
      TimeLink(frame, span->first_tick, "Click to go there: all panels then show what the mind knew", theme::kQuiet);
      ImGui::SameLine();
      CutText(span->text.empty() ? span->id : span->text + " (" + span->id + ")");
    }
  }

  void DrawOperators(PanelFrame& frame) {
    const debugger::OperatorsView& view = frame.contents.operators;
    Heading(frame, "Operators of " + view.state);
    TermTooltip("operator");
    if (!view.note.empty()) WrappedText(theme::kQuiet, view.note);
    if (!view.sentence.empty()) WrappedText(view.selected.empty() ? theme::kWarn : theme::kGood, view.sentence);
    if (view.rows.empty()) {
      if (view.sentence.empty() && view.note.empty())
        WrappedText(theme::kQuiet, "No operator is proposed here. In the panel Why, ask why not one that you miss.");
      return;
    }
    const bool has_numbers =
        std::any_of(view.rows.begin(), view.rows.end(), [](const OperatorRow& row) { return row.value.has_value(); });
    // Operators are as wide as the longest, numbers as their headers; what is said of them has the rest.
    float longest = ImGui::CalcTextSize("Operator").x;
    for (const OperatorRow& row : view.rows) longest = std::max(longest, ImGui::CalcTextSize(TitleOf(row).c_str()).x);
    const float em = ImGui::GetFontSize();
    const float wanted = em * std::ceil((longest + ImGui::GetTreeNodeToLabelSpacing()) / em + 0.5f);
    const float operators = std::min(wanted, (has_numbers ? 0.4f : 0.5f) * ImGui::GetContentRegionAvail().x);
    const std::string id =
        Formatted("operators/%.0f/%.0f", static_cast<double>(operators), static_cast<double>(frame.scale * 100));
    const ListColumn columns[] = {{"Operator", operators, ImGuiTableColumnFlags_WidthFixed},
                                  {"Standing", 0, ImGuiTableColumnFlags_WidthStretch},
                                  {"Value", ImGui::CalcTextSize("-0.000").x, ImGuiTableColumnFlags_WidthFixed},
                                  {"Chance", ImGui::CalcTextSize("Chance").x, ImGuiTableColumnFlags_WidthFixed}};
    const List list(id, std::span(columns, has_numbers ? 4 : 2),
                    ImGuiTableFlags_RowBg | ImGuiTableFlags_Resizable | ImGuiTableFlags_SizingStretchProp);
    if (!list) return;
    for (const OperatorRow& row : view.rows) DrawRow(frame, row, has_numbers);
  }

  static std::string TitleOf(const OperatorRow& row) {
    const std::string name = row.name.empty() ? row.id : row.name + " (" + row.id + ")";
    return row.selected ? "\xe2\x9c\x93 " + name : name;
  }

  static void DrawRow(PanelFrame& frame, const OperatorRow& row, bool has_numbers) {
    const IdScope id(row.id);
    NextRow();
    const std::string title = TitleOf(row);
    ImGui::PushStyleColor(ImGuiCol_Text, row.selected ? theme::kGood : theme::kText);
    const bool open = ImGui::TreeNodeEx("row", ImGuiTreeNodeFlags_SpanAvailWidth, "%s", title.c_str());
    ImGui::PopStyleColor();
    Tooltip("Unfold to see each preference and the rule that made it; right click for more");
    if (ImGui::BeginPopupContextItem("menu")) {
      if (ImGui::MenuItem(row.selected ? "Why this operator?" : "Why not this operator?"))
        frame.AskIn(workbench::PanelId::kWhy, workbench::WhyRequest{workbench::WhyRequest::About::kOperator, row.id});
      if (ImGui::MenuItem("Look at it in working memory")) ShowObject(frame, row.id);
      ImGui::EndPopup();
    }
    ImGui::TableNextColumn();
    // What tells it from others of its name stands here, where it has room.
    const std::string about = row.about.empty() || row.verdict.empty() ? row.about : row.about + ": ";
    WrappedText(row.selected ? theme::kGood : theme::kQuiet, about + row.verdict);
    if (has_numbers) {
      ImGui::TableNextColumn();
      if (row.value) ColoredText(theme::kNumber, Formatted("%.4g", *row.value));
      ImGui::TableNextColumn();
      if (row.probability) {
        // Faint, so that the number on it can be read.
        const ImVec4 bar{theme::kNumber.x, theme::kNumber.y, theme::kNumber.z, 0.4f};
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram, bar);
        ImGui::ProgressBar(static_cast<float>(*row.probability), {-1, ImGui::GetTextLineHeight()},
                           Formatted("%.0f %%", *row.probability * 100).c_str());
        ImGui::PopStyleColor();
      }
    }
    if (open) {
      for (std::size_t i = 0; i < row.preferences.size(); ++i) DrawPreference(frame, row.preferences[i], i);
      ImGui::TreePop();
    }
  }

  static void DrawPreference(PanelFrame& frame, const explain::PreferenceFact& preference, std::size_t number) {
    const IdScope id(static_cast<int>(number));
    NextRow();
    std::string what = preference.sign + " " + preference.type;
    if (!preference.referent.empty())
      what += " " + (preference.other_name.empty() ? preference.referent : preference.other_name);
    CutText(what);
    TermTooltip(preference.type);
    ImGui::TableNextColumn();
    if (preference.maker.rule.empty()) {
      ColoredText(theme::kQuiet, "the architecture");
    } else {
      RuleLink(frame, preference.maker.rule);
    }
  }
};

}  // namespace

std::unique_ptr<Panel> MakeMindPanel() {
  return std::make_unique<MindPanel>();
}

}  // namespace soarbox::viewer
