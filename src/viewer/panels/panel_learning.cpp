// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "viewer/panels/graph.h"
#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/why_tree.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::LearnedRuleRow;
using debugger::LearningLog;

constexpr std::size_t kMostCurves = 6;  ///< As many as colours.

/// Where a list and its curves stand side by side, the size of the list; else above each other.
ImVec2 SizeOfList(const PanelFrame& frame, float share, bool& is_wide) {
  const ImVec2 room = ImGui::GetContentRegionAvail();
  is_wide = room.x > frame.Px(480) && room.x > 1.6f * room.y;
  return is_wide ? ImVec2{room.x * share, 0} : ImVec2{0, room.y * 0.55f};
}

/// What the selected agent learns: rules, each with its reasons, numbers by reward, and reward per episode.
class LearningPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (!HasMind(frame)) return;
    const debugger::LearningView& view = frame.contents.learning;
    // Until somebody chooses, it shows what there is.
    if (!has_chosen_) page_ = view.rules.empty() && view.learners > 0 ? kValues : kRules;
    DrawLearningBar(frame, view);
    const Part page("page");
    if (page_ == kRules) {
      DrawRules(frame, view);
    } else if (page_ == kValues) {
      DrawValues(frame, view);
    } else {
      DrawEpisodes(frame);
    }
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.has_mind) return {};
    std::string text = debugger::ToText(frame.contents.learning);
    if (const LearningLog* const log = frame.contents.learning_log) text += debugger::ToText(log->episodes());
    if (!frame.contents.learned_rule.name.empty()) text += "\n" + debugger::ToText(frame.contents.learned_rule);
    return text;
  }

 private:
  enum Page : int { kRules, kValues, kEpisodes };

  /// So many of the episodes are over at the moment that is shown.
  static std::size_t EpisodesSoFar(const PanelFrame& frame) {
    const LearningLog* const log = frame.contents.learning_log;
    if (log == nullptr) return 0;
    const std::uint64_t now = frame.contents.moment.shown_tick;
    return static_cast<std::size_t>(std::ranges::count_if(
        log->episodes(), [&](const debugger::RewardEpisode& episode) { return episode.last_tick <= now; }));
  }

  void DrawLearningBar(PanelFrame& frame, const debugger::LearningView& view) {
    has_chosen_ |= PageButtons(
        page_,
        {{"Rules " + std::to_string(view.rules.size()), "Rules that were learned in substates, the newest first"},
         {"Values " + std::to_string(view.learners), "Numbers that reward moves, the highest first"},
         {"Episodes " + std::to_string(EpisodesSoFar(frame)), "The reward of each episode"}});
    if (page_ == kEpisodes) return;
    FlowLine(frame.Px(90));
    SearchField("##filter", "Filter by text", filter_);
  }

  // Rules -------------------------------------------------------------------------------------------------------------

  void DrawRules(PanelFrame& frame, const debugger::LearningView& view) {
    const bool is_chosen = !frame.contents.learned_rule.name.empty();
    const bool is_wide = ImGui::GetContentRegionAvail().x > frame.Px(640);
    if (is_chosen && !is_wide) {
      DrawRule(frame);
      return;
    }
    const auto rows = RowsThat(view.rules, [&](const LearnedRuleRow& row) {
      return HasPart(row.name + " " + row.purpose + " " + row.source, filter_);
    });
    if (rows.empty()) {
      const bool is_untold = view.rules.empty() && view.learners == 0 && !view.note.empty();
      if (is_untold) WrappedText(theme::kQuiet, view.note);
      if (is_untold && !frame.contents.not_recorded.empty()) return;
      if (!view.rules.empty()) {
        EmptyNote("No learned rule has this text.");
      } else {
        EmptyNote("No rule has been learned yet.",
                  "chunk always lets the agent learn from what it works out in substates.");
      }
      return;
    }
    {
      const Part list("list", {is_chosen ? ImGui::GetContentRegionAvail().x * 0.5f : 0, 0});
      DrawRuleTable(frame, rows);
    }
    if (!is_chosen) return;
    ImGui::SameLine();
    const Part rule("rule");
    DrawRule(frame);
  }

  static void DrawRuleTable(PanelFrame& frame, const std::vector<const LearnedRuleRow*>& rows) {
    const bool has_sources = ImGui::GetContentRegionAvail().x > frame.Px(620);
    const ListColumn columns[] = {
        {"Learned", 1.3f}, {"Fired", 0.8f}, {"Rule", 4}, {"What it does", 3.5f}, {"Learned in", 4.5f}};
    const List list("learned", std::span(columns, has_sources ? 5 : 4));
    if (!list) return;
    ForRowsInSight(rows.size(), [&](int i) { DrawRuleRow(frame, *rows[static_cast<std::size_t>(i)], i, has_sources); });
  }

  static void DrawRuleRow(PanelFrame& frame, const LearnedRuleRow& row, int number, bool has_sources) {
    const IdScope id(number);
    NextRow();
    if (row.name == frame.contents.learned_rule.name)
      ImGui::TableSetBgColor(ImGuiTableBgTarget_RowBg1, theme::Packed(theme::kAccent, 0.2f));
    if (row.tick) {
      TimeLink(frame, *row.tick);
    } else {
      ColoredText(theme::kQuiet, "-");
      Tooltip("It was learned before anybody watched, or loaded");
    }
    Cell(row.firings > 0 ? theme::kGood : theme::kQuiet, std::to_string(row.firings));
    ImGui::TableNextColumn();
    if (CutLink(row.name, row.is_gone ? theme::kQuiet : theme::kAccent))
      frame.Ask(workbench::LearnedRuleRequest{row.name});
    Tooltip(row.name + (row.is_gone ? "\nExcised since. " : "\n") + "Click to see why it is as it is");
    CutCell(row.purpose.empty() ? "not known" : row.purpose, row.purpose.empty() ? theme::kQuiet : theme::kText);
    Tooltip(row.purpose);
    if (!has_sources) return;
    CutCell(row.source, theme::kQuiet);
    Tooltip(row.source);
  }

  /// Why the chosen rule is as it is, and where it fired since.
  static void DrawRule(PanelFrame& frame) {
    const debugger::LearnedRuleView& rule = frame.contents.learned_rule;
    if (ImGui::SmallButton("Close")) frame.Ask(workbench::LearnedRuleRequest{});
    Tooltip("Back to all learned rules");
    ImGui::SameLine();
    RuleLink(frame, rule.name);
    if (!rule.fired_note.empty()) {
      WrappedText(theme::kQuiet, "Fired since: " + rule.fired_note + ".");
    } else {
      ColoredText(theme::kQuiet, "Fired since:");
      // As many of the last times as one line holds: the reasons below need the room.
      const float space = ImGui::GetStyle().ItemSpacing.x, end = ImGui::GetContentRegionAvail().x;
      const float rest = ImGui::CalcTextSize("and 100000 times before").x;
      float used = ImGui::CalcTextSize("Fired since:").x + space;
      std::size_t shown = 0;
      for (; shown < rule.fired.size(); ++shown) {
        const std::uint64_t tick = rule.fired[rule.fired.size() - 1 - shown];
        used += ImGui::CalcTextSize(TimeOf(frame, tick).c_str()).x + space;
        if (shown > 0 && used + (shown + 1 < rule.fired.size() ? rest : 0) > end) break;
        ImGui::SameLine();
        const IdScope id(static_cast<int>(shown));
        TimeLink(frame, tick);
      }
      if (shown < rule.fired.size()) {
        const std::string more = "and " + std::to_string(rule.fired.size() - shown) + " times before";
        ImGui::SameLine();
        ColoredText(theme::kQuiet, more);
      }
    }
    ImGui::Separator();
    const Part tree("tree");
    // Its name is above already.
    debugger::WhyNode why = rule.why;
    if (const std::string name = rule.name + ": "; why.text.starts_with(name)) why.text.erase(0, name.size());
    DrawWhyTree(frame, why, 2);
  }

  // Values ------------------------------------------------------------------------------------------------------------

  void DrawValues(PanelFrame& frame, const debugger::LearningView& view) {
    if (!view.note.empty()) WrappedText(theme::kQuiet, view.note);
    if (view.learners == 0) {
      if (view.note.empty())
        EmptyNote("No rule learns by reward.",
                  "rl --set learning on, and a rule whose only action is a numeric preference.");
      return;
    }
    auto rows =
        RowsThat(view.numbers, [&](const explain::NumberFact& number) { return HasPart(number.rule, filter_); });
    if (rows.empty()) {
      EmptyNote("No rule with a number has this text.");
      return;
    }
    const std::vector<std::string> curves = Curves(rows);
    // Those whose curves are drawn come first: their colours say which curve is whose.
    std::ranges::stable_partition(
        rows, [&](const explain::NumberFact* row) { return std::ranges::find(curves, row->rule) != curves.end(); });
    bool is_wide = false;
    {
      const Part numbers("numbers", SizeOfList(frame, 0.5f, is_wide));
      DrawValueTable(frame, rows, curves);
    }
    if (is_wide) ImGui::SameLine();
    const Part part("curves");
    DrawCurves(frame, curves);
  }

  /// Those that the user chose, or the ones that moved most often.
  std::vector<std::string> Curves(const std::vector<const explain::NumberFact*>& rows) const {
    if (!curves_.empty()) return curves_;
    std::vector<const explain::NumberFact*> most;
    for (const explain::NumberFact* number : rows) {
      if (number->updates > 0) most.push_back(number);
    }
    const auto moved_more = [](const explain::NumberFact* a, const explain::NumberFact* b) {
      return a->updates > b->updates;
    };
    std::stable_sort(most.begin(), most.end(), moved_more);
    std::vector<std::string> names;
    for (std::size_t n = 0; n < std::min(most.size(), kMostCurves); ++n) names.push_back(most[n]->rule);
    return names;
  }

  void DrawValueTable(PanelFrame& frame, const std::vector<const explain::NumberFact*>& rows,
                      const std::vector<std::string>& curves) {
    const List list(
        "values",
        {{"Value", 2}, {"Updates", ImGui::CalcTextSize("Updates").x, ImGuiTableColumnFlags_WidthFixed}, {"Rule", 5}});
    if (!list) return;
    double most = 1e-9;
    for (const explain::NumberFact* number : rows) most = std::max(most, std::abs(number->value));
    ForRowsInSight(rows.size(),
                   [&](int i) { DrawValueRow(frame, *rows[static_cast<std::size_t>(i)], i, most, curves); });
  }

  void DrawValueRow(PanelFrame& frame, const explain::NumberFact& number, int row, double most,
                    const std::vector<std::string>& curves) {
    const IdScope id(row);
    NextRow();
    BarText(frame, number.value, most);
    Cell(number.updates > 0 ? theme::kText : theme::kQuiet, std::to_string(number.updates));
    ImGui::TableNextColumn();
    const auto curve = std::ranges::find(curves, number.rule);
    const bool is_drawn = curve != curves.end();
    const ImVec4 color = is_drawn ? theme::Series(static_cast<std::size_t>(curve - curves.begin())) : theme::kText;
    if (CutLink(number.rule, color)) Toggle(number.rule, curves);
    Tooltip(number.rule + (is_drawn ? "\nClick to take its curve away" : "\nClick to draw its curve"));
  }

  void Toggle(const std::string& rule, const std::vector<std::string>& curves) {
    curves_ = curves;
    if (std::erase(curves_, rule) > 0) return;
    if (curves_.size() >= kMostCurves) curves_.erase(curves_.begin());
    curves_.push_back(rule);
  }

  static void DrawCurves(PanelFrame& frame, const std::vector<std::string>& names) {
    const LearningLog* const log = frame.contents.learning_log;
    const workbench::Moment& moment = frame.contents.moment;
    std::vector<GraphCurve> curves;
    for (std::size_t n = 0; n < names.size(); ++n) {
      if (log == nullptr) break;
      const auto points = log->values().find(names[n]);
      if (points == log->values().end()) continue;
      GraphCurve& curve = curves.emplace_back(GraphCurve{names[n], theme::Series(n), {}});
      for (const auto& [tick, value] : points->second) curve.points.emplace_back(static_cast<double>(tick), value);
      // It holds on to the end.
      if (!curve.points.empty() && curve.points.back().first < static_cast<double>(moment.last_tick))
        curve.points.emplace_back(static_cast<double>(moment.last_tick), curve.points.back().second);
    }
    if (curves.empty()) {
      EmptyNote("No number has moved yet.", "Each change is noted from then on.");
      return;
    }
    DrawOverTime(frame, curves, "values");
  }

  static void DrawOverTime(PanelFrame& frame, const std::vector<GraphCurve>& curves, const char* id) {
    const workbench::Moment& moment = frame.contents.moment;
    const float height =
        std::max(frame.Px(44), ImGui::GetContentRegionAvail().y - TimeAxisHeight() - ImGui::GetStyle().ItemSpacing.y);
    const auto first = static_cast<double>(moment.first_tick), last = static_cast<double>(moment.last_tick);
    DrawGraph(frame, id, curves, height, first, last, true);
    DrawTimeAxis(frame, first, last);
  }

  // Episodes ----------------------------------------------------------------------------------------------------------

  static void DrawEpisodes(PanelFrame& frame) {
    const std::size_t count = EpisodesSoFar(frame);
    if (count == 0) {
      EmptyNote("No episode has ended yet.",
                "An episode ends when the agent halts, or selects an operator for which no learning rule speaks while "
                "temporal-extension is off.");
      return;
    }
    const auto& episodes = frame.contents.learning_log->episodes();
    bool is_wide = false;
    {
      const Part part("episodes", SizeOfList(frame, 0.4f, is_wide));
      DrawEpisodeTable(frame, episodes, count);
    }
    if (is_wide) ImGui::SameLine();
    const Part part("curve");
    std::vector<GraphCurve> curves(1);
    curves[0].name = "reward of an episode";
    curves[0].color = theme::Series(0);
    for (const debugger::RewardEpisode& episode : episodes)
      curves[0].points.emplace_back(static_cast<double>(episode.last_tick), episode.reward);
    DrawOverTime(frame, curves, "rewards");
  }

  static void DrawEpisodeTable(PanelFrame& frame, const std::deque<debugger::RewardEpisode>& episodes,
                               std::size_t count) {
    const List list("rewards", {{"Episode", 1}, {"Ended", 1.2f}, {"Took", 1}, {"Reward", 1.2f}});
    if (!list) return;
    ForRowsInSight(count, [&](int i) {
      const std::size_t number = count - 1 - static_cast<std::size_t>(i);
      const debugger::RewardEpisode& episode = episodes[number];
      const IdScope id(i);
      NextRow();
      ColoredText(theme::kQuiet, std::to_string(number + 1));
      ImGui::TableNextColumn();
      TimeLink(frame, episode.last_tick);
      Cell(theme::kText, Formatted("%.1f s", SecondsOf(frame, episode.last_tick - episode.first_tick)));
      Cell(episode.reward < 0 ? theme::kWarn : theme::kGood, Formatted("%.4g", episode.reward));
    });
  }

  int page_ = kRules;
  bool has_chosen_ = false;  ///< The page, by hand.
  std::string filter_;
  std::vector<std::string> curves_;  ///< That the user chose; none: those that moved most often.
};

}  // namespace

std::unique_ptr<Panel> MakeLearningPanel() {
  return std::make_unique<LearningPanel>();
}

}  // namespace soarbox::viewer
