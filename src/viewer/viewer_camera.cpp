// SPDX-License-Identifier: BSD-2-Clause
// The camera of the window: which agents it frames, follows and keeps in view.
#include <algorithm>
#include <cmath>

#include "viewer/viewer_impl.h"

namespace soarbox::viewer {

void Viewer::Impl::Frame(const std::vector<std::uint32_t>& agents, bool best_side) {
  std::vector<const world::AgentSnapshot*> framed;
  for (const auto& agent : scene.agents) {
    const bool wanted = agents.empty() || std::find(agents.begin(), agents.end(), agent.id) != agents.end();
    if (wanted && world::IsFinite(agent.position)) framed.push_back(&agent);
  }
  const float aspect = static_cast<float>(engine->width()) / static_cast<float>(engine->height());
  const bool are_all = agents.empty();
  framed_aspect = are_all ? aspect : 0;
  const std::vector<world::Vec3> places = are_all ? Places() : std::vector<world::Vec3>{};
  camera.Frame(framed, aspect, best_side, places, best_side && has_walls,
               are_all && !has_walls ? scenery : std::vector<FramedBody>{});
  if (framed.empty()) return;
  kept = agents;
  camera.BeginKeeping();
}

std::vector<world::Vec3> Viewer::Impl::Places() const {
  std::vector<world::Vec3> places;
  for (const world::PlaceSnapshot& place : overlays.places) {
    if (place.kind != world::PlaceSnapshot::Kind::kThing) places.push_back(place.position);
  }
  return places;
}

void Viewer::Impl::KeepInView(float seconds) {
  if (!camera.keeps()) return;
  std::vector<FramedBody> living, all;
  // The camera uses wall time, agents use simulated time. Above this speed, their velocity means little.
  constexpr double kFast = 4;
  const bool is_fast = !status.paused && status.speed > kFast;
  const auto pace = static_cast<float>(status.paused || is_fast ? 0 : status.speed);
  for (const auto& agent : scene.agents) {
    const bool wanted = kept.empty() || std::find(kept.begin(), kept.end(), agent.id) != kept.end();
    if (!wanted || !world::IsFinite(agent.position)) continue;
    const FramedBody body{agent.position, agent.velocity * pace, agent.radius_m, agent.height_m};
    all.push_back(body);
    if (agent.alive) living.push_back(body);
  }
  const float aspect = static_cast<float>(engine->width()) / static_cast<float>(engine->height());
  std::vector<FramedBody>& framed = living.empty() ? all : living;
  if (is_fast) {
    recent_ground.Note(framed, seconds);
    recent_ground.AddTo(framed);
  } else {
    recent_ground.Forget();
  }
  if (!kept.empty()) return camera.Keep(framed, {}, aspect, seconds);
  // Opening and closing panels changes the aspect of the picture.
  constexpr float kOtherShape = 0.05f;
  if (framed_aspect > 0 && std::abs(aspect / framed_aspect - 1) > kOtherShape) Frame({}, false);
  const std::vector<world::Vec3> places = Places();
  camera.Keep(framed, places, aspect, seconds, has_walls ? std::vector<FramedBody>{} : scenery);
}

void Viewer::Impl::SetCamera(CameraMode mode) {
  // The key of kFollow also ends that mode.
  if (mode == CameraMode::kFollow && camera.mode() == mode && Selected() != nullptr && camera.agent() == Selected()->id)
    mode = CameraMode::kFree;
  const bool needs_agent = mode == CameraMode::kFollow || mode == CameraMode::kEyes;
  if (needs_agent && Selected() == nullptr) {
    // If nothing is selected, chooses a living agent.
    const auto living = std::find_if(scene.agents.begin(), scene.agents.end(), [](const auto& a) { return a.alive; });
    if (living != scene.agents.end()) selection = {living->id};
  }
  if (!camera.SetMode(mode, Selected())) Notice("There is no agent to follow");
}

/// Whether all agents are in the picture and large enough, so that the script's view is good.
bool Viewer::Impl::SeesAgentsWell() {
  constexpr float kSmallest = 0.07f;  // Fraction of the picture's height.
  const auto width = static_cast<float>(engine->width()), height = static_cast<float>(engine->height());
  camera.Arrive();
  const Projection view = View();
  const auto is_in_picture = [&](const std::optional<ScreenPoint>& at) {
    return at && at->x > 0 && at->x < width && at->y > 0 && at->y < height;
  };
  if (!std::ranges::all_of(scenery, [&](const FramedBody& body) { return is_in_picture(view.Project(body.position)); }))
    return false;
  return std::all_of(scene.agents.begin(), scene.agents.end(), [&](const world::AgentSnapshot& agent) {
    const world::Vec3 half{0, agent.height_m / 2, 0};
    const auto head = view.Project(agent.position + half), feet = view.Project(agent.position - half);
    return is_in_picture(head) && is_in_picture(feet) && feet->y - head->y > kSmallest * height;
  });
}

void Viewer::Impl::PlaceCamera() {
  const world::CameraSnapshot& pose = camera.pose();
  engine->camera_node().setPosition(ToOgre(pose.position));
  engine->camera_node().setOrientation(ToOgre(pose.orientation));
  engine->camera().setFOVy(Ogre::Degree(pose.vertical_fov_deg));
  sky->Follow(ToOgre(pose.position));
}

}  // namespace soarbox::viewer
