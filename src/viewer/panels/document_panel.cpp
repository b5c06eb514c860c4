// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/document_panel.h"

#include <algorithm>
#include <cfloat>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <utility>

#include "viewer/panels/document_spans.h"
#include "viewer/panels/graph.h"
#include "viewer/panels/rule_source.h"
#include "viewer/panels/widgets.h"
#include "workbench/document/panels.h"
#include "workbench/requests_json.h"

namespace soarbox::viewer {

namespace doc = workbench::document;

namespace {

template <typename Kind>
const Kind* As(const doc::Node& node) {
  return std::get_if<Kind>(&node.is);
}

/// A section that cannot be folded. Such sections are items of a list if one follows another.
bool IsItem(const doc::Node& node) {
  const auto* section = As<doc::Section>(node);
  return section != nullptr && !section->unfolds && !section->box && !section->nodes.empty();
}

void DrawParagraph(PanelFrame& frame, const doc::Paragraph& text) {
  using Style = doc::Paragraph::Style;
  if (text.style == Style::kEmpty) ImGui::Dummy({1, ImGui::GetFontSize() * 0.5f});
  ImGui::BeginGroup();
  DrawSpans(frame, text.spans);
  ImGui::EndGroup();
  Tooltip(text.hint);
}

void DrawCode(PanelFrame& frame, const doc::Code& code) {
  const FontScope mono(frame.fonts.mono);
  const float lines = static_cast<float>(std::ranges::count(code.text, '\n')) + 1;
  ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kField);
  const float bar = ImGui::GetStyle().ScrollbarSize;
  const Part part("code", {0, lines * ImGui::GetTextLineHeight() + bar + frame.Px(6)},
                  ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::PopStyleColor();
  SourceItem(code.text, code.tokens);
}

void DrawPlot(PanelFrame& frame, const doc::Plot& plot, float height, bool is_last) {
  const IdScope id(plot.key);
  std::vector<GraphCurve> curves;
  const workbench::Moment& moment = frame.contents.moment;
  for (std::size_t i = 0; i < plot.curves.size(); ++i)
    curves.push_back({plot.curves[i].name, theme::Series(i), plot.curves[i].points});
  const float button = plot.button ? ButtonWidth(plot.button->label.c_str()) + ImGui::GetStyle().ItemSpacing.x : 0;
  const float room = ImGui::GetContentRegionAvail().x - button - ImGui::CalcTextSize(plot.value.c_str()).x;
  CutText(plot.title, std::max(room - ImGui::GetStyle().ItemSpacing.x, 0.5f * room), theme::kText);
  ImGui::SameLine();
  CutText(plot.value, ImGui::GetContentRegionAvail().x - button, theme::kQuiet);
  Tooltip(plot.range);
  if (plot.button) {
    ImGui::SameLine();
    if (ImGui::SmallButton(plot.button->label.c_str()) && plot.button->action) Press(frame, *plot.button->action);
    Tooltip(plot.button->hint);
  }
  // The names of the curves, if there are several.
  for (std::size_t i = 0; curves.size() > 1 && i < curves.size(); ++i) {
    const std::string name = "\xe2\x80\x94 " + curves[i].name;
    if (i > 0) FlowLine(ImGui::CalcTextSize(name.c_str()).x);
    ColoredText(curves[i].color, name);
  }
  const auto first = static_cast<double>(moment.first_tick), last = static_cast<double>(moment.last_tick);
  DrawGraph(frame, "graph", curves, height, first, last, plot.is_stepped);
  if (is_last) DrawTimeAxis(frame, first, last);
}

/// An empty box, a check mark or a cross: shapes, so that the meaning does not depend on colors.
void DrawResult(const PanelFrame& frame, workbench::CheckResult result) {
  using workbench::CheckResult;
  const float size = ImGui::GetTextLineHeight(), inset = size * 0.15f, line = std::max(1.0f, frame.Px(1.6f));
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const ImVec2 low{at.x + inset, at.y + inset}, high{at.x + size - inset, at.y + size - inset};
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (result == CheckResult::kOpen) {
    list.AddRect(low, high, theme::Packed(theme::kQuiet), frame.Px(2));
  } else if (result == CheckResult::kPassed) {
    const ImVec2 foot{at.x + size * 0.42f, high.y};
    list.AddLine({low.x, at.y + size * 0.55f}, foot, theme::Packed(theme::kGood), line);
    list.AddLine(foot, {high.x, low.y}, theme::Packed(theme::kGood), line);
  } else {
    list.AddLine(low, high, theme::Packed(theme::kBad), line);
    list.AddLine({low.x, high.y}, {high.x, low.y}, theme::Packed(theme::kBad), line);
  }
  ImGui::Dummy({size, size});
}

void DrawChecklist(PanelFrame& frame, const doc::Checklist& list) {
  int number = 0;
  for (const doc::Checklist::Item& item : list.items) {
    const IdScope id(++number);
    DrawResult(frame, item.result);
    Tooltip(item.says);
    ImGui::SameLine(0, frame.Px(6));
    ImGui::BeginGroup();
    DrawSpans(frame, item.spans);
    const IdScope below("below");
    if (!item.below.empty()) DrawSpans(frame, item.below);
    ImGui::EndGroup();
    Tooltip(item.hint);
  }
}

void DrawProgress(PanelFrame& frame, const doc::Progress& progress) {
  WrappedText(progress.text);
  const float share = static_cast<float>(progress.value) / static_cast<float>(std::max<std::size_t>(progress.of, 1));
  ImGui::PushStyleColor(ImGuiCol_PlotHistogram, theme::kGood);
  ImGui::ProgressBar(share, {-1, frame.Px(5)}, "");
  ImGui::PopStyleColor();
}

/// A click or a drag selects a number. Marked numbers have a line, the selected one a frame.
void DrawStrip(PanelFrame& frame, const doc::Strip& strip) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = std::max(frame.Px(40), ImGui::GetContentRegionAvail().x), height = frame.Px(26);
  const float each = width / static_cast<float>(std::max<std::size_t>(strip.count, 1));
  ImGui::InvisibleButton("strip", {width, height});
  const auto middle = [&](std::size_t number) { return at.x + each * (static_cast<float>(number) - 0.5f); };
  const float share = std::clamp((ImGui::GetIO().MousePos.x - at.x) / width, 0.0f, 0.9999f);
  const auto under = static_cast<std::size_t>(share * static_cast<float>(strip.count)) + 1;
  ImDrawList& out = *ImGui::GetWindowDrawList();
  out.AddRectFilled(at, {at.x + width, at.y + height}, theme::Packed(theme::kField));
  for (std::size_t n = 1; n < strip.count && each >= frame.Px(4); ++n) {
    const float x = at.x + each * static_cast<float>(n);
    out.AddLine({x, at.y}, {x, at.y + height}, theme::Packed(theme::kEdge));
  }
  for (const std::size_t mark : strip.marks)
    out.AddLine({middle(mark), at.y + frame.Px(3)}, {middle(mark), at.y + height - frame.Px(3)},
                theme::Packed(theme::kGood), frame.Px(2));
  if (const float half = std::max(frame.Px(1.5f), each / 2); strip.chosen != 0)
    out.AddRect({middle(strip.chosen) - half, at.y}, {middle(strip.chosen) + half, at.y + height},
                theme::Packed(theme::kAccent), 0, 0, frame.Px(2));
  if (ImGui::IsItemActive() && under != strip.chosen) Press(frame, strip.press, std::to_string(under), {});
  if (ImGui::IsItemHovered()) Tooltip(strip.label + " " + std::to_string(under) + "; green: " + strip.mark);
}

/// Height of each of `count` graphs that share the remaining space of the panel.
float GraphHeight(const PanelFrame& frame, std::size_t count) {
  const float label = ImGui::GetTextLineHeightWithSpacing() + ImGui::GetStyle().ItemSpacing.y;
  const float room = ImGui::GetContentRegionAvail().y - TimeAxisHeight() - ImGui::GetStyle().ItemSpacing.y;
  return std::clamp(room / static_cast<float>(count) - label, frame.Px(44), frame.Px(160));
}

/// Opens and folds rows; returns true if the rows below must be drawn.
bool DrawFold(bool folds, bool is_open, bool is_controlled, bool& was_toggled) {
  if (is_controlled) ImGui::SetNextItemOpen(is_open, ImGuiCond_Always);
  const ImGuiTreeNodeFlags flags = (folds ? 0 : ImGuiTreeNodeFlags_Leaf | ImGuiTreeNodeFlags_Bullet) |
                                   (is_open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  const bool open = ImGui::TreeNodeEx("node", flags, "%s", "");
  was_toggled = folds && ImGui::IsItemToggledOpen();
  return open;
}

void DrawTreeRow(PanelFrame& frame, const doc::Tree& tree, const doc::TreeRow& row) {
  const IdScope id(row.key);
  const float label = ImGui::GetCursorPosX() + ImGui::GetTreeNodeToLabelSpacing() - ImGui::GetFontSize() * 0.3f;
  bool was_toggled = false;
  const bool open = DrawFold(row.folds, row.is_open, tree.unfold.has_value(), was_toggled);
  if (was_toggled && tree.unfold) Press(frame, *tree.unfold, row.key, row.arguments, !row.is_open);
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(label);
  ImGui::BeginGroup();
  DrawSpans(frame, row.spans);
  ImGui::EndGroup();
  if (ImGui::BeginPopupContextItem("menu")) {
    if (ImGui::MenuItem("Copy with everything below it")) {
      doc::Tree copy;
      copy.rows = {row};
      ImGui::SetClipboardText(doc::ToText({copy}, frame.contents.moment.step_s).c_str());
    }
    ImGui::EndPopup();
  }
  const bool is_link = !row.spans.empty() && row.spans.front().action.has_value();
  if (tree.press && !is_link) {
    if (ClickedLikeALink()) Press(frame, *tree.press, row.key, row.arguments);
    Tooltip(tree.press->hint);
  }
  if (!open) return;
  for (const doc::TreeRow& below : row.below) DrawTreeRow(frame, tree, below);
  ImGui::TreePop();
}

}  // namespace

void DocumentView::Draw(PanelFrame& frame, const doc::Nodes& nodes) {
  LookForNews(nodes);
  const doc::Actions* const actions = nodes.empty() ? nullptr : As<doc::Actions>(nodes.back());
  if (actions == nullptr) return DrawNodes(frame, nodes, true);
  float& height = heights_["actions"];
  {
    const Part part("above", {0, -std::max(height, ImGui::GetFrameHeightWithSpacing())});
    DrawRange(frame, nodes, 0, nodes.size() - 1, true);
  }
  const float begin = ImGui::GetCursorPosY();
  ImGui::Separator();
  const IdScope id("actions");
  DrawLine(frame, {actions->nodes});
  height = ImGui::GetCursorPosY() - begin + ImGui::GetStyle().ItemSpacing.y;
}

void DocumentView::LookForNews(const doc::Nodes& nodes) {
  constexpr int kFrames = 3;  // The height of the new contents is known some frames later.
  for (const doc::Node& node : nodes) {
    const auto* section = As<doc::Section>(node);
    if (section == nullptr || !section->news) continue;
    const auto [known, is_first] = news_.try_emplace(section->key, *section->news);
    if (is_first || known->second == *section->news) continue;
    known->second = *section->news;
    if (section->news->empty()) continue;
    section_to_show_ = section->key;
    frames_to_show_ = kFrames;
  }
}

void DocumentView::DrawNodes(PanelFrame& frame, const doc::Nodes& nodes, bool fills) {
  // A story is above the list that it belongs to; there is not always space for both.
  const auto story = std::ranges::find_if(nodes, [](const doc::Node& node) {
    const auto* section = As<doc::Section>(node);
    return section != nullptr && section->is_story;
  });
  const auto place = static_cast<std::size_t>(story - nodes.begin());
  if (fills && story != nodes.end() && place + 1 < nodes.size()) {
    DrawRange(frame, nodes, 0, place, false);
    return DrawStory(frame, nodes, place);
  }
  DrawRange(frame, nodes, 0, nodes.size(), fills);
}

void DocumentView::DrawRange(PanelFrame& frame, const doc::Nodes& nodes, std::size_t begin, std::size_t end,
                             bool fills) {
  for (std::size_t i = begin; i < end; ++i) {
    const IdScope id(static_cast<int>(i));
    // A table and its curves are next to each other if this gives both more space.
    const bool is_pair =
        fills && i + 2 == end && As<doc::Table>(nodes[i]) != nullptr && As<doc::Plot>(nodes[i + 1]) != nullptr;
    const ImVec2 room = ImGui::GetContentRegionAvail();
    if (is_pair && room.x > frame.Px(480) && room.x > 1.6f * room.y) {
      {
        const Part part("table", {room.x * 0.45f, 0});
        DrawNode(frame, nodes[i], true);
      }
      ImGui::SameLine();
      const Part part("curves");
      plot_height_ = GraphHeight(frame, 1);
      return DrawNode(frame, nodes[i + 1], true);
    }
    if (As<doc::Plot>(nodes[i]) != nullptr && (i == begin || As<doc::Plot>(nodes[i - 1]) == nullptr)) {
      const auto is_plot = [](const doc::Node& node) { return As<doc::Plot>(node) != nullptr; };
      const auto first = nodes.begin() + static_cast<std::ptrdiff_t>(i),
                 last = nodes.begin() + static_cast<std::ptrdiff_t>(end);
      plot_height_ = GraphHeight(frame, static_cast<std::size_t>(std::find_if_not(first, last, is_plot) - first));
    }
    if (i > begin && IsItem(nodes[i - 1]) && IsItem(nodes[i])) ImGui::Separator();
    DrawNode(frame, nodes[i], fills && i + 1 == end);
  }
}

void DocumentView::DrawStory(PanelFrame& frame, const doc::Nodes& nodes, std::size_t place) {
  const doc::Section& section = *As<doc::Section>(nodes[place]);
  const ImVec2 room = ImGui::GetContentRegionAvail();
  const IdScope id(section.key);
  const auto draw = [&] {
    DrawSpans(frame, section.title);
    DrawNodes(frame, section.nodes, false);
  };
  // In a wide panel the story is next to the list.
  if (room.x > frame.Px(640)) {
    {
      const Part list("list", {room.x * 0.5f, 0});
      DrawRange(frame, nodes, place + 1, nodes.size(), true);
    }
    ImGui::SameLine();
    const Part part("story");
    return draw();
  }
  // In a low panel only the story is shown until it is closed.
  constexpr float kLow_lines = 20, kMostShare = 0.56f;
  if (room.y < kLow_lines * ImGui::GetTextLineHeightWithSpacing()) {
    const Part part("story");
    return draw();
  }
  float& needed = heights_[section.key];
  const float most = room.y * kMostShare;
  {
    const Part part("story", {0, needed > 0 ? std::min(needed, most) : most});
    draw();
    needed = ImGui::GetCursorPosY() + ImGui::GetStyle().ItemSpacing.y;
  }
  ImGui::Separator();
  DrawRange(frame, nodes, place + 1, nodes.size(), true);
}

void DocumentView::DrawNode(PanelFrame& frame, const doc::Node& node, bool fills) {
  if (const auto* text = As<doc::Paragraph>(node)) return DrawParagraph(frame, *text);
  if (const auto* code = As<doc::Code>(node)) return DrawCode(frame, *code);
  if (const auto* line = As<doc::Line>(node)) return DrawLine(frame, *line);
  if (const auto* button = As<doc::Button>(node)) return DrawButton(frame, *button);
  if (const auto* form = As<doc::Form>(node)) return DrawForm(frame, *form);
  if (const auto* table = As<doc::Table>(node)) return DrawTable(frame, *table, fills);
  if (const auto* list = As<doc::Checklist>(node)) return DrawChecklist(frame, *list);
  if (const auto* progress = As<doc::Progress>(node)) return DrawProgress(frame, *progress);
  if (const auto* transcript = As<doc::Transcript>(node)) return DrawTranscript(frame, *transcript);
  if (const auto* section = As<doc::Section>(node)) return DrawSection(frame, *section);
  if (const auto* actions = As<doc::Actions>(node)) return DrawLine(frame, {actions->nodes});
  if (const auto* tabs = As<doc::Tabs>(node)) return DrawTabs(frame, *tabs, fills);
  if (const auto* columns = As<doc::Columns>(node)) return DrawColumns(frame, *columns);
  if (const auto* plot = As<doc::Plot>(node)) return DrawPlot(frame, *plot, plot_height_, fills);
  if (const auto* strip = As<doc::Strip>(node)) return DrawStrip(frame, *strip);
  if (const auto* tree = As<doc::Tree>(node)) {
    if (!fills) return DrawTree(frame, *tree);
    const Part part(tree->key.c_str());
    DrawTree(frame, *tree);
  }
}

// Lines, buttons and forms --------------------------------------------------------------------------------------------

void DocumentView::DrawButton(PanelFrame& frame, const doc::Button& button) {
  ImGui::BeginDisabled(!button.is_enabled);
  if (button.is_main) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const bool pressed =
      button.is_on ? LitButton(button.label.c_str(), *button.is_on, "") : ImGui::Button(button.label.c_str());
  if (button.is_main) ImGui::PopStyleColor();
  ImGui::EndDisabled();
  Tooltip(button.hint);
  if (!pressed) return;
  if (!button.copies.empty()) ImGui::SetClipboardText(button.copies.c_str());
  if (button.action) Press(frame, *button.action);
}

void DocumentView::DrawLine(PanelFrame& frame, const doc::Line& line) {
  int number = 0;
  for (const doc::Node& node : line.nodes) {
    const IdScope id(number);
    float width = frame.Px(150);
    if (const auto* button = As<doc::Button>(node)) width = ButtonWidth(button->label.c_str());
    const auto* text = As<doc::Paragraph>(node);
    if (text != nullptr) width = ImGui::CalcTextSize(TextOf(frame, text->spans).c_str()).x;
    if (As<doc::Form>(node) != nullptr && As<doc::Form>(node)->fields.size() > 1) width = FLT_MAX;
    if (number++ > 0) FlowLine(width);
    if (text != nullptr) ImGui::AlignTextToFramePadding();
    DrawNode(frame, node, false);
  }
}

bool DocumentView::DrawField(const doc::Form& form, const doc::Field& field, float right) {
  using Kind = doc::Field::Kind;
  FieldState& state = fields_[form.key + "/" + field.name];
  // The document's value is shown until the user types, and again after it changes.
  if (!state.is_set || (state.told != field.value && !state.is_active)) {
    state.text = state.told = field.value;
    state.is_set = true;
    state.choice = 0;
    for (std::size_t i = 0; i < field.options.size(); ++i)
      if (field.options[i].first == field.value) state.choice = static_cast<int>(i);
  }
  const std::string id = "##" + form.key + field.name;
  if (field.kind == Kind::kLine) {
    const std::string& hint = field.placeholder.empty() ? field.label : field.placeholder;
    const bool changed = SearchField(id.c_str(), hint.c_str(), state.text, right);
    state.is_active = ImGui::IsItemActive();
    const bool entered = WasEntered();
    Tooltip(field.label);
    return form.button.empty() ? changed : entered;
  }
  if (field.kind == Kind::kSuggested) return DrawSuggested(form, field, state, right);
  if (field.kind == Kind::kCheck && field.options.size() > 1) {
    bool is_on = state.choice == 1;
    if (!ImGui::Checkbox((field.label + id).c_str(), &is_on)) return false;
    state.choice = is_on ? 1 : 0;
    return form.button.empty();
  }
  float longest = 0;
  for (const auto& option : field.options) longest = std::max(longest, ImGui::CalcTextSize(option.second.c_str()).x);
  ImGui::SetNextItemWidth(std::min(longest + 3 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x));
  const std::size_t now = std::min(static_cast<std::size_t>(state.choice), field.options.size() - 1);
  bool changed = false;
  if (ImGui::BeginCombo(id.c_str(), field.options[now].second.c_str())) {
    for (std::size_t i = 0; i < field.options.size(); ++i) {
      if (!ImGui::Selectable(field.options[i].second.c_str(), i == now)) continue;
      state.choice = static_cast<int>(i);
      changed = true;
    }
    ImGui::EndCombo();
  }
  Tooltip(field.label);
  return changed && form.button.empty();
}

bool DocumentView::DrawSuggested(const doc::Form& form, const doc::Field& field, FieldState& state, float right) {
  const std::string id = "##" + form.key + field.name;
  const char* const hint = field.placeholder.empty() ? field.label.c_str() : field.placeholder.c_str();
  const bool is_live = form.button.empty();
  bool chosen = false;
  // The user types into a live field and gets suggestions from a menu. In other fields the user chooses, and may type
  // to search.
  if (is_live) {
    chosen = SearchField(id.c_str(), hint, state.text, ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.x);
    state.is_active = ImGui::IsItemActive();
    Tooltip(field.label);
    ImGui::SameLine();
  } else {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - right);
  }
  const ImGuiComboFlags flags = ImGuiComboFlags_HeightLargest | (is_live ? ImGuiComboFlags_NoPreview : 0);
  if (!ImGui::BeginCombo((id + "options").c_str(), is_live ? "" : hint, flags)) return chosen;
  if (!is_live) {
    SearchField("##search", "Filter", state.text);
    if (WasEntered() && !state.text.empty()) {
      chosen = true;
      ImGui::CloseCurrentPopup();
    }
  }
  for (const auto& [value, label] : field.options) {
    const std::string& shown = label.empty() ? value : label;
    if (!is_live && !HasPart(value, state.text) && !HasPart(shown, state.text)) continue;
    if (!ImGui::Selectable((shown + "##" + value).c_str())) continue;
    state.text = value;
    chosen = true;
  }
  ImGui::EndCombo();
  return chosen;
}

void DocumentView::DrawForm(PanelFrame& frame, const doc::Form& form) {
  bool sends = false;
  ImGui::BeginDisabled(!form.refusal.empty());
  for (std::size_t i = 0; i < form.fields.size(); ++i) {
    const doc::Field& field = form.fields[i];
    const bool is_last = i + 1 == form.fields.size();
    const bool is_check = field.kind == doc::Field::Kind::kCheck;
    if (i > 0)
      FlowLine(is_check ? ImGui::CalcTextSize(field.label.c_str()).x + 2 * ImGui::GetFontSize() : frame.Px(150));
    const float button = form.button.empty() ? 0 : ButtonWidth(form.button.c_str()) + ImGui::GetStyle().ItemSpacing.x;
    if (field.kind == doc::Field::Kind::kLine && focused_form_ == form.key) FocusNextField();
    if (field.kind == doc::Field::Kind::kLine && focused_form_ == form.key) focused_form_.clear();
    if (field.kind == doc::Field::Kind::kCommand) {
      sends |= DrawCommand(frame, form, field, button);
    } else {
      sends |= DrawField(form, field, is_last ? button : 0);
    }
  }
  if (!form.button.empty()) {
    FlowLine(ButtonWidth(form.button.c_str()));
    sends |= ImGui::Button(form.button.c_str());
    Tooltip(form.refusal.empty() ? form.hint : form.refusal);
  }
  ImGui::EndDisabled();
  if (const auto command = commands_.find(form.key); command != commands_.end() && !command->second.offered().empty())
    CutText(command->second.offered(), theme::kQuiet);
  if (sends) Send(frame, form);
}

bool DocumentView::DrawCommand(PanelFrame& frame, const doc::Form& form, const doc::Field& field, float right) {
  CommandField& command = commands_[form.key];
  // If this field replaces that of another agent, which had the keyboard, it gets the keyboard.
  const int now = ImGui::GetFrameCount();
  if (active_command_ != form.key && active_frame_ + 1 == now) command.Focus();
  const bool is_entered = command.Draw(frame, field, right, history_);
  if (command.is_active()) {
    active_command_ = form.key;
    active_frame_ = now;
  }
  return is_entered;
}

void DocumentView::Send(PanelFrame& frame, const doc::Form& form) {
  workbench::Json json = workbench::ToJson(form.action.request);
  const auto command = commands_.find(form.key);
  for (const doc::Field& field : form.fields) {
    if (field.kind == doc::Field::Kind::kCommand) {
      if (command->second.text().find_first_not_of(" \t") == std::string::npos) return;
      json[field.name] = command->second.text();
      continue;
    }
    FieldState& state = fields_[form.key + "/" + field.name];
    const bool is_line = field.kind == doc::Field::Kind::kLine || field.kind == doc::Field::Kind::kSuggested;
    const std::string& value = is_line ? state.text : field.options[static_cast<std::size_t>(state.choice)].first;
    if (field.is_needed && value.empty()) return;
    workbench::Json& told = json[field.name];
    told = told.is_number() ? workbench::Json(std::strtoull(value.c_str(), nullptr, 10)) : workbench::Json(value);
  }
  if (const auto request = workbench::ReadRequest(json)) Press(frame, {*request, form.action.panel});
  for (const doc::Field& field : form.fields)
    if (field.kind == doc::Field::Kind::kSuggested && !form.button.empty())
      fields_[form.key + "/" + field.name].text.clear();
  if (command != commands_.end()) {
    shows_newest_ = true;
    command->second.Focus();
    return command->second.Sent(history_);
  }
  if (!form.clears) return;
  for (const doc::Field& field : form.fields) fields_[form.key + "/" + field.name].text.clear();
  if (form.repeats) focused_form_ = form.key;
}

// Parts ---------------------------------------------------------------------------------------------------------------

void DocumentView::DrawTree(PanelFrame& frame, const doc::Tree& tree) {
  if (tree.filter.empty()) {
    for (const doc::TreeRow& row : tree.rows) DrawTreeRow(frame, tree, row);
    return;
  }
  std::string& filter = fields_[tree.key + "/filter"].text;
  SearchField("##filter", tree.filter.c_str(), filter);
  const auto has_part = [&](const auto& self, const doc::TreeRow& row) -> bool {
    return HasPart(TextOf(frame, row.spans), filter) ||
           std::ranges::any_of(row.below, [&](const doc::TreeRow& below) { return self(self, below); });
  };
  for (const doc::TreeRow& row : tree.rows)
    if (filter.empty() || has_part(has_part, row)) DrawTreeRow(frame, tree, row);
}

void DocumentView::DrawSection(PanelFrame& frame, const doc::Section& section) {
  if (section.title.empty() && section.nodes.empty()) return;
  const IdScope id(section.key);
  if (section_to_show_ == section.key && frames_to_show_ > 0 && --frames_to_show_ >= 0) ImGui::SetScrollHereY(0);
  if (section.box) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float inset = frame.Px(9);
    ImGui::Indent(inset);
    ImGui::BeginGroup();
    DrawSpans(frame, section.title);
    DrawNodes(frame, section.nodes, false);
    ImGui::EndGroup();
    ImGui::Unindent(inset);
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + frame.Px(3), ImGui::GetItemRectMax().y},
                                              theme::Packed(ColorOf(*section.box)));
    return ImGui::Spacing();
  }
  if (section.unfolds) {
    const ImGuiTreeNodeFlags flags = *section.unfolds ? ImGuiTreeNodeFlags_DefaultOpen : 0;
    if (!ImGui::TreeNodeEx("section", flags, "%s", TextOf(frame, section.title).c_str())) return;
    DrawNodes(frame, section.nodes, false);
    return ImGui::TreePop();
  }
  DrawSpans(frame, section.title);
  DrawNodes(frame, section.nodes, false);
}

void DocumentView::DrawTabs(PanelFrame& frame, const doc::Tabs& tabs, bool fills) {
  std::string& reason = reasons_[tabs.key];
  if (!tabs.reason.empty() && tabs.reason != reason) pages_[tabs.key] = static_cast<int>(tabs.first);
  reason = tabs.reason;
  const auto chosen = pages_.find(tabs.key);
  int page = chosen == pages_.end() ? static_cast<int>(tabs.first) : chosen->second;
  page = std::min(page, static_cast<int>(tabs.pages.size()) - 1);
  if (page < 0) return;
  for (std::size_t i = 0; i < tabs.pages.size(); ++i) {
    const doc::Tabs::Page& each = tabs.pages[i];
    if (i > 0) FlowLine(ButtonWidth(each.title.c_str()));
    if (LitButton((each.title + "###page" + std::to_string(i)).c_str(), page == static_cast<int>(i), each.hint))
      pages_[tabs.key] = page = static_cast<int>(i);
  }
  const IdScope id(page);
  DrawNodes(frame, tabs.pages[static_cast<std::size_t>(page)].nodes, fills);
}

void DocumentView::DrawColumns(PanelFrame& frame, const doc::Columns& columns) {
  if (columns.parts.empty()) return;
  std::vector<ListColumn> heads;
  for (const doc::Section& part : columns.parts) heads.push_back({part.key.c_str()});
  const List list("columns" + std::to_string(heads.size()), heads,
                  ImGuiTableFlags_Resizable | ImGuiTableFlags_BordersInnerV | ImGuiTableFlags_SizingStretchSame);
  if (!list) return;
  ImGui::TableNextRow();
  for (const doc::Section& part : columns.parts) {
    ImGui::TableNextColumn();
    const IdScope id(part.key);
    DrawNodes(frame, part.nodes, false);
  }
}

void DocumentView::DrawTranscript(PanelFrame& frame, const doc::Transcript& transcript) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, theme::kField);
  const Part part(transcript.key.c_str(), {0, 0}, ImGuiWindowFlags_HorizontalScrollbar);
  ImGui::PopStyleColor();
  if (ImGui::BeginPopupContextWindow("menu")) {
    if (ImGui::MenuItem("Copy all"))
      ImGui::SetClipboardText(doc::ToText({transcript}, frame.contents.moment.step_s).c_str());
    ImGui::EndPopup();
  }
  const bool is_near = ImGui::GetScrollY() >= ImGui::GetScrollMaxY() - 4 * ImGui::GetTextLineHeightWithSpacing();
  const FontScope mono(frame.fonts.mono);
  const auto draw = [&](int i) {
    const IdScope id(i);
    const doc::Span& line = transcript.lines[static_cast<std::size_t>(i)];
    if (!line.action) return ColoredText(ColorOf(line.role), line.text);
    if (Link("line", line.text, ColorOf(line.role))) Press(frame, *line.action);
    Tooltip(line.hint);
  };
  ForRowsInSight(transcript.lines.size(), draw, ImGui::GetTextLineHeightWithSpacing());
  SeenLines& seen = seen_lines_[transcript.key];
  if (seen.count == transcript.count) return;
  if (seen.frames == 0) seen.is_followed = std::exchange(shows_newest_, false) || is_near;
  if (seen.is_followed) ImGui::SetScrollHereY(1);
  if (++seen.frames <= 2) return;  // The part has its new height one frame later.
  seen = {transcript.count, 0};
}

std::string DocumentView::Unsent() const {
  for (const auto& [form, command] : commands_)
    if (command.text().find_first_not_of(" \t") != std::string::npos) return command.text();
  return {};
}

// The panel -----------------------------------------------------------------------------------------------------------

void DocumentPanel::Draw(PanelFrame& frame) {
  if (revision_ != frame.contents.revision) {
    nodes_ = doc::DocumentOf(panel_, frame.contents);
    revision_ = frame.contents.revision;
  }
  view_.Draw(frame, nodes_);
}

std::string DocumentPanel::Unsent() const {
  const std::string line = view_.Unsent();
  return line.empty() ? line : std::string(InfoOf(panel_).title) + ": \"" + line + "\" was typed and not sent.";
}

std::string DocumentPanel::Text(const PanelFrame& frame) const {
  return doc::ToText(doc::DocumentOf(panel_, frame.contents), frame.contents.moment.step_s);
}

}  // namespace soarbox::viewer
