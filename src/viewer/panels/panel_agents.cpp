// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>

#include "viewer/palette.h"
#include "viewer/panels/panel.h"
#include "viewer/panels/terms.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

using debugger::AgentColumn;
using debugger::AgentRow;

/// The impasse of the lowest state, "operator tie"; empty if there is none.
std::string ImpasseOf(const AgentRow& row) {
  const std::size_t open = row.state.find('(');
  return open == std::string::npos ? std::string() : row.state.substr(open + 1, row.state.size() - open - 2);
}

/// An operator whose command takes its time is selected still in the next decision: that is no trouble.
bool IsAtWork(const AgentRow& row) {
  return !row.op.empty() && ImpasseOf(row) == "operator no-change";
}

bool IsInTrouble(const AgentRow& row) {
  return !ImpasseOf(row).empty() && !IsAtWork(row);
}

/// "follow (O304)" without its identifier, which Mind shows.
std::string NameAlone(const std::string& op) {
  return op.substr(0, op.find(" ("));
}

/// The impasse of the lowest state, else what its body does, else the operator that is selected or was last.
std::string Doing(const AgentRow& row, const std::string& activity) {
  if (IsInTrouble(row)) return ImpasseOf(row);
  if (!row.alive) return "dead";
  if (!activity.empty()) return activity;
  if (debugger::IsForeign(row)) return "foreign";
  if (!row.op.empty()) return NameAlone(row.op);
  return row.last_op.empty() ? row.command : NameAlone(row.last_op);
}

std::string Condition(const AgentRow& row) {
  if (row.failed) return "stopped";
  return row.alive ? Formatted("%.0f", static_cast<double>(row.health)) : "dead";
}

/// The command that its body carries out now; empty: none, or nobody tells.
std::string ActivityOf(const PanelFrame& frame, std::uint32_t id) {
  const auto found = frame.contents.activities.find(id);
  return found == frame.contents.activities.end() ? std::string() : found->second;
}

/// What stands beside the name, without the health, px: as much as a row's texts need.
float RoomBeside(const AgentRow& row, const std::string& activity, bool is_wide, float pad) {
  const auto width = [pad](const std::string& text, const char* title) {
    constexpr float kSortSign_em = 1.2f;
    return std::max(ImGui::CalcTextSize(text.c_str()).x,
                    ImGui::CalcTextSize(title).x + kSortSign_em * ImGui::GetFontSize()) +
           pad;
  };
  const float doing = width(Doing(row, activity), "Doing");
  if (!is_wide) return doing;
  return doing + width(row.team, "Team") + width(row.kind, "Kind") + width("10000 us", "Decision");
}

class AgentsPanel final : public Panel {
 public:
  void Draw(PanelFrame& frame) override {
    const auto& all = frame.contents.agents;
    if (all.empty()) {
      EmptyNote("There are no agents in this world.", "A scenario makes them: see docs/scenarios.md.");
      return;
    }
    SearchField("##filter", "Filter", filter_);
    Tooltip("By name, kind, team, state, operator, command or error");
    const bool is_wide = ImGui::GetContentRegionAvail().x > frame.Px(480);
    // Names first: as wide as the longest, if that leaves room for what they do.
    float longest = 0;
    // What they do changes all the time: the columns only move when something longer comes.
    if (scale_ != frame.scale || is_wide_ != is_wide) others_ = 0;
    scale_ = frame.scale;
    is_wide_ = is_wide;
    const float pad = 2 * ImGui::GetStyle().CellPadding.x + 1;
    for (const AgentRow& row : all) {
      const float sign = row.errors > 0 ? 3 * ImGui::GetFontSize() : 0;
      longest = std::max(longest, ImGui::CalcTextSize(row.name.c_str()).x + sign);
      others_ = std::max(others_, RoomBeside(row, ActivityOf(frame, row.id), is_wide, pad));
    }
    const float health = ImGui::CalcTextSize("Health").x + ImGui::GetFontSize();
    // In a very narrow list health stands in the tooltip alone.
    constexpr float kNarrow_em = 17;
    const bool has_health = ImGui::GetContentRegionAvail().x > kNarrow_em * ImGui::GetFontSize();
    const float room = ImGui::GetContentRegionAvail().x - (has_health ? health : 0);
    // Where nobody has a mind, what they do needs little room.
    const bool is_quiet = std::none_of(all.begin(), all.end(), [](const AgentRow& row) { return row.has_mind; });
    const float share = is_wide ? 0.3f : is_quiet ? 0.66f : 0.5f;
    const float most = std::max(share * room, room - others_);
    const float names = std::clamp(longest + 2.2f * ImGui::GetFontSize(), 0.3f * room, most);
    // Widths that the user has dragged stay while names and text size do.
    const std::string id = Formatted("%s/%.0f/%.0f",
                                     is_wide      ? "agents-wide"
                                     : has_health ? "agents"
                                                  : "agents-narrow",
                                     static_cast<double>(names), static_cast<double>(frame.scale * 100));
    std::vector<ListColumn> columns;
    const auto column = [&](bool wanted, const char* name, float width, AgentColumn by,
                            ImGuiTableColumnFlags flags = 0) {
      if (wanted) columns.push_back({name, width, flags, static_cast<ImGuiID>(by)});
    };
    column(true, "Name", names, AgentColumn::kName, ImGuiTableColumnFlags_WidthFixed);
    column(is_wide, "Team", 2, AgentColumn::kTeam);
    column(true, "Doing", 3, AgentColumn::kOperator);
    column(has_health, "Health", health, AgentColumn::kHealth, ImGuiTableColumnFlags_WidthFixed);
    column(is_wide, "Kind", 2, AgentColumn::kKind);
    column(is_wide, "Decision", 2, AgentColumn::kTime);
    const List list(
        id, columns,
        List::kUsual | ImGuiTableFlags_Sortable | ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersInnerV);
    if (!list) return;
    Tooltip("Click to sort by this");
    std::vector<AgentRow> rows = filter_.empty() ? all : debugger::FilterAgents(all, filter_);
    if (const ImGuiTableSortSpecs* specs = ImGui::TableGetSortSpecs(); specs != nullptr && specs->SpecsCount > 0) {
      const ImGuiTableColumnSortSpecs& by = specs->Specs[0];
      debugger::SortAgents(rows, static_cast<AgentColumn>(by.ColumnUserID),
                           by.SortDirection == ImGuiSortDirection_Descending);
    }
    if (const auto next = StepInList(rows.size(), [&](std::size_t row) { return rows[row].id == frame.selected; }))
      frame.selected = rows[*next].id;
    ForRowsInSight(rows.size(), [&](int i) { DrawRow(frame, rows[static_cast<std::size_t>(i)], is_wide, has_health); });
  }

  std::string Text(const PanelFrame& frame) const override {
    return debugger::ToText(debugger::FilterAgents(frame.contents.agents, filter_));
  }

 private:
  static void DrawRow(PanelFrame& frame, const AgentRow& row, bool is_wide, bool has_health) {
    const IdScope id(static_cast<int>(row.id));
    NextRow();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float font = ImGui::GetFontSize();
    if (ImGui::Selectable("##row", row.id == frame.selected,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap)) {
      frame.selected = row.id;
    }
    if (ImGui::IsItemHovered()) {
      if (ImGui::IsMouseDoubleClicked(0)) frame.Command(ViewerCommand::kFrameSelection);
      DrawTooltip(row);
    }
    const world::Color color = row.team.empty() ? AgentColor(row.kind) : TeamColor(row.team);
    const ImVec2 sign{at.x + font * 0.45f, at.y + font * 0.55f};
    const ImU32 ink = ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1});
    const float half = font * 0.36f;
    if (debugger::IsForeign(row))
      ImGui::GetWindowDrawList()->AddQuad({sign.x, sign.y - half}, {sign.x + half, sign.y}, {sign.x, sign.y + half},
                                          {sign.x - half, sign.y}, ink, font * 0.13f);
    else
      ImGui::GetWindowDrawList()->AddCircleFilled(sign, font * 0.3f, ink);
    ImGui::SetCursorScreenPos({at.x + font * 1.1f, at.y});
    const bool dull = !row.alive || row.failed;
    const std::string errors = "\xe2\x9a\xa0" + std::to_string(row.errors);
    const float beside = row.errors > 0 ? ImGui::CalcTextSize(errors.c_str()).x + font * 0.5f : 0;
    const float room = ImGui::GetContentRegionAvail().x - beside;
    CutText(row.name.rfind('-') == std::string::npos ? row.name : CutBeforeNumber(row.name, room), room,
            dull ? theme::kQuiet : theme::kText);
    if (row.errors > 0) {
      ImGui::SameLine(0, font * 0.4f);
      if (Link("problems", errors, theme::kBad)) {
        frame.selected = row.id;
        frame.layout.Show(workbench::PanelId::kProblems);
      }
    }
    if (is_wide) CutCell(row.team, theme::kQuiet);
    CutCell(Doing(row, ActivityOf(frame, row.id)), IsInTrouble(row) ? theme::kWarn : theme::kText);
    if (!ImpasseOf(row).empty()) TermTooltip(ImpasseOf(row));
    if (has_health) Cell(row.health < 35 || dull ? theme::kBad : theme::kQuiet, Condition(row));
    if (!is_wide) return;
    CutCell(row.kind, theme::kQuiet);
    if (row.decide_us > 0) Cell(theme::kQuiet, Formatted("%.0f \xc2\xb5s", row.decide_us));
  }

  static void DrawTooltip(const AgentRow& row) {
    ImGui::BeginTooltip();
    const auto line = [](const char* label, const std::string& value) {
      if (value.empty()) return;
      ImGui::TextDisabled("%s", label);
      ImGui::SameLine(ImGui::GetFontSize() * 6);
      ImGui::TextUnformatted(value.c_str());
    };
    line("name", row.name);
    line("kind", row.kind);
    line("script", row.script);
    line("team", row.team);
    line("health", Condition(row));
    line("state", row.has_mind               ? row.state
                  : debugger::IsForeign(row) ? "foreign: another simulation moves it"
                                             : "no Soar mind: its script decides");
    line("operator", row.op);
    line("command", row.command);
    if (row.decide_us > 0) line("decision", Formatted("%.0f \xc2\xb5s", row.decide_us));
    line("error", row.error);
    ImGui::EndTooltip();
  }

  std::string filter_;
  float others_ = 0;  ///< The most room that texts beside the names have needed so far, px.
  float scale_ = 0;
  bool is_wide_ = false;
};

}  // namespace

std::unique_ptr<Panel> MakeAgentsPanel() {
  return std::make_unique<AgentsPanel>();
}

}  // namespace soarbox::viewer
