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
  if (!workspace) {
    wanted.top_px = options.show_status_bar ? kStatusBar_px : 0;
    if (Selected() != nullptr) {
      PlaceCard(view, blocked);
      blocked.push_back(card);
    }
  }
  wanted.blocked = blocked;
  labels.Draw(panels->bold_font(), panels->panel_font(), wanted, camera.pose(), view);
  DrawScriptUi(scene, view, *panels, room, panel_images, buttons);
  if (box) DrawSelectionBox(box->from, box->to);
  if (const auto* agent = cursor ? Find(hovered) : nullptr; agent != nullptr && agent->id != inside)
    DrawTooltip(*panels, *agent, overlays, *cursor);
  if (notice_s > 0 && !options.hidden) DrawNotice(*panels, notice, std::min(1.0f, notice_s / 0.5f));
  if (workspace) {
    workspace->EndPicture();
    DrawWorkspace();
  } else {
    if (const auto* agent = Selected())
      card = DrawAgentCard(*panels, *agent, camera.mode() == CameraMode::kFollow, card_corner);
    if (IsOn(ViewerCommand::kHelp)) DrawKeyHelp(*panels);
    if (options.show_status_bar) DrawStatusBar(*panels, status, scene, options.hidden ? 0 : frames_per_second);
  }
  panels->EndFrame();
}

void Viewer::Impl::PlaceCard(const Projection& view, const std::vector<ScreenBox>& blocked) {
  constexpr float kUsualWidth_px = 250, kUsualHeight_px = 200, kNear_px = 12;
  std::vector<ScreenBox> not_over = blocked;
  for (const world::AgentSnapshot& agent : scene.agents) {
    const world::Vec3 half{0, agent.height_m / 2, 0};
    const auto head = view.Project(agent.position + half), feet = view.Project(agent.position - half);
    if (!head || !feet) continue;
    not_over.push_back({std::min(head->x, feet->x) - kNear_px, std::min(head->y, feet->y) - kNear_px,
                        std::max(head->x, feet->x) + kNear_px, std::max(head->y, feet->y) + kNear_px});
  }
  const ScreenBox area = AreaOfCards(static_cast<float>(engine->width()), static_cast<float>(engine->height()));
  const bool is_known = card.width() > 0;
  const float card_width = is_known ? card.width() : kUsualWidth_px,
              card_height = is_known ? card.height() : kUsualHeight_px;
  card_corner = FreeCorner(card_corner, area, card_width, card_height, not_over);
  card = BoxIn(card_corner, area, card_width, card_height);
}

void Viewer::Impl::DrawWorkspace() {
  const auto help = static_cast<std::size_t>(ViewerCommand::kHelp);
  const std::uint32_t before = selection.empty() ? 0 : selection.front();
  if (workspace->TakeClosesHelp()) on[help] = false;
  workspace->show_help() = on[help];
  const WorkspaceHost::Asked asked = workspace->Draw(scene, status, before, options.hidden ? 0 : frames_per_second,
                                                     [this](ViewerCommand c) { return IsOn(c); });
  on[help] = workspace->show_help();
  if (asked.selected != before) {
    selection.clear();
    if (asked.selected != 0) selection.push_back(asked.selected);
  }
  for (const ViewerCommand command : asked.commands) Do(command);
}

namespace {

/// An empty value, returned if the window has no panels.
template <typename T>
T& Nothing() {
  static T nothing;
  return nothing;
}

}  // namespace

workbench::Contents& Viewer::panel_contents() {
  return impl_->workspace ? impl_->workspace->contents : Nothing<workbench::Contents>();
}

std::vector<workbench::Request> Viewer::TakePanelRequests() {
  return impl_->workspace ? std::exchange(impl_->workspace->requests, {}) : std::vector<workbench::Request>{};
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
  return impl_->workspace ? impl_->workspace->layout() : Nothing<Layout>();
}

UiScriptProgress Viewer::ui_script() const {
  return impl_->workspace ? impl_->workspace->script() : UiScriptProgress{};
}

}  // namespace soarbox::viewer
