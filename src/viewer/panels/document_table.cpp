// SPDX-License-Identifier: BSD-2-Clause
// Tables of documents: filters, groups, sorting, folded rows, and columns that fit the panel.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "viewer/palette.h"
#include "viewer/panels/document_panel.h"
#include "viewer/panels/document_spans.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {

namespace doc = workbench::document;

namespace {

/// Panels wider than this show all columns.
constexpr float kNarrow_px = 480;
/// Maximum number of rows whose texts are measured for the width of a column.
constexpr std::size_t kMeasured = 200;
/// Maximum number of rows that are visible at once in a table before other parts.
constexpr std::size_t kMostUnboxed = 8;
/// Maximum fraction of the room that names of agents take from columns with longer texts.
constexpr float kNames = 0.6f;
/// With more rows, a table draws only the visible ones, each as one line.
constexpr std::size_t kMostWrapped = 200;

float WidthOfCell(const PanelFrame& frame, const doc::TableRow& row, std::size_t column) {
  if (column >= row.cells.size()) return 0;
  float width = ImGui::CalcTextSize(TextOf(frame, row.cells[column].spans).c_str()).x;
  for (const doc::Span& span : row.cells[column].spans)
    if (span.role == doc::Role::kTag) width += 2 * ImGui::GetStyle().FramePadding.x;
  if (column == 0) {
    width += ImGui::GetFontSize() * 0.8f * static_cast<float>(row.depth);
    if (row.sign) width += ImGui::GetFontSize() * 1.1f;
    if (row.folds) width += ImGui::GetTreeNodeToLabelSpacing();
  }
  return width;
}

void DrawBodySign(const doc::BodySign& sign) {
  const world::Color color = sign.team.empty() ? AgentColor(sign.kind) : TeamColor(sign.team);
  const float font = ImGui::GetFontSize(), half = font * 0.36f;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 middle{at.x + font * 0.45f, at.y + font * 0.55f};
  const ImU32 ink = ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, 1});
  ImDrawList& out = *ImGui::GetWindowDrawList();
  if (sign.is_foreign)
    out.AddQuad({middle.x, middle.y - half}, {middle.x + half, middle.y}, {middle.x, middle.y + half},
                {middle.x - half, middle.y}, ink, font * 0.13f);
  else
    out.AddCircleFilled(middle, font * 0.3f, ink);
  ImGui::SetCursorScreenPos({at.x + font * 1.1f, at.y});
}

void DrawBar(double share) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float length = ImGui::GetContentRegionAvail().x * static_cast<float>(std::min(1.0, std::abs(share)));
  ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + length, at.y + ImGui::GetTextLineHeight()},
                                            theme::Packed(share < 0 ? theme::kWarn : theme::kGood, 0.35f));
}

}  // namespace

void DocumentView::Arrange(PanelFrame& frame, const doc::Table& table, TableState& state) const {
  const std::string wanted = state.filter + '\0' + std::to_string(state.group) + '\0' +
                             std::to_string(state.sorted_by) + (state.is_descending ? "-" : "+");
  const bool is_same_question = wanted == state.arranged_for;
  if (is_same_question && state.revision == frame.contents.revision) return;
  // Values change while the user aims at a row, so the order is kept while the mouse is over the table.
  const bool rests = is_same_question && state.sorted_by >= 0 && ImGui::IsWindowHovered(ImGuiHoveredFlags_ChildWindows);
  state.revision = frame.contents.revision;
  state.arranged_for = wanted;
  if (rests && state.rows.size() == table.rows.size()) return;
  state.rows.clear();
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const doc::TableRow& row = table.rows[i];
    if (!table.groups.empty() && (row.groups >> state.group & 1u) == 0) continue;
    if (!state.filter.empty()) {
      std::string text = row.hint;
      for (const doc::Cell& cell : row.cells) text.append(" ").append(TextOf(frame, cell.spans));
      if (!HasPart(text, state.filter)) continue;
    }
    state.rows.push_back(i);
  }
  if (state.sorted_by < 0) return;
  const auto column = static_cast<std::size_t>(state.sorted_by);
  std::stable_sort(state.rows.begin(), state.rows.end(), [&](std::size_t a, std::size_t b) {
    const doc::TableRow& first = table.rows[state.is_descending ? b : a];
    const doc::TableRow& second = table.rows[state.is_descending ? a : b];
    if (column >= first.cells.size() || column >= second.cells.size()) return false;
    const doc::Cell &x = first.cells[column], &y = second.cells[column];
    if (x.number && y.number) return *x.number < *y.number;
    return TextOf(frame, x.spans) < TextOf(frame, y.spans);
  });
}

void DocumentView::DrawTableBar(PanelFrame& frame, const doc::Table& table, TableState& state) {
  if (!table.groups.empty()) {
    const std::string& now = table.groups[static_cast<std::size_t>(state.group)];
    float longest = 0;
    for (const std::string& group : table.groups) longest = std::max(longest, ImGui::CalcTextSize(group.c_str()).x);
    ImGui::SetNextItemWidth(longest + 2.6f * ImGui::GetFontSize());
    if (ImGui::BeginCombo("##groups", now.c_str())) {
      for (std::size_t i = 0; i < table.groups.size(); ++i)
        if (ImGui::Selectable(table.groups[i].c_str(), state.group == static_cast<int>(i)))
          state.group = static_cast<int>(i);
      ImGui::EndCombo();
    }
    Tooltip(table.groups_hint);
    if (!table.filter.empty()) FlowLine(frame.Px(90));
  }
  if (!table.filter.empty()) SearchField("##filter", table.filter.c_str(), state.filter);
}

std::vector<std::size_t> DocumentView::MeasureColumns(PanelFrame& frame, const doc::Table& table, TableState& state,
                                                      float room) {
  const bool is_narrow = room < frame.Px(kNarrow_px);
  if (state.scale != frame.scale || state.room != room || state.widths.size() != table.columns.size())
    state.widths.assign(table.columns.size(), 0);
  const bool is_known = state.measured == frame.contents.revision && state.scale == frame.scale && state.room == room;
  state.measured = frame.contents.revision;
  state.scale = frame.scale;
  state.room = room;
  std::vector<std::size_t> shown;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].is_wide && is_narrow) continue;
    shown.push_back(c);
    if (is_known) continue;
    float& width = state.widths[c];
    if (table.has_heads) {
      const float sort_sign = table.is_sortable ? ImGui::GetFontSize() : 0;
      width = std::max(width, ImGui::CalcTextSize(table.columns[c].title.c_str()).x + sort_sign);
    }
    for (std::size_t i = 0; i < std::min(kMeasured, state.rows.size()); ++i)
      width = std::max(width, WidthOfCell(frame, table.rows[state.rows[i]], c));
  }
  return shown;
}

namespace {

/// The column that takes the remaining width: the widest with text.
std::size_t WidestOf(const doc::Table& table, const std::vector<float>& needed, const std::vector<std::size_t>& shown) {
  std::size_t widest = shown.back();
  float most = -1;
  for (const std::size_t c : shown) {
    if (table.columns[c].is_number || needed[c] < most) continue;
    widest = c;
    most = needed[c];
  }
  return widest;
}

/// Whether the first column has the names of agents.
bool NamesAgents(const doc::Table& table) {
  return !table.rows.empty() && table.rows.front().sign.has_value();
}

/// Narrow columns have the widths of their texts; wider ones share the rest. Names of agents get more than the others.
std::vector<float> FittedWidths(const doc::Table& table, const std::vector<float>& needed,
                                const std::vector<std::size_t>& shown, float room) {
  const float pad = 2 * ImGui::GetStyle().CellPadding.x + 2;
  std::vector<std::size_t> order(shown.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto rank = [&](std::size_t i) { return table.columns[shown[i]].is_number ? 0 : needed[shown[i]]; };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  std::vector<float> widths(shown.size());
  float left = room - pad * static_cast<float>(shown.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    const float even = left / static_cast<float>(order.size() - n);
    const float share = std::max({1.0f, even, NamesAgents(table) && shown[order[n]] == 0 ? kNames * left : 0});
    const float wanted = std::ceil(needed[shown[order[n]]] / 4 + 0.5f) * 4;
    widths[order[n]] = table.columns[shown[order[n]]].is_number ? wanted : std::floor(std::min(wanted, share));
    left -= widths[order[n]];
  }
  return widths;
}

}  // namespace

void DocumentView::DrawTable(PanelFrame& frame, const doc::Table& table, bool fills) {
  const IdScope id(table.key);
  TableState& state = tables_[table.key];
  if (!table.caption.empty()) Heading(frame, table.caption);
  DrawTableBar(frame, table, state);
  Arrange(frame, table, state);
  if (state.rows.empty()) {
    if (!table.none_fits.first.empty()) EmptyNote(table.none_fits.first, table.none_fits.second);
    return;
  }
  // A table before other parts scrolls in a box if it has many rows; the last part takes the remaining height.
  const float line = ImGui::GetTextLineHeight() + 2 * ImGui::GetStyle().CellPadding.y;
  const bool is_boxed = !fills && state.rows.size() > kMostUnboxed;
  const bool scrolls = is_boxed || (fills && ImGui::GetContentRegionAvail().y > 5 * line);
  const float room = ImGui::GetContentRegionAvail().x - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
  const std::vector<std::size_t> shown = MeasureColumns(frame, table, state, room);
  const std::vector<float> widths = FittedWidths(table, state.widths, shown, room);
  std::vector<ListColumn> columns;
  std::string key = "table";
  const std::size_t widest = WidestOf(table, state.widths, shown);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const doc::Column& column = table.columns[shown[i]];
    const bool is_stretched = shown[i] == widest;
    columns.push_back({column.title.c_str(), is_stretched ? 1 : widths[i],
                       is_stretched ? ImGuiTableColumnFlags_WidthStretch : ImGuiTableColumnFlags_WidthFixed});
    if (table.is_sortable && column.is_number) columns.back().flags |= ImGuiTableColumnFlags_PreferSortDescending;
    // ImGui treats a table with other widths as a new one; this keeps the sorting.
    if (table.is_sortable && state.sorted_by == static_cast<int>(shown[i])) {
      columns.back().flags &= ~ImGuiTableColumnFlags_PreferSortDescending;
      columns.back().flags |=
          ImGuiTableColumnFlags_DefaultSort | (state.is_descending ? ImGuiTableColumnFlags_PreferSortDescending
                                                                   : ImGuiTableColumnFlags_PreferSortAscending);
    }
    // Widths that the user has dragged are kept until the texts need other widths.
    key.append("/").append(std::to_string(static_cast<int>(widths[i])));
  }
  ImGuiTableFlags flags = ImGuiTableFlags_RowBg | (scrolls ? ImGuiTableFlags_ScrollY : 0);
  flags |= ImGuiTableFlags_Resizable;  // Without this flag, ImGui would derive the widths from texts that are cut.
  if (table.has_heads) flags |= ImGuiTableFlags_BordersInnerV;
  if (table.is_sortable) flags |= ImGuiTableFlags_Sortable | ImGuiTableFlags_SortTristate;
  const float height = is_boxed ? std::clamp(ImGui::GetContentRegionAvail().y * 0.6f, 3 * line,
                                             line * (static_cast<float>(kMostUnboxed) + 1))
                                : 0;
  if (!ImGui::BeginTable(key.c_str(), static_cast<int>(columns.size()), flags, {0, height})) return;
  if (scrolls && table.has_heads) ImGui::TableSetupScrollFreeze(0, 1);
  for (const ListColumn& column : columns) ImGui::TableSetupColumn(column.name, column.flags, column.width);
  if (table.has_heads) ImGui::TableHeadersRow();
  if (ImGuiTableSortSpecs* const specs = table.is_sortable ? ImGui::TableGetSortSpecs() : nullptr) {
    state.sorted_by =
        specs->SpecsCount > 0 ? static_cast<int>(shown[static_cast<std::size_t>(specs->Specs[0].ColumnIndex)]) : -1;
    state.is_descending = specs->SpecsCount > 0 && specs->Specs[0].SortDirection == ImGuiSortDirection_Descending;
    specs->SpecsDirty = false;
  }
  DrawRows(frame, table, state, shown);
  ImGui::EndTable();
}

namespace {

void DrawCell(PanelFrame& frame, const doc::Cell& cell, bool wraps) {
  if (cell.bar) DrawBar(*cell.bar);
  // Values may have several lines.
  if (wraps && cell.spans.size() == 1 && !cell.spans[0].action && !cell.spans[0].tick) {
    const bool is_code = cell.spans[0].role == doc::Role::kCode;
    const FontScope font(is_code ? frame.fonts.mono : frame.fonts.plain);
    FoldedText("text", cell.spans[0].text, ColorOf(cell.spans[0].role));
    return Tooltip(cell.spans[0].hint);
  }
  ImGui::BeginGroup();
  DrawSpans(frame, cell.spans, !wraps);
  ImGui::EndGroup();
}

/// A cell with the name of an agent, without the middle of the name if it is too wide: the end distinguishes agents.
void DrawName(PanelFrame& frame, doc::Cell cell) {
  if (cell.spans.empty()) return;
  const float others = ImGui::CalcTextSize(TextOf(frame, cell.spans).c_str()).x -
                       ImGui::CalcTextSize(TextOf(frame, cell.spans.front()).c_str()).x;
  std::string& name = cell.spans.front().text;
  name = CutBeforeNumber(name, ImGui::GetContentRegionAvail().x - others);
  DrawCell(frame, cell, false);
}

/// Draws the first cell, with the selection of the row, its fold and its icon. Returns whether the rows below are
/// visible.
bool BeginRow(PanelFrame& frame, const doc::Table& table, const doc::TableRow& row) {
  bool is_open = true;
  if (table.press) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::Selectable("##row", row.is_chosen,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap))
      Press(frame, *table.press, row.key, row.arguments);
    Tooltip(row.hint);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0) &&
        std::holds_alternative<workbench::SelectRequest>(table.press->action.request))
      frame.Command(ViewerCommand::kFrameSelection);
    ImGui::SetCursorScreenPos(at);
  }
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ImGui::GetFontSize() * 0.8f * static_cast<float>(row.depth));
  if (row.folds) {
    const ImGuiTreeNodeFlags flags =
        ImGuiTreeNodeFlags_NoTreePushOnOpen | (row.is_open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
    is_open = ImGui::TreeNodeEx("fold", flags, "%s", "");
    // Without a label the item is only as wide as its arrow.
    ImGui::SameLine(0, 2 * ImGui::GetStyle().FramePadding.x);
  }
  if (row.sign) DrawBodySign(*row.sign);
  return is_open;
}

}  // namespace

void DocumentView::DrawRows(PanelFrame& frame, const doc::Table& table, TableState& state,
                            const std::vector<std::size_t>& columns) {
  const bool folds = std::ranges::any_of(state.rows, [&](std::size_t i) { return table.rows[i].folds; });
  const bool wraps =
      state.rows.size() <= kMostWrapped &&
      (folds || std::ranges::any_of(table.columns, [](const doc::Column& column) { return column.wraps; }));
  int hidden_below = -1;  // Rows deeper than this are folded.
  const auto draw = [&](std::size_t place) {
    const doc::TableRow& row = table.rows[state.rows[place]];
    if (hidden_below >= 0 && row.depth > hidden_below) return;
    hidden_below = -1;
    const IdScope id(row.key);
    ImGui::TableNextRow();
    for (const std::size_t c : columns) {
      ImGui::TableNextColumn();
      const IdScope cell_id(static_cast<int>(c));
      if (c == columns.front() && !BeginRow(frame, table, row)) hidden_below = row.depth;
      if (c < row.cells.size() && c == columns.front() && row.sign) {
        DrawName(frame, row.cells[c]);
      } else if (c < row.cells.size()) {
        DrawCell(frame, row.cells[c], wraps && table.columns[c].wraps);
      }
      if (!table.press && c == columns.front()) Tooltip(row.hint);
    }
  };
  if (table.press) {
    const auto is_chosen = [&](std::size_t place) { return table.rows[state.rows[place]].is_chosen; };
    if (const auto next = StepInList(state.rows.size(), is_chosen)) {
      const doc::TableRow& row = table.rows[state.rows[*next]];
      Press(frame, *table.press, row.key, row.arguments);
    }
  }
  if (wraps || folds) {
    for (std::size_t place = 0; place < state.rows.size(); ++place) draw(place);
  } else {
    ForRowsInSight(state.rows.size(), [&](int place) { draw(static_cast<std::size_t>(place)); });
  }
}

}  // namespace soarbox::viewer
