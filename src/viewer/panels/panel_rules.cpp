// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <map>

#include "debugger/fold_paths.h"
#include "viewer/panels/mind_note.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/rule_source.h"
#include "viewer/panels/terms.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

std::string ElementText(const explain::ElementFact& element) {
  return "(" + element.id + " ^" + element.attribute + " " + element.value + (element.acceptable ? " +)" : ")");
}

/// All rules of the selected agent, and one of them in full.
class RulesPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    if (!HasMind(frame)) return;
    const char* sets[] = {"all", "match now", "have fired", "never fired", "coverage"};
    ImGui::SetNextItemWidth(frame.Px(110));
    const int before = set_;
    ImGui::Combo("##set", &set_, sets, IM_ARRAYSIZE(sets));
    Tooltip("Which rules are listed. coverage: which took part in the run, and where the others stop");
    if (set_ == kCoverage && before != kCoverage) frame.Ask(workbench::CoverageRequest{});
    ImGui::SameLine();
    SearchField("##filter", "Filter by name", filter_);
    const bool has_rule = frame.contents.rule.has_value();
    {
      const Part list("list", {0, has_rule ? ImGui::GetContentRegionAvail().y * 0.36f : 0});
      set_ == kCoverage ? DrawCoverage(frame) : DrawList(frame);
    }
    if (has_rule) DrawRule(frame, *frame.contents.rule);
  }

  std::string Text(const PanelFrame& frame) const override {
    if (!frame.contents.has_mind || !frame.contents.not_available.empty()) return {};
    if (frame.contents.rule) return debugger::ToText(*frame.contents.rule);
    if (set_ == kCoverage) return debugger::ToText(frame.contents.coverage);
    std::vector<explain::RuleFact> rules;
    for (const explain::RuleFact& rule : frame.contents.rules)
      if (IsWanted(rule)) rules.push_back(rule);
    return rules.empty() ? std::string() : debugger::ToText(rules);
  }

 private:
  static constexpr int kCoverage = 4;

  bool IsWanted(const explain::RuleFact& rule) const {
    if (!HasPart(rule.name, filter_)) return false;
    return set_ == 0 || (set_ == 1 && rule.matches > 0) || (set_ == 2 && rule.firings > 0) ||
           (set_ == 3 && rule.firings == 0);
  }

  void DrawList(PanelFrame& frame) {
    auto rules = RowsThat(frame.contents.rules, [&](const explain::RuleFact& rule) { return IsWanted(rule); });
    if (rules.empty()) {
      if (!frame.contents.rules.empty()) {
        EmptyNote("No rule is like this.", "Clear the filter, or choose 'all'.");
      } else if (!frame.contents.not_recorded.empty()) {
        EmptyNote(frame.contents.not_recorded);
      } else {
        EmptyNote("This mind has no rules.", "Add some in the panel Edit, or type a rule into the Console.");
      }
      return;
    }
    const List list("rules",
                    {{"Rule", 6, ImGuiTableColumnFlags_NoSort},
                     {"Fired", 1.4f, ImGuiTableColumnFlags_PreferSortDescending},
                     {"Matches", 1.8f, ImGuiTableColumnFlags_PreferSortDescending}},
                    List::kUsual | ImGuiTableFlags_Sortable);
    if (!list) return;
    if (const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs(); specs != nullptr && specs->SpecsCount > 0) {
      const bool by_fired = specs->Specs[0].ColumnIndex == 1;
      const bool up = specs->Specs[0].SortDirection == ImGuiSortDirection_Ascending;
      // Counts change while somebody aims at a row: the order rests under the mouse.
      if (ImGui::IsWindowHovered() && !specs->SpecsDirty && !order_.empty()) {
        const auto place = [&](const explain::RuleFact* rule) {
          const auto found = order_.find(rule->name);
          return found == order_.end() ? order_.size() : found->second;
        };
        std::stable_sort(rules.begin(), rules.end(),
                         [&](const explain::RuleFact* a, const explain::RuleFact* b) { return place(a) < place(b); });
      } else {
        std::stable_sort(rules.begin(), rules.end(), [&](const explain::RuleFact* a, const explain::RuleFact* b) {
          const std::uint64_t x = by_fired ? a->firings : a->matches, y = by_fired ? b->firings : b->matches;
          return up ? x < y : y < x;
        });
        order_.clear();
        for (const explain::RuleFact* rule : rules) order_.emplace(rule->name, order_.size());
      }
      ImGui::TableGetSortSpecs()->SpecsDirty = false;
    }
    const auto next = StepInList(rules.size(), [&](std::size_t row) { return IsChosen(frame, rules[row]->name); });
    if (next) frame.Ask(workbench::RuleRequest{rules[*next]->name});
    ForRowsInSight(rules.size(), [&](int i) {
      const explain::RuleFact& rule = *rules[static_cast<std::size_t>(i)];
      NextRow();
      DrawName(frame, rule.name, rule.matches > 0 ? theme::kGood : rule.firings > 0 ? theme::kText : theme::kQuiet);
      Cell(rule.firings > 0 ? theme::kText : theme::kQuiet, std::to_string(rule.firings));
      Cell(rule.matches > 0 ? theme::kGood : theme::kQuiet, std::to_string(rule.matches));
    });
  }

  static bool IsChosen(const PanelFrame& frame, const std::string& name) {
    return frame.contents.rule && frame.contents.rule->rule.name == name;
  }

  static void DrawName(PanelFrame& frame, const std::string& name, ImVec4 color) {
    const bool chosen = IsChosen(frame, name);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable(("##" + name).c_str(), chosen, ImGuiSelectableFlags_SpanAllColumns))
      frame.Ask(workbench::RuleRequest{chosen ? "" : name});
    ImGui::PopStyleColor();
    Tooltip(name);
    ImGui::SetCursorScreenPos(at);
    CutText(name, color);
  }

  void DrawCoverage(PanelFrame& frame) {
    if (ImGui::SmallButton("Look again")) frame.Ask(workbench::CoverageRequest{});
    Tooltip("Notes how far the rules that have not fired match now");
    const List list("coverage", {{"Rule", 4}, {"Fired", 1.3f}, {"Stops at", 4}},
                    List::kUsual | ImGuiTableFlags_Resizable);
    if (!list) return;
    for (const debugger::Coverage::Row& row : frame.contents.coverage) {
      if (!HasPart(row.rule, filter_)) continue;
      NextRow();
      DrawName(frame, row.rule, row.firings > 0 ? theme::kGood : row.matched ? theme::kWarn : theme::kBad);
      Cell(row.firings > 0 ? theme::kText : theme::kBad, row.firings > 0 ? std::to_string(row.firings) : "never");
      ImGui::TableNextColumn();
      if (row.firings == 0 && !row.stops_at.empty()) {
        WrappedText(theme::kQuiet,
                    std::to_string(row.furthest) + " of " + std::to_string(row.conditions) + " hold; " + row.stops_at);
      }
    }
  }

  void DrawRule(PanelFrame& frame, const debugger::RuleView& view) {
    ImGui::Separator();
    const explain::RuleFact& rule = view.rule;
    {
      const FontScope bold(frame.fonts.bold);
      WrappedText(theme::kAccent, rule.name);
    }
    if (ImGui::SmallButton("Edit") && !rule.file.empty())
      frame.AskIn(workbench::PanelId::kEdit, workbench::EditRequest{rule.file, rule.line, rule.name});
    Tooltip(rule.file.empty() ? "It was typed, or learned: there is no file"
                              : rule.file + ":" + std::to_string(rule.line));
    for (const auto& [label, kind] : {std::pair{"Break when it fires", debugger::BreakKind::kFire},
                                      {"Break when it matches", debugger::BreakKind::kMatch}}) {
      FlowLine(ButtonWidth(label));
      if (ImGui::SmallButton(label))
        frame.AskIn(workbench::PanelId::kBreakpoints, workbench::BreakRequest{kind, frame.contents.agent, rule.name});
    }
    FlowLine(ButtonWidth("Copy"));
    if (ImGui::SmallButton("Copy")) {
      ImGui::SetClipboardText(frame.contents.rule_text.empty() ? view.source.c_str()
                                                               : frame.contents.rule_text.c_str());
    }
    Tooltip("The rule's text");
    FlowLine(ButtonWidth("Close"));
    if (ImGui::SmallButton("Close")) frame.Ask(workbench::RuleRequest{});
    const Part part("rule", {0, 0}, ImGuiWindowFlags_HorizontalScrollbar);
    if (view.source.empty()) {
      WrappedText(theme::kQuiet, frame.contents.past_note.empty()
                                     ? "Its text is not available there."
                                     : "Its text is not recorded: it is shown once the moment is simulated again.");
    }
    ColoredText(theme::kQuiet, rule.type + ", fired " + std::to_string(rule.firings) +
                                   (rule.firings == 1 ? " time, " : " times, ") + std::to_string(rule.matches) +
                                   (rule.matches == 1 ? " match" : " matches") + " now");
    TermTooltip(rule.type);
    if (!rule.documentation.empty()) WrappedText(rule.documentation);
    DrawMatch(frame, view.match);
    const FontScope mono(frame.fonts.mono);
    const std::string& written = frame.contents.rule_text;
    if (written != shown_text_) {
      shown_text_ = written;
      tokens_ = debugger::Tokenize(written);
    }
    // As its author wrote it; what was typed or learned, as it is printed.
    if (written.empty())
      SourceItem(view.source, view.tokens);
    else
      SourceItem(shown_text_, tokens_);
    DrawMatches(frame, view.match.facts);
  }

  static void DrawMatch(PanelFrame& frame, const debugger::PartialMatch& match) {
    if (!match.facts.failing) {
      if (!match.sentence.empty()) WrappedText(theme::kGood, match.sentence);
      return;
    }
    // As its author wrote it.
    const explain::MatchFacts facts = debugger::FoldPaths(match.facts);
    WrappedText(theme::kBad, debugger::Explain(facts));
    const FontScope mono(frame.fonts.mono);
    for (std::size_t i = 0; i < facts.conditions.size(); ++i) {
      const explain::ConditionFact& condition = facts.conditions[i];
      const bool is_failing = i == *facts.failing, is_behind = i > *facts.failing;
      const char* sign = is_failing ? "\xe2\x9c\x97 " : is_behind ? "  " : "\xe2\x9c\x93 ";
      ColoredText(
          is_failing  ? theme::kBad
          : is_behind ? theme::kQuiet
                      : theme::kGood,
          sign + condition.text + (is_behind || is_failing ? "" : "  " + std::to_string(condition.partial_matches)));
    }
    for (const explain::ElementFact& seen : facts.seen) ColoredText(theme::kWarn, "  there is " + ElementText(seen));
    for (const explain::ElementFact& seen : facts.candidates)
      ColoredText(theme::kWarn, "  would do, but does not fit the others: " + ElementText(seen));
  }

  static void DrawMatches(PanelFrame& frame, const explain::MatchFacts& facts) {
    if (facts.matches.empty()) return;
    Heading(frame, "Matches");
    int number = 0;
    for (const auto& match : facts.matches) {
      ColoredText(theme::kQuiet, "match " + std::to_string(++number));
      for (const explain::ElementFact& element : match) ColoredText(theme::kText, "  " + ElementText(element));
    }
  }

  int set_ = 0;
  std::string filter_;
  std::map<std::string, std::size_t> order_;  ///< The places of rules when they were sorted last.
  std::string shown_text_;
  std::vector<debugger::Token> tokens_;  ///< Of it.
};

}  // namespace

std::unique_ptr<Panel> MakeRulesPanel() {
  return std::make_unique<RulesPanel>();
}

}  // namespace soarbox::viewer
