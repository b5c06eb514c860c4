// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/command_field.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "viewer/panels/widgets.h"
#include "workbench/requests_json.h"

namespace soarbox::viewer {
namespace {

/// Sends a request about the typed line.
void AskAbout(PanelFrame& frame, const workbench::Request& request, const std::string& line) {
  workbench::Json json = workbench::ToJson(request);
  json["line"] = line;
  if (const auto asked = workbench::ReadRequest(json)) frame.Ask(*asked);
}

void Replace(ImGuiInputTextCallbackData& data, const std::string& text) {
  data.DeleteChars(0, data.BufTextLen);
  data.InsertChars(0, text.c_str());
}

}  // namespace

bool CommandField::Draw(PanelFrame& frame, const workbench::document::Field& field, float right,
                        CommandHistory& history) {
  if (!std::exchange(is_set_, true)) line_ = kept_ = field.value;
  Complete(*field.command);
  ImGui::AlignTextToFramePadding();
  constexpr float kMostOfLine = 0.4f;
  CutText(field.prompt.empty() ? field.label : field.prompt, ImGui::GetContentRegionAvail().x * kMostOfLine,
          theme::kAccent);
  ImGui::SameLine();
  constexpr ImGuiInputTextFlags kFlags = ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_CallbackHistory |
                                         ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_CallbackAlways |
                                         ImGuiInputTextFlags_CallbackResize;
  if (std::exchange(wants_focus_, false)) FocusNextField();
  TakeFocus();
  history_ = &history;
  asks_ = false;
  bool is_entered = false;
  {
    const FontScope mono(frame.fonts.mono);
    ImGui::SetNextItemWidth(right > 0 ? -right : -1);
    is_entered = ImGui::InputTextWithHint(("##" + field.label).c_str(), field.placeholder.c_str(), line_.data(),
                                          line_.capacity() + 1, kFlags, &CommandField::OnEdit, this);
  }
  is_active_ = ImGui::IsItemActive();
  if (is_active_ && !line_.empty()) KeepKeyboard();
  if (is_entered) wants_focus_ = true;  // Enter ends the input, although an empty line is not sent.
  if (asks_) AskAbout(frame, field.command->complete.request, line_);
  if (line_ != kept_) AskAbout(frame, field.command->keep.request, kept_ = line_);
  return is_entered;
}

void CommandField::Sent(CommandHistory& history) {
  if (history.lines.empty() || history.lines.back() != line_) history.lines.push_back(line_);
  history.at = history.lines.size();
  line_.clear();
  offered_.clear();
}

void CommandField::Complete(const workbench::document::CommandLine& command) {
  if (waiting_for_.empty() || command.completed_line != waiting_for_) return;
  waiting_for_.clear();
  offered_.clear();
  if (command.found.words.empty()) return;
  replacement_ = line_.substr(0, std::min(command.found.begin, line_.size())) + command.found.common;
  if (command.found.words.size() == 1) replacement_ += " ";
  replaces_ = true;
  if (command.found.words.size() < 2) return;
  for (const std::string& word : command.found.words) offered_ += (offered_.empty() ? "" : "  ") + word;
}

int CommandField::OnEdit(ImGuiInputTextCallbackData* data) {
  auto& self = *static_cast<CommandField*>(data->UserData);
  switch (data->EventFlag) {
    case ImGuiInputTextFlags_CallbackResize:
      self.line_.resize(static_cast<std::size_t>(data->BufTextLen));
      data->Buf = self.line_.data();
      break;
    case ImGuiInputTextFlags_CallbackCompletion:
      self.waiting_for_.assign(data->Buf, static_cast<std::size_t>(data->BufTextLen));
      self.asks_ = !self.waiting_for_.empty();
      break;
    case ImGuiInputTextFlags_CallbackHistory:
      self.Recall(*data);
      break;
    case ImGuiInputTextFlags_CallbackAlways:
      if (std::exchange(self.replaces_, false)) Replace(*data, self.replacement_);
      break;
    default:
      break;
  }
  return 0;
}

void CommandField::Recall(ImGuiInputTextCallbackData& data) {
  if (history_->lines.empty()) return;
  if (data.EventKey == ImGuiKey_UpArrow && history_->at > 0) --history_->at;
  if (data.EventKey == ImGuiKey_DownArrow && history_->at < history_->lines.size()) ++history_->at;
  Replace(data, history_->at < history_->lines.size() ? history_->lines[history_->at] : "");
}

}  // namespace soarbox::viewer
