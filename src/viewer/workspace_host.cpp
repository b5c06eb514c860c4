// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/workspace_host.h"

#include <SDL.h>
#include <imgui_internal.h>

#include <algorithm>
#include <iostream>

#include "viewer/panels/layout_audit.h"
#include "viewer/panels/widgets.h"

namespace soarbox::viewer {
namespace {

/// Moves a draw list with its clipping rectangles.
void Shift(ImDrawList& list, float x, float y) {
  for (ImDrawVert& corner : list.VtxBuffer) corner.pos = {corner.pos.x + x, corner.pos.y + y};
  for (ImDrawCmd& command : list.CmdBuffer) {
    command.ClipRect = {command.ClipRect.x + x, command.ClipRect.y + y, command.ClipRect.z + x, command.ClipRect.w + y};
  }
}

}  // namespace

WorkspaceHost::WorkspaceHost(Engine& engine, PanelHost& host, workbench::PanelExchange& panels, const Layout& layout)
    : engine_(engine), host_(host), panels_(panels), workspace_(layout) {}

Result<void> WorkspaceHost::LoadScript(const std::filesystem::path& file, std::size_t from) {
  if (file.empty()) return {};
  Result<UiScript> script = UiScript::Load(file);
  if (!script) return script.error();
  script_ = std::move(*script);
  script_->Skip(from);
  return {};
}

void WorkspaceHost::PlacePicture() {
  host_.SetTextScale(static_cast<float>(workspace_.layout.text_percent) / 100);
  host_.SetLight(workspace_.layout.light);
  picture_ = workspace_.PictureIn(engine_.window_width(), engine_.window_height());
  engine_.SetPicture(picture_.x, picture_.y, picture_.width, picture_.height);
  input_.SetPicture(picture_.x, picture_.y, picture_.width, picture_.height, workspace_.IsModal());
  const PictureRect cover = workspace_.cover();
  input_.SetCover(cover.x, cover.y, cover.width, cover.height);
}

bool WorkspaceHost::TakeShortcut(const SDL_Event& event) {
  if (event.type != SDL_KEYDOWN) return false;
  const bool control = (event.key.keysym.mod & KMOD_CTRL) != 0;
  Layout& layout = workspace_.layout;
  if ((event.key.keysym.mod & KMOD_LALT) != 0 && !control) {
    for (const workbench::PanelInfo& info : workbench::kPanelInfos) {
      if (event.key.keysym.scancode != SDL_SCANCODE_A + (info.key - 'A')) continue;
      workspace_.Open(info.id);
      return true;
    }
    return false;
  }
  switch (event.key.keysym.scancode) {
    case SDL_SCANCODE_ESCAPE:
      // Esc first closes what is over the picture, then the window.
      if (workspace_.StayOpen() || workspace_.CloseFinder()) return true;
      if (!workspace_.IsModal() && input_.has_keys()) {
        input_.LeaveField();
        return true;
      }
      if (!workspace_.IsModal()) return event.key.repeat != 0 || !IsSecondEscape();
      workspace_.show_help = false;
      ImGui::ClosePopupsOverWindow(nullptr, false);
      return true;
    case SDL_SCANCODE_P:
      if (!control || (event.key.keysym.mod & KMOD_SHIFT) == 0) return false;
      workspace_.Find(Finder::For::kAnything);
      return true;
    case SDL_SCANCODE_O:
      if (!control) return false;
      workspace_.Find((event.key.keysym.mod & KMOD_SHIFT) != 0 ? Finder::For::kRecording : Finder::For::kScenario);
      return true;
    case SDL_SCANCODE_F11:
      workspace_.only_picture = !workspace_.only_picture;
      return true;
    case SDL_SCANCODE_F:
      if (control) workspace_.FocusField();
      return control;
    case SDL_SCANCODE_C:
      if (!control || input_.has_keys()) return false;  // A field copies its selected text.
      workspace_.CopyPanel();
      return true;
    case SDL_SCANCODE_EQUALS:
    case SDL_SCANCODE_KP_PLUS:
      if (control) layout.SetText(layout.text_percent + 25);
      return control;
    case SDL_SCANCODE_MINUS:
    case SDL_SCANCODE_KP_MINUS:
      if (control) layout.SetText(layout.text_percent - 25);
      return control;
    case SDL_SCANCODE_0:
      if (control) layout.SetText(100);
      return control;
    default:
      return false;
  }
}

bool WorkspaceHost::IsSecondEscape() {
  constexpr auto kSoon = std::chrono::milliseconds(2500);
  const auto now = std::chrono::steady_clock::now();
  if (now - std::exchange(escaped_at_, now) < kSoon) return true;
  panels_.requests.emplace_back(workbench::TellRequest{"Press Esc again to close the window"});
  return false;
}

InputClaims WorkspaceHost::Claims() {
  InputClaims claims;
  claims.takes = [this](SDL_Event& event) { return TakeShortcut(event) || input_.Take(event); };
  claims.mouse = input_.has_mouse();
  claims.keys = input_.has_keys();
  claims.arrows = ListTakesArrows();
  return claims;
}

void WorkspaceHost::BeginPicture() {
  // Code that draws over the scene sees only the picture.
  const ImVec2 size{static_cast<float>(picture_.width), static_cast<float>(picture_.height)};
  ImGui::GetIO().DisplaySize = size;
  ImGui::GetBackgroundDrawList()->PushClipRect({0, 0}, size);
  ImGui::GetForegroundDrawList()->PushClipRect({0, 0}, size);
}

void WorkspaceHost::EndPicture() {
  for (ImDrawList* list : {ImGui::GetBackgroundDrawList(), ImGui::GetForegroundDrawList()}) {
    list->PopClipRect();
    Shift(*list, static_cast<float>(picture_.x), static_cast<float>(picture_.y));
    if (list->CmdBuffer.back().ElemCount == 0) {
      list->CmdBuffer.back().ClipRect = list->_CmdHeader.ClipRect;
    } else {
      list->AddDrawCmd();
    }
  }
  ImGui::GetIO().DisplaySize = {static_cast<float>(engine_.window_width()),
                                static_cast<float>(engine_.window_height())};
}

WorkspaceHost::Asked WorkspaceHost::Draw(const world::SceneSnapshot& scene, const RunStatus& status,
                                         std::uint32_t selected, float frames_per_second,
                                         const std::function<bool(ViewerCommand)>& is_on) {
  Asked asked;
  asked.selected = selected;
  PanelFrame frame{panels_.contents,
                   scene,
                   status,
                   {host_.panel_font(), host_.bold_font(), host_.mono_font()},
                   static_cast<float>(workspace_.layout.text_percent) / 100,
                   workspace_.layout,
                   asked.selected,
                   panels_.requests,
                   asked.commands,
                   is_on};
  meter_.BeginPanels();
  workspace_.Draw(frame, engine_.window_width(), engine_.window_height(), frames_per_second);
  meter_.EndPanels();
  return asked;
}

std::optional<ImVec2> WorkspaceHost::PlaceOf(const Drawn& drawn, const std::string& name) const {
  const auto& agents = drawn.scene.agents;
  const auto agent = std::find_if(agents.begin(), agents.end(), [&](const auto& a) { return a.name == name; });
  if (agent == agents.end()) return std::nullopt;
  const auto try_at = [&](ScreenPoint at) -> std::optional<ImVec2> {
    const ImVec2 place{at.x + static_cast<float>(picture_.x), at.y + static_cast<float>(picture_.y)};
    const PictureRect cover = workspace_.cover();
    const bool is_free = picture_.Holds(place.x, place.y) && !cover.Holds(place.x, place.y);
    if (!is_free || drawn.agent_at(at) != agent->id) return std::nullopt;
    return place;
  };
  // Its centre if that is visible; else a part that is not hidden.
  const world::Vec3 beside = Rotate(drawn.camera.orientation, {agent->radius_m, 0, 0});
  for (const float across : {0.0f, -0.5f, 0.5f, -0.9f, 0.9f}) {
    for (const float up : {0.0f, 0.25f, 0.45f, -0.25f, -0.45f}) {
      const auto at = drawn.view.Project(agent->position + beside * across + world::Vec3{0, up * agent->height_m, 0});
      if (!at) continue;
      if (const auto place = try_at(*at)) return place;
    }
  }
  for (const ShownLabel& label : drawn.labels) {
    if (label.agent_id != agent->id) continue;
    if (const auto place = try_at({(label.box.left + label.box.right) / 2, (label.box.top + label.box.bottom) / 2}))
      return place;
  }
  return std::nullopt;
}

void WorkspaceHost::AfterDrawing(const Drawn& drawn) {
  input_.ShowCursor();
  const ImDrawData* data = ImGui::GetDrawData();
  if (!script_ || script_->is_over() || data == nullptr) return;
  meter_.NoteDrawn();
  const std::vector<ShownText> shown = CaptureText(*data, *ImGui::GetIO().Fonts);
  UiStage stage{shown,
                drawn.scene.tick,
                drawn.scene.time_s,
                input_.idle(),
                [&](const std::string& agent) { return PlaceOf(drawn, agent); },
                {},
                drawn.save_picture,
                [] { return AuditLayout(*ImGui::GetIO().Fonts); },
                [&](const std::string& name) { std::cout << meter_.Read(name, drawn.scene.time_s) << std::endl; }};
  for (const world::AgentSnapshot& agent : drawn.scene.agents) {
    if (agent.id == drawn.selected) stage.selected = agent.name;
  }
  script_->Advance(stage);
}

UiScriptProgress WorkspaceHost::script() const {
  if (!script_) return {};
  return {script_->is_over(), script_->at(), script_->failure()};
}

}  // namespace soarbox::viewer
