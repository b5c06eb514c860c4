// SPDX-License-Identifier: BSD-2-Clause
// The panels of the window, over and around the picture, and the application's calls that concern them.
#include <algorithm>

#include "viewer/picture_notes.h"
#include "viewer/script_ui.h"
#include "viewer/viewer_impl.h"

namespace soarbox::viewer {

void Viewer::Impl::DrawPanels(float seconds) {
  if (workspace) workspace->ApplyInput();
  panels->BeginFrame(engine->window_width(), engine->window_height(), seconds);
  if (workspace) workspace->BeginPicture();
  const Projection view = View();
  const std::uint32_t inside = Inside();
  LabelScene wanted{scene.agents, overlays, selection, hovered, inside, shown_ghosts};
  wanted.names = IsOn(ViewerCommand::kLabels);
  wanted.speech = IsOn(ViewerCommand::kMessages);
  const ScreenRoom room = Room();
  std::vector<ScreenBox> blocked = BoxesOfScriptUi(scene, room);
  if (!workspace) blocked.push_back(DrawClock(*panels, scene));
  wanted.blocked = blocked;
  labels.Draw(panels->bold_font(), panels->panel_font(), wanted, camera.pose(), view);
  DrawScriptUi(scene, view, *panels, room, panel_images, buttons);
  if (box) DrawSelectionBox(box->from, box->to);
  if (notice_s > 0 && !options.hidden) DrawNotice(*panels, notice, std::min(1.0f, notice_s / 0.5f));
  if (workspace) {
    workspace->EndPicture();
    DrawWorkspace();
  }
  if (const auto* agent = cursor ? Find(hovered) : nullptr; agent != nullptr && agent->id != inside)
    DrawTooltip(*panels, *agent, overlays);
  panels->EndFrame();
}

void Viewer::Impl::DrawWorkspace() {
  const std::uint32_t before = selection.empty() ? 0 : selection.front();
  const WorkspaceHost::Asked asked = workspace->Draw(scene, status, before, options.hidden ? 0 : frames_per_second,
                                                     [this](ViewerCommand c) { return IsOn(c); });
  if (asked.selected != before) {
    selection.clear();
    if (asked.selected != 0) selection.push_back(asked.selected);
  }
  for (const ViewerCommand command : asked.commands) Do(command);
}

bool Viewer::panel_visible(workbench::PanelId panel) const {
  return impl_->workspace && impl_->workspace->layout().IsVisible(panel);
}

void Viewer::ShowPanel(workbench::PanelId panel) {
  if (impl_->workspace) impl_->workspace->layout().Show(panel);
}

void Viewer::OfferPanel(workbench::PanelId panel) {
  if (impl_->workspace) impl_->workspace->layout().Offer(panel);
}

const Layout& Viewer::layout() const {
  static const Layout kNone;
  return impl_->workspace ? impl_->workspace->layout() : kNone;
}

UiScriptProgress Viewer::ui_script() const {
  return impl_->workspace ? impl_->workspace->script() : UiScriptProgress{};
}

}  // namespace soarbox::viewer
