// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/close_question.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// Frames until the result of a request must appear in the contents.
constexpr int kPatience = 10;

bool HasUnsaved(const workbench::Contents& contents) {
  return std::any_of(contents.open_files.begin(), contents.open_files.end(),
                     [](const workbench::OpenFile& file) { return file.is_unsaved; });
}

}  // namespace

bool Closing::MayClose(const workbench::Contents& contents, std::vector<std::string> unsent) {
  if (agreed_ || (!HasUnsaved(contents) && unsent.empty())) return true;
  is_open_ = true;
  saves_ = false;
  unsent_ = std::move(unsent);
  return false;
}

void Closing::Draw(PanelFrame& frame, float width, float height) {
  if (!is_open_) return;
  const auto close = [&] {
    agreed_ = true;
    is_open_ = false;
    frame.Command(ViewerCommand::kQuit);
  };
  if (saves_) {
    if (!HasUnsaved(frame.contents)) return close();
    if (++waited_ > kPatience) saves_ = false;
  }
  ImGui::SetNextWindowPos({width / 2, height / 2}, ImGuiCond_Always, {0.5f, 0.5f});
  ImGui::SetNextWindowSize({std::min(frame.Px(520), width - 20), 0});
  ImGui::SetNextWindowFocus();
  BeginOver("Close the window?", nullptr, ImGuiWindowFlags_AlwaysAutoResize);
  const bool has_files = HasUnsaved(frame.contents);
  if (has_files) WrappedText("These files have changes that are not saved:");
  for (const workbench::OpenFile& file : frame.contents.open_files) {
    if (!file.is_unsaved) continue;
    const std::string name = std::filesystem::path(file.file).filename().string();
    WrappedText(theme::kWarn, name + (file.is_changed ? ": typed, not applied" : ": applied to the running world"));
    if (!file.failure.empty()) WrappedText(theme::kBad, file.failure);
  }
  for (const std::string& text : unsent_) WrappedText(theme::kWarn, text);
  WrappedText(theme::kQuiet, has_files ? "If you close without saving, your text is kept as a draft and reappears when "
                                         "you open the file in Edit again."
                                       : "It is kept and comes back with this scenario.");
  ImGui::Spacing();
  if (has_files) {
    if (ImGui::Button("Save all and close")) {
      frame.Ask(workbench::SaveAllRequest{});
      saves_ = true;
      waited_ = 0;
    }
    FlowLine(ButtonWidth("Close without saving"), frame.Px(6));
  }
  const bool leaves = ImGui::Button(has_files ? "Close without saving" : "Close");
  FlowLine(ButtonWidth("Stay"), frame.Px(6));
  if (ImGui::Button("Stay")) Stay();
  ImGui::End();
  if (leaves) close();
}

}  // namespace soarbox::viewer
