// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <bitset>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/backdrop.h"
#include "viewer/fill_batch.h"
#include "viewer/ghost_view.h"
#include "viewer/input_reader.h"
#include "viewer/labels.h"
#include "viewer/light_rig.h"
#include "viewer/line_batch.h"
#include "viewer/overlay_painter.h"
#include "viewer/particle_lines.h"
#include "viewer/render_engine.h"
#include "viewer/render_scale.h"
#include "viewer/scene_view.h"
#include "viewer/script_ui.h"
#include "viewer/sky_view.h"
#include "viewer/sound_player.h"
#include "viewer/viewer.h"
#include "viewer/workspace_host.h"

namespace soarbox::viewer {

/// The parts of a snapshot that are needed to draw again without its owner, and all objects that draw.
struct Viewer::Impl {
  ViewerOptions options;
  // Declared in the order of construction; each uses the members above it.
  std::unique_ptr<Engine> engine;
  std::optional<Shaders> shaders;
  std::optional<Materials> materials;
  std::optional<LightRig> lights;
  std::optional<SkyView> sky;
  std::optional<SceneView> things;
  std::unique_ptr<LineBatch> lines, skeleton_lines;
  std::unique_ptr<FillBatch> fills;
  std::optional<PanelHost> panels;
  std::optional<InputReader> input;
  PanelImages panel_images;
  SoundPlayer sounds;
  ButtonState buttons;                     ///< Of the panels that scripts show.
  std::optional<WorkspaceHost> workspace;  ///< Menus and panels; none: the picture alone.

  std::optional<GhostView> ghost_view;
  std::optional<Backdrop> backdrop;

  CameraRig camera;
  ParticleLines particles;
  std::optional<std::uint32_t> camera_moves;
  std::vector<std::uint32_t> kept;  ///< The agents that the camera keeps in view; empty: all, and the places.
  RecentGround recent_ground;       ///< Of these agents, while the world runs fast.
  world::SceneSnapshot scene;       ///< Without its drawables; agents are at the positions where they are drawn.
  RunStatus status;
  std::vector<InputEvent> events;
  std::vector<ViewerCommand> commands;
  OverlayPainter painter;
  AgentLabels labels;
  std::vector<world::TriangleSnapshot> triangles;  ///< Of the scene.
  std::vector<Ghost> shown_ghosts;                 ///< Those of SetGhosts, and those of overlays.
  world::OverlaySnapshot overlays;
  bool has_overlays = false;
  std::vector<Ghost> ghosts;
  std::vector<debugger::SceneShape> imagined;
  debugger::AnswerLines answer;
  std::vector<std::uint32_t> selection;
  std::uint32_t hovered = 0;
  std::optional<ScreenPoint> cursor;
  std::optional<Picked> box;
  std::bitset<kViewerCommands> on;
  std::string notice;
  float notice_s = 0;  ///< Time for which it is still shown.
  bool has_framed = false;
  std::vector<FramedBody> scenery;  ///< Around the agents; updated while the camera keeps them in view.
  float framed_aspect = 0;  ///< Aspect of the picture when all agents were framed; 0: other agents were framed, or a
                            ///< script moved the camera.
  bool has_walls = false;   ///< The scene contains many pieces of buildings.
  bool failed = false;
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_frame = Clock::now(), last_drawn, awake_until;
  FrameCosts costs;
  int scripted_frames = 0;
  bool shows_news = true;                       ///< Something was shown since the last frame that it did not contain.
  bool stands = false;                          ///< Neither the world nor the camera has moved since the last frame.
  std::vector<world::LineSnapshot> last_marks;  ///< The lines that the last frame drew over the scene.
  std::vector<world::TriangleSnapshot> last_fills;
  std::size_t last_ghosts = 0;
  std::size_t shown_drawables = 0;
  world::CameraSnapshot rested_pose;
  float frames_per_second = 0;
  std::optional<AutoScale> auto_scale;  ///< Finds the largest scale that is fast enough.
  double slept_s = 0;                   ///< Since the last frame began.
  double drawing_s = 0;                 ///< Duration of the last frame.

  Result<void> Build();
  void Show(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend);
  bool Frame();
  bool IsIdle(Clock::time_point now);
  void Apply(const FrameInput& in, float seconds);
  void PlaceCamera();
  void DrawPanels(float seconds);
  void DrawWorkspace();
  void ChooseScale(ViewerCommand command);
  void UseScale(double scale);
  Result<void> SavePicture(const std::filesystem::path& path);
  void ReportFailure(const std::string& what);
  void Do(ViewerCommand command);
  void SelectBeside(int step);
  bool SeesAgentsWell();
  /// Moves the camera to keep agents in view, unless the user has moved it.
  void KeepInView(float seconds);
  std::vector<world::Vec3> Places() const;
  /// The agent whose body or label is at a pixel; 0: none.
  std::uint32_t AgentUnder(ScreenPoint pixel) const;
  void Pick(const Picked& picked);
  /// Removes clicks on buttons of scripts from the input, and reports them as presses of these buttons.
  void TakeButtonClicks(FrameInput& in);
  ScreenRoom Room() const {
    return {static_cast<float>(engine->width()), static_cast<float>(engine->height()),
            static_cast<float>(engine->window_width()), static_cast<float>(engine->window_height())};
  }
  void Frame(const std::vector<std::uint32_t>& agents, bool best_side);
  void SetCamera(CameraMode mode);
  bool IsOn(ViewerCommand command) const;
  /// The agent through whose eyes the camera looks; 0: none.
  std::uint32_t Inside() const { return camera.mode() == CameraMode::kEyes ? camera.agent() : 0; }
  void Notice(std::string text) {
    notice = std::move(text);
    notice_s = 3.5f;
  }
  const world::AgentSnapshot* Find(std::uint32_t agent_id) const;
  const world::AgentSnapshot* Selected() const { return selection.empty() ? nullptr : Find(selection.front()); }
  Projection View() const { return {camera.pose(), engine->width(), engine->height()}; }

  ~Impl() {
    // Ogre's scene must not refer to our objects when the engine ends it.
    if (lines) lines->detachFromParent();
    if (skeleton_lines) skeleton_lines->detachFromParent();
    if (fills) fills->detachFromParent();
  }
};

}  // namespace soarbox::viewer
