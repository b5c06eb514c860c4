// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/document_spans.h"

#include <charconv>
#include <nlohmann/json.hpp>
#include <utility>

#include "viewer/panels/widgets.h"
#include "workbench/requests_json.h"

namespace soarbox::viewer {

using workbench::document::Action;
using workbench::document::Role;
using workbench::document::RowAction;
using workbench::document::Span;
using workbench::document::Spans;

void Press(PanelFrame& frame, const Action& action) {
  if (const auto* select = std::get_if<workbench::SelectRequest>(&action.request))
    frame.Select(select->agent);
  else if (std::holds_alternative<workbench::FlowRequest>(action.request))
    frame.Command(ViewerCommand::kReset);
  else
    frame.Ask(action.request);
  if (action.panel) frame.layout.Show(*action.panel);
}

void Press(PanelFrame& frame, const RowAction& action, const std::string& key,
           const std::vector<std::string>& arguments, bool is_open) {
  if (action.argument > arguments.size()) return;
  const std::string& value = action.argument == 0 ? key : arguments[action.argument - 1];
  workbench::Json json = workbench::ToJson(action.action.request);
  workbench::Json& field = json[std::string(action.field)];
  if (field.is_number()) {
    std::uint64_t number = 0;
    std::from_chars(value.data(), value.data() + value.size(), number);
    field = number;
  } else {
    field = value;
  }
  if (json.contains("is_open")) json["is_open"] = is_open;
  if (const auto request = workbench::ReadRequest(json)) Press(frame, Action{*request, action.action.panel});
}

ImVec4 ColorOf(Role role) {
  switch (role) {
    case Role::kQuiet:
    case Role::kGone:
      return theme::kQuiet;
    case Role::kGood:
    case Role::kNew:
      return theme::kGood;
    case Role::kWarn:
      return theme::kWarn;
    case Role::kBad:
      return theme::kBad;
    case Role::kNumber:
      return theme::kNumber;
    case Role::kObject:
      return theme::kVariable;
    case Role::kName:
    case Role::kTag:
      return theme::kAccent;
    case Role::kPlain:
    case Role::kStrong:
    case Role::kCode:
      break;
  }
  return theme::kText;
}

std::string TextOf(const PanelFrame& frame, const Span& span) {
  return span.tick ? TimeOf(frame, *span.tick) : span.text;
}

std::string TextOf(const PanelFrame& frame, const Spans& spans) {
  std::string text;
  for (const Span& span : spans) text += TextOf(frame, span);
  return text;
}

namespace {

/// Draws a span at the cursor, in the remaining width.
void DrawSpan(PanelFrame& frame, const Span& span, std::string text, bool cuts) {
  const float room = ImGui::GetContentRegionAvail().x;
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  const ImVec4 color = span.tick && span.role == Role::kPlain ? theme::kAccent : ColorOf(span.role);
  const bool is_link = span.action.has_value();
  if (span.role == Role::kTag && is_link) {
    if (ImGui::SmallButton(text.c_str())) Press(frame, *span.action);
    return Tooltip(span.hint);
  }
  if (span.role == Role::kTag) {
    Tag(text, color);
    return Tooltip(span.hint);
  }
  if (width <= room || cuts) {
    const std::string shown = width <= room ? text : FittingText(text, room);
    if (!is_link) {
      width <= room ? ColoredText(color, text) : CutText(text, room, color);
    } else if (Link("span", shown, color)) {
      Press(frame, *span.action);
    }
    return Tooltip(shown != text        ? text + (span.hint.empty() ? "" : "\n" + span.hint)
                   : !span.hint.empty() ? span.hint
                   : span.tick          ? "Go to this moment"
                                        : "");
  }
  ImGui::BeginGroup();
  WrappedText(color, text);
  ImGui::EndGroup();
  if (is_link && ClickedLikeALink()) Press(frame, *span.action);
  Tooltip(span.hint);
}

}  // namespace

void DrawSpans(PanelFrame& frame, const Spans& spans, bool cuts) {
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  const float whole = ImGui::GetContentRegionAvail().x;
  int number = 0;
  for (const Span& span : spans) {
    const IdScope id(number);
    std::string text = TextOf(frame, span);
    const bool is_code = span.role == Role::kCode, is_strong = span.role == Role::kStrong;
    ImGui::PushFont(is_code ? frame.fonts.mono : is_strong ? frame.fonts.bold : frame.fonts.plain);
    if (number > 0) {
      const float left = right - ImGui::GetItemRectMax().x;
      const float width = ImGui::CalcTextSize(text.c_str()).x;
      // A text that is too long for any line begins on this line if most of the line is free.
      if (cuts ? left > frame.Px(30) : width <= left || (width > whole && left > whole * 0.6f)) {
        ImGui::SameLine(0, 0);
      } else if (cuts) {
        ImGui::PopFont();
        break;
      } else {
        text.erase(0, text.find_first_not_of(' '));
      }
    }
    if (!text.empty()) DrawSpan(frame, span, std::move(text), cuts);
    ImGui::PopFont();
    ++number;
  }
}

}  // namespace soarbox::viewer
