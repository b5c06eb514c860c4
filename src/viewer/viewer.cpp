// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/viewer.h"

#include <algorithm>
#include <bitset>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>
#include <optional>
#include <thread>

#include "viewer/backdrop.h"
#include "viewer/engine.h"
#include "viewer/fill_batch.h"
#include "viewer/ghost_view.h"
#include "viewer/input_reader.h"
#include "viewer/interpolate.h"
#include "viewer/labels.h"
#include "viewer/light_rig.h"
#include "viewer/line_batch.h"
#include "viewer/overlay_painter.h"
#include "viewer/panels.h"
#include "viewer/particle_lines.h"
#include "viewer/picture_notes.h"
#include "viewer/render_scale.h"
#include "viewer/scene_view.h"
#include "viewer/script_ui.h"
#include "viewer/sky_view.h"
#include "viewer/workspace_host.h"

namespace soarbox::viewer {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr float kLineWidth_px = 2.2f;

/// Where the media are unless the application says so: beside an installed program, else where the build had them.
fs::path DefaultMediaDir() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (!error) {
    const fs::path installed = program.parent_path().parent_path() / "share/soarbox/media";
    if (fs::exists(installed / "shaders", error)) return installed;
  }
  return SOARBOX_MEDIA_DIR;
}

/// Adds the processor time of this thread from one call to the next to a sum.
class Stopwatch {
 public:
  void Lap(double& sum_s) {
    const double now = Now();
    sum_s += now - last_s_;
    last_s_ = now;
  }

 private:
  static double Now() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  }
  double last_s_ = Now();
};

bool Same(const std::vector<world::LineSnapshot>& a, const std::vector<world::LineSnapshot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.from == other.from && one.to == other.to && one.color == other.color;
  });
}

bool Same(const std::vector<world::TriangleSnapshot>& a, const std::vector<world::TriangleSnapshot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& one, const auto& other) {
    return one.a == other.a && one.b == other.b && one.c == other.c && one.color == other.color;
  });
}

/// A ring on the ground around a selected agent; the first one's is bright.
void AddRing(const world::AgentSnapshot& agent, bool is_first, std::vector<world::LineSnapshot>& out) {
  constexpr int kPieces = 40;
  const world::Color color = is_first ? world::Color{1.0f, 0.86f, 0.35f, 1} : world::Color{1.0f, 0.92f, 0.70f, 0.75f};
  const float radius = std::max(agent.radius_m * 1.5f, 0.55f), y = agent.position.y - agent.height_m / 2 + 0.06f;
  const auto point = [&](int i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kPieces;
    return world::Vec3{agent.position.x + radius * std::cos(angle), y, agent.position.z + radius * std::sin(angle)};
  };
  for (int i = 0; i < kPieces; ++i) out.push_back({point(i), point(i + 1), color});
}

}  // namespace

/// What of a snapshot is needed to draw again without its owner, and everything that draws.
struct Viewer::Impl {
  ViewerOptions options;
  // Declared in the order of construction; each uses what stands above it.
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
  std::optional<WorkspaceHost> workspace;  ///< Menus and panels; none: the picture alone.

  std::optional<GhostView> ghost_view;
  std::optional<Backdrop> backdrop;

  CameraRig camera;
  ParticleLines particles;
  std::optional<std::uint32_t> camera_moves;
  std::vector<std::uint32_t> kept;  ///< Whom the camera keeps in view; empty: all, and the places.
  RecentGround recent_ground;       ///< Of those, while the world runs fast.
  world::SceneSnapshot scene;       ///< Without its drawables; agents stand where they are drawn.
  RunStatus status;
  std::vector<InputEvent> events;
  std::vector<ViewerCommand> commands;
  OverlayPainter painter;
  AgentLabels labels;
  ScreenBox card;  ///< Where the selected agent's card stood in the last frame.
  Corner card_corner = Corner::kBottomLeft;
  std::vector<world::TriangleSnapshot> triangles;  ///< Of the scene.
  std::vector<Ghost> shown_ghosts;                 ///< Those asked for, and those of overlays.
  world::OverlaySnapshot overlays;
  bool has_overlays = false;
  std::vector<Ghost> ghosts;
  std::vector<std::uint32_t> selection;
  std::uint32_t hovered = 0;
  std::optional<ScreenPoint> cursor;
  std::optional<Picked> box;
  std::bitset<kViewerCommands> on;
  std::string notice;
  float notice_s = 0;  ///< For how long it is still shown.
  bool has_framed = false;
  bool has_walls = false;  ///< The scene is full of pieces of buildings.
  bool failed = false;
  Clock::time_point last_frame = Clock::now(), last_drawn, awake_until;
  FrameCosts costs;
  int scripted_frames = 0;
  bool shows_news = true;                       ///< Something else was shown since the last frame.
  bool stands = false;                          ///< Neither the world nor the camera has moved since the last frame.
  std::vector<world::LineSnapshot> last_marks;  ///< What the last frame drew over the scene.
  std::vector<world::TriangleSnapshot> last_fills;
  std::size_t last_ghosts = 0;
  std::size_t shown_drawables = 0;
  world::CameraSnapshot rested_pose;
  float frames_per_second = 0;
  std::optional<AutoScale> auto_scale;  ///< Looks for the largest scale that is fast enough.
  double slept_s = 0;                   ///< Since the last frame began.
  double drawing_s = 0;                 ///< What the last frame took.

  Result<void> Build();
  void Show(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend);
  bool Frame();
  bool IsIdle(Clock::time_point now);
  void Apply(const FrameInput& in, float seconds);
  void PlaceCamera();
  void DrawPanels(float seconds);
  void DrawWorkspace();
  /// Moves the selected agent's card to where it hides nobody.
  void PlaceCard(const Projection& view, const std::vector<ScreenBox>& blocked);
  void ChooseScale(ViewerCommand command);
  void UseScale(double scale);
  Result<void> SavePicture(const fs::path& path);
  void ReportFailure(const std::string& what);
  void Do(ViewerCommand command);
  void SelectBeside(int step);
  bool SeesAgentsWell();
  /// Lets the camera follow what happens, while it is not the user's.
  void KeepInView(float seconds);
  std::vector<world::Vec3> Places() const;
  /// The agent whose body or label is there; 0: none.
  std::uint32_t AgentUnder(ScreenPoint pixel) const;
  void Pick(const Picked& picked);
  void Frame(const std::vector<std::uint32_t>& agents, bool best_side);
  void SetCamera(CameraMode mode);
  bool IsOn(ViewerCommand command) const;
  /// The agent whose eyes the camera looks out of; 0: none.
  std::uint32_t Inside() const { return camera.mode() == CameraMode::kEyes ? camera.agent() : 0; }
  void Notice(std::string text) {
    notice = std::move(text);
    notice_s = 3.5f;
  }
  const world::AgentSnapshot* Find(std::uint32_t agent_id) const;
  const world::AgentSnapshot* Selected() const { return selection.empty() ? nullptr : Find(selection.front()); }
  Projection View() const { return {camera.pose(), engine->width(), engine->height()}; }

  ~Impl() {
    // Ogre's scene must not hold what we own when the engine takes it down.
    if (lines) lines->detachFromParent();
    if (skeleton_lines) skeleton_lines->detachFromParent();
    if (fills) fills->detachFromParent();
  }
};

Result<void> Viewer::Impl::Build() {
  const fs::path media = options.media_dir.empty() ? DefaultMediaDir() : options.media_dir;
  auto loaded = Shaders::Load(media / "shaders", engine->low_detail());
  if (!loaded) return loaded.error();
  shaders = *loaded;
  Ogre::SceneManager& scene_manager = engine->scene();
  materials.emplace(*shaders, engine->low_detail());
  lights.emplace(scene_manager, *shaders, materials->ShadowCaster(), engine->low_detail());
  sky.emplace(scene_manager, *materials);
  things.emplace(scene_manager, *materials, engine->low_detail() ? 0.45f : 1.0f, options.on_diagnostic);
  lines = std::make_unique<LineBatch>(materials->LineMaterial(kLineWidth_px));
  ghost_view.emplace(scene_manager, *materials);
  backdrop.emplace(scene_manager, *materials);
  skeleton_lines = std::make_unique<LineBatch>(materials->LineMaterial(kLineWidth_px, true));
  fills = std::make_unique<FillBatch>(materials->FillMaterial());
  scene_manager.getRootSceneNode()->createChildSceneNode()->attachObject(lines.get());
  scene_manager.getRootSceneNode()->createChildSceneNode()->attachObject(skeleton_lines.get());
  scene_manager.getRootSceneNode()->createChildSceneNode()->attachObject(fills.get());
  engine->PrepareScaling(*materials);
  UseScale(1);
  if (options.render_scale > 0)
    UseScale(std::clamp(options.render_scale, 0.5, 1.0));
  else
    ChooseScale(ViewerCommand::kScaleAuto);
  panels.emplace(*materials);
  input.emplace(engine->window());
  if (options.layout) {
    workspace.emplace(*engine, *panels, *options.layout);
    if (Result<void> read = workspace->LoadScript(options.ui_script, options.ui_script_from); !read)
      return read.error();
    workspace->PlacePicture();
  }
  return {};
}

const world::AgentSnapshot* Viewer::Impl::Find(std::uint32_t agent_id) const {
  for (const auto& agent : scene.agents) {
    if (agent.id == agent_id) return &agent;
  }
  return nullptr;
}

void Viewer::Impl::Frame(const std::vector<std::uint32_t>& agents, bool best_side) {
  std::vector<const world::AgentSnapshot*> framed;
  for (const auto& agent : scene.agents) {
    const bool wanted = agents.empty() || std::find(agents.begin(), agents.end(), agent.id) != agents.end();
    if (wanted && world::IsFinite(agent.position)) framed.push_back(&agent);
  }
  const float aspect = static_cast<float>(engine->width()) / static_cast<float>(engine->height());
  camera.Frame(framed, aspect, best_side, agents.empty() ? Places() : std::vector<world::Vec3>{},
               best_side && has_walls);
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
  // The camera goes by the user's clock, agents by that of the world: faster than this, their velocity says little.
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
  camera.Keep(framed, kept.empty() ? Places() : std::vector<world::Vec3>{}, aspect, seconds);
}

void Viewer::Impl::SetCamera(CameraMode mode) {
  // The key of the mode that follows also ends it.
  if (mode == CameraMode::kFollow && camera.mode() == mode && Selected() != nullptr && camera.agent() == Selected()->id)
    mode = CameraMode::kFree;
  const bool needs_agent = mode == CameraMode::kFollow || mode == CameraMode::kEyes;
  if (needs_agent && Selected() == nullptr) {
    // Without a wish, somebody who lives.
    const auto living = std::find_if(scene.agents.begin(), scene.agents.end(), [](const auto& a) { return a.alive; });
    if (living != scene.agents.end()) selection = {living->id};
  }
  if (!camera.SetMode(mode, Selected())) Notice("There is no agent to go along with");
}

void Viewer::Impl::SelectBeside(int step) {
  if (scene.agents.empty()) return;
  const auto count = static_cast<int>(scene.agents.size());
  int at = step > 0 ? -1 : 0;
  for (int i = 0; i < count; ++i) {
    if (Selected() == &scene.agents[static_cast<std::size_t>(i)]) at = i;
  }
  selection = {scene.agents[static_cast<std::size_t>((at + step + count) % count)].id};
  if (camera.agent() != 0) camera.SetMode(camera.mode(), Selected());
}

std::uint32_t Viewer::Impl::AgentUnder(ScreenPoint pixel) const {
  const std::uint32_t named = labels.AgentAt(pixel);
  return named != 0 ? named : View().AgentAt(pixel, scene.agents);
}

void Viewer::Impl::Pick(const Picked& picked) {
  std::vector<std::uint32_t> found;
  if (picked.is_box) {
    found = View().AgentsIn(picked.from, picked.to, scene.agents);
  } else if (const std::uint32_t agent = AgentUnder(picked.from); agent != 0) {
    found.push_back(agent);
  }
  if (picked.is_double) {
    if (!found.empty())
      Frame(found, false);
    else
      camera.GoTo(View().RayThrough(picked.from));
    return;
  }
  if (!picked.adds) {
    // The ground is nobody: panels stay with whom they are about.
    if (!found.empty()) selection = std::move(found);
    return;
  }
  for (const std::uint32_t agent : found) {
    const auto there = std::find(selection.begin(), selection.end(), agent);
    if (there == selection.end()) {
      selection.push_back(agent);
    } else if (!picked.is_box) {
      selection.erase(there);
    }
  }
}

void Viewer::Impl::Do(ViewerCommand command) {
  if (IsOfRun(command)) {
    if (command == ViewerCommand::kQuit && workspace && !workspace->MayClose()) return;
    commands.push_back(command);
    return;
  }
  if (IsOverlay(command)) {
    on.flip(static_cast<std::size_t>(command));
    const bool is_on = IsOn(command);
    // Names, trails and forces come with every scene.
    const bool needs_more =
        command != ViewerCommand::kLabels && command != ViewerCommand::kTrails && command != ViewerCommand::kForces;
    const std::string title(InfoOf(command).title);
    if (is_on && needs_more && !has_overlays) {
      Notice(title + ": not available here; a recording does not hold it");
    } else if (is_on && command == ViewerCommand::kBelief && Selected() == nullptr) {
      Notice("Belief: select an agent to see the world as it believes it to be");
    } else {
      Notice(title + (is_on ? " on" : " off"));
    }
    return;
  }
  switch (command) {
    case ViewerCommand::kFrameSelection:
    case ViewerCommand::kFrameAll:
      if (camera.mode() == CameraMode::kOrbit) camera.SetMode(CameraMode::kFree, nullptr);
      Frame(command == ViewerCommand::kFrameAll ? std::vector<std::uint32_t>{} : selection, false);
      break;
    case ViewerCommand::kFreeCamera:
      SetCamera(CameraMode::kFree);
      break;
    case ViewerCommand::kOrbitCamera:
      SetCamera(CameraMode::kOrbit);
      break;
    case ViewerCommand::kFollowCamera:
      SetCamera(CameraMode::kFollow);
      break;
    case ViewerCommand::kEyesCamera:
      SetCamera(CameraMode::kEyes);
      break;
    case ViewerCommand::kMapCamera:
      SetCamera(CameraMode::kMap);
      Frame({}, false);
      break;
    case ViewerCommand::kSelectNext:
      SelectBeside(1);
      break;
    case ViewerCommand::kSelectPrevious:
      SelectBeside(-1);
      break;
    case ViewerCommand::kSelectNone:
      selection.clear();
      break;
    case ViewerCommand::kHelp:
      on.flip(static_cast<std::size_t>(command));
      break;
    case ViewerCommand::kScaleAuto:
    case ViewerCommand::kScaleFull:
    case ViewerCommand::kScaleThreeQuarters:
    case ViewerCommand::kScaleHalf:
      ChooseScale(command);
      break;
    default:
      break;
  }
}

void Viewer::Impl::ChooseScale(ViewerCommand command) {
  constexpr double kUsualLow = 0.75;
  for (const auto each : {ViewerCommand::kScaleAuto, ViewerCommand::kScaleFull, ViewerCommand::kScaleThreeQuarters,
                          ViewerCommand::kScaleHalf}) {
    on[static_cast<std::size_t>(each)] = each == command;
  }
  auto_scale.reset();
  if (command == ViewerCommand::kScaleAuto) {
    // A script that plays a user has its pictures alike everywhere.
    if (engine->in_software() && options.ui_script.empty()) auto_scale.emplace();
    UseScale(auto_scale ? auto_scale->scale() : engine->low_detail() && !options.hidden ? kUsualLow : 1);
  } else {
    UseScale(command == ViewerCommand::kScaleFull ? 1 : command == ViewerCommand::kScaleHalf ? 0.5 : 0.75);
  }
}

void Viewer::Impl::UseScale(double scale) {
  engine->SetScale(scale);
  shaders->scene_values().setNamedConstant("line_scale", Ogre::Vector4(static_cast<float>(scale), 0, 0, 0));
}

bool Viewer::Impl::IsOn(ViewerCommand command) const {
  switch (command) {
    case ViewerCommand::kFreeCamera:
      return camera.mode() == CameraMode::kFree;
    case ViewerCommand::kOrbitCamera:
      return camera.mode() == CameraMode::kOrbit;
    case ViewerCommand::kFollowCamera:
      return camera.mode() == CameraMode::kFollow;
    case ViewerCommand::kEyesCamera:
      return camera.mode() == CameraMode::kEyes;
    case ViewerCommand::kMapCamera:
      return camera.mode() == CameraMode::kMap;
    case ViewerCommand::kTogglePause:
      return status.paused;
    case ViewerCommand::kUnlimited:
      return std::isinf(status.speed);
    default:
      return on[static_cast<std::size_t>(command)];
  }
}

void Viewer::Impl::ReportFailure(const std::string& what) {
  failed = true;
  if (!options.on_diagnostic) return;
  Diagnostic error;
  error.message = "the renderer failed: " + what;
  error.hint = "run without a window (--headless), or look at the renderer's log";
  options.on_diagnostic(error);
}

void Viewer::Impl::Show(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend) {
  things->Update(newest, previous, blend);
  if (newest.drawables.size() != shown_drawables) backdrop->Show(newest);
  shown_drawables = newest.drawables.size();
  shows_news |= newest.tick != scene.tick || newest.camera_moves != camera_moves;
  if (lights->Update(newest)) materials->UseFurtherLights();
  lights->SetSkyRotation(newest.sky_rotation_deg);
  if (!sky->Show(newest.sky)) things->WarnOnce("sky", newest.sky, "clouds over water stand in for it");

  // Pictures are taken of a camera that had the time that it has in a window.
  const auto passed_s = static_cast<float>(newest.time_s - scene.time_s);
  scene.tick = newest.tick;
  scene.time_s = newest.time_s;
  scene.ui = newest.ui;
  scene.markup_palette = newest.markup_palette;
  scene.agents = newest.agents;
  scene.lines = newest.lines;
  world::AppendLines(newest.circles, scene.lines);
  particles.AddLines(newest, scene.lines);
  triangles = newest.triangles;
  painter.Note(newest);
  if (previous != nullptr && blend < 1) {
    // Agents keep their order; new ones stand at the end.
    std::size_t i = 0;
    for (auto& agent : scene.agents) {
      while (i < previous->agents.size() && previous->agents[i].id != agent.id) ++i;
      if (i == previous->agents.size()) break;
      agent.position = BetweenPositions(previous->agents[i].position, agent.position, blend);
    }
  }
  if (camera_moves != newest.camera_moves) {
    camera_moves = newest.camera_moves;
    camera.MoveTo(newest.camera);
  }
  if (options.hidden && passed_s > 0) {
    KeepInView(passed_s);
    camera.Update({}, passed_s, camera.agent() != 0 ? Find(camera.agent()) : nullptr,
                  static_cast<float>(engine->height()));
  }
  if (options.frame_agents && !has_framed && !scene.agents.empty()) {
    has_framed = true;
    // Among many pieces of buildings, agents are seen from above only.
    constexpr std::ptrdiff_t kManyPieces = 40;
    has_walls = kManyPieces < std::count_if(
                                  newest.drawables.begin(), newest.drawables.end(),
                                  [](const auto& drawable) {
                                    return !drawable.belongs_to_agent && drawable.shape == world::ShapeKind::kMesh;
                                  });
    if (newest.camera_moves == 0 || has_walls || !SeesAgentsWell()) Frame({}, true);
    camera.Arrive();
    camera.BeginKeeping();
  }
}

/// Whether all agents are in the picture and large enough to be made out: then a script has chosen its view well.
bool Viewer::Impl::SeesAgentsWell() {
  constexpr float kSmallest = 0.07f;  // Of the picture's height.
  const auto width = static_cast<float>(engine->width()), height = static_cast<float>(engine->height());
  camera.Arrive();
  const Projection view = View();
  return std::all_of(scene.agents.begin(), scene.agents.end(), [&](const world::AgentSnapshot& agent) {
    const world::Vec3 half{0, agent.height_m / 2, 0};
    const auto head = view.Project(agent.position + half), feet = view.Project(agent.position - half);
    return head && feet && head->x > 0 && head->x < width && head->y > kStatusBar_px && feet->y < height &&
           feet->y - head->y > kSmallest * height;
  });
}

void Viewer::Impl::Apply(const FrameInput& in, float seconds) {
  events.insert(events.end(), in.events.begin(), in.events.end());
  for (const Picked& picked : in.picked) Pick(picked);
  for (const ViewerCommand command : in.commands) Do(command);
  if (in.new_width > 0) engine->Resize(in.new_width, in.new_height);
  cursor = in.cursor;
  box = in.box;
  CameraInput steer = in.camera;
  if (cursor) steer.towards = View().RayThrough(*cursor);
  const bool kept_before = camera.keeps();
  KeepInView(seconds);
  camera.Update(steer, seconds, camera.agent() != 0 ? Find(camera.agent()) : nullptr,
                static_cast<float>(engine->height()));
  if (options.hidden) camera.Arrive();
  if (kept_before && !camera.keeps()) Notice("The camera is yours; Home gives it back");
  hovered = cursor ? AgentUnder(*cursor) : 0;
  notice_s = std::max(0.0f, notice_s - seconds);
}

void Viewer::Impl::PlaceCamera() {
  const world::CameraSnapshot& pose = camera.pose();
  engine->camera_node().setPosition(ToOgre(pose.position));
  engine->camera_node().setOrientation(ToOgre(pose.orientation));
  engine->camera().setFOVy(Ogre::Degree(pose.vertical_fov_deg));
  sky->Follow(ToOgre(pose.position));
}

void Viewer::Impl::DrawPanels(float seconds) {
  if (workspace) workspace->ApplyInput();
  panels->BeginFrame(engine->window_width(), engine->window_height(), seconds);
  if (workspace) workspace->BeginPicture();
  const Projection view = View();
  const std::uint32_t inside = Inside();
  LabelScene wanted{scene.agents, overlays, selection, hovered, inside, shown_ghosts};
  wanted.names = IsOn(ViewerCommand::kLabels);
  wanted.speech = IsOn(ViewerCommand::kMessages);
  std::vector<ScreenBox> blocked = BoxesOfScriptUi(scene);
  if (!workspace) {
    wanted.top_px = options.show_status_bar ? kStatusBar_px : 0;
    if (Selected() != nullptr) {
      PlaceCard(view, blocked);
      blocked.push_back(card);
    }
  }
  wanted.blocked = blocked;
  labels.Draw(panels->bold_font(), panels->panel_font(), wanted, camera.pose(), view);
  DrawScriptUi(scene, view, *panels);
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

/// Whether the last frame still shows all there is to see; then a moment is spent waiting for the user.
bool Viewer::Impl::IsIdle(Clock::time_point now) {
  constexpr auto kSettles = std::chrono::milliseconds(500), kAtLeastEvery = std::chrono::milliseconds(500);
  constexpr int kWait_ms = 20;
  const bool can_rest = !options.hidden && options.ui_script.empty() && status.paused && !shows_news && notice_s <= 0;
  shows_news = false;
  const world::CameraSnapshot& pose = camera.pose();
  stands = can_rest && pose.position == rested_pose.position && pose.orientation == rested_pose.orientation &&
           pose.vertical_fov_deg == rested_pose.vertical_fov_deg;
  rested_pose = pose;
  if (!stands || engine->HasInput(0)) {
    awake_until = now + kSettles;
    return false;
  }
  if (now < awake_until || now - last_drawn > kAtLeastEvery) return false;
  return !engine->HasInput(kWait_ms);
}

bool Viewer::Impl::Frame() {
  const Clock::time_point now = Clock::now();
  const float seconds = std::chrono::duration<float>(now - last_frame).count();
  last_frame = now;
  if (seconds > 0) {
    const float rate = 1 / std::max(seconds, 1e-3f);
    frames_per_second = frames_per_second == 0 ? rate : frames_per_second + 0.08f * (rate - frames_per_second);
  }
  if (workspace) workspace->PlacePicture();
  if (IsIdle(now)) {
    drawing_s = 0;
    return true;
  }
  if (auto_scale && drawing_s > 0) {
    auto_scale->Note(drawing_s, seconds - slept_s);
    if (auto_scale->scale() != engine->scale()) UseScale(auto_scale->scale());
  }
  slept_s = 0;
  const FrameInput in = input->Read(workspace ? workspace->Claims() : InputClaims{});
  Apply(in, seconds);
  if (in.closed && (!workspace || workspace->MayClose())) {
    commands.push_back(ViewerCommand::kQuit);
    return false;
  }
  Stopwatch watch;
  std::vector<world::LineSnapshot> marks;
  for (const std::uint32_t id : selection) {
    if (const auto* agent = Find(id)) AddRing(*agent, id == selection.front(), marks);
  }
  OverlayMarks drawn;
  painter.Paint({scene.agents, overlays, selection, on, Inside()}, drawn);
  shown_ghosts.clear();
  for (const Ghost& ghost : ghosts) {
    // Who stands where its ghost would needs none.
    constexpr float kSame_m = 0.3f;
    const auto* agent = ghost.agent_id != 0 ? Find(ghost.agent_id) : nullptr;
    if (agent == nullptr || !agent->alive || world::Distance(agent->position, ghost.position) >= kSame_m)
      shown_ghosts.push_back(ghost);
  }
  shown_ghosts.insert(shown_ghosts.end(), drawn.ghosts.begin(), drawn.ghosts.end());
  PaintGhostThreads(shown_ghosts, scene.agents, drawn);
  marks.insert(marks.end(), drawn.lines.begin(), drawn.lines.end());
  drawn.triangles.insert(drawn.triangles.end(), triangles.begin(), triangles.end());
  lines->Update(scene.lines, marks);
  fills->Update(drawn.triangles);
  ghost_view->Update(shown_ghosts, *things);
  skeleton_lines->Update(things->skeleton_lines(), {});
  PlaceCamera();
  watch.Lap(costs.marks_s);
  things->PoseBodies(camera.pose(), Inside());
  watch.Lap(costs.bodies_s);
  DrawPanels(seconds);
  watch.Lap(costs.panels_s);
  const bool shows_same = stands && Same(marks, last_marks) && Same(drawn.triangles, last_fills) &&
                          shown_ghosts.empty() && last_ghosts == 0 && camera.pose().position == rested_pose.position &&
                          camera.pose().orientation == rested_pose.orientation &&
                          camera.pose().vertical_fov_deg == rested_pose.vertical_fov_deg;
  last_marks = std::move(marks);
  last_fills = std::move(drawn.triangles);
  last_ghosts = shown_ghosts.size();
  // A script that plays a user reads where panels lay their texts; of the frames that nobody watches one in four is
  // drawn.
  if (options.ui_script.empty() || ++scripted_frames % 4 == 0)
    engine->Draw(!shows_same);
  else
    ImGui::Render();
  watch.Lap(costs.draw_s);
  ++costs.frames;
  last_drawn = Clock::now();
  drawing_s = std::chrono::duration<double>(last_drawn - now).count();
  // Where the processor draws, more frames than a screen shows would only keep it from the world.
  constexpr auto kFrame = std::chrono::microseconds(16'600);
  if (engine->low_detail() && !options.hidden && options.ui_script.empty()) std::this_thread::sleep_until(now + kFrame);
  slept_s = std::chrono::duration<double>(Clock::now() - last_drawn).count();
  if (workspace) {
    workspace->AfterDrawing({scene, camera.pose(), View(), labels.shown(), selection.empty() ? 0 : selection.front(),
                             [this](ScreenPoint pixel) { return AgentUnder(pixel); },
                             [this](const fs::path& file) { return SavePicture(file); }});
  }
  return true;
}

Viewer::Viewer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Viewer::~Viewer() = default;

Result<std::unique_ptr<Viewer>> Viewer::Open(const ViewerOptions& options) {
  auto engine = Engine::Start(options);
  if (!engine) return engine.error();
  auto impl = std::make_unique<Impl>();
  impl->options = options;
  impl->on[static_cast<std::size_t>(ViewerCommand::kLabels)] = options.show_labels;
  impl->on[static_cast<std::size_t>(ViewerCommand::kShots)] = true;
  impl->on[static_cast<std::size_t>(ViewerCommand::kMessages)] = true;
  impl->on[static_cast<std::size_t>(ViewerCommand::kHelp)] = options.show_help;
  impl->engine = std::move(*engine);
  try {
    if (Result<void> built = impl->Build(); !built) return built.error();
  } catch (const std::exception& error) {
    Diagnostic failure;
    failure.message = std::string("the window cannot be set up: ") + error.what();
    failure.hint = "it needs OpenGL 3.3; 'glxinfo -B' shows what the display offers";
    return failure;
  }
  return std::unique_ptr<Viewer>(new Viewer(std::move(impl)));
}

void Viewer::Show(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, double blend) {
  if (impl_->failed) return;
  try {
    Stopwatch watch;
    impl_->Show(newest, previous, static_cast<float>(std::clamp(blend, 0.0, 1.0)));
    watch.Lap(impl_->costs.show_s);
  } catch (const std::exception& error) {
    impl_->ReportFailure(error.what());
  }
}

void Viewer::SetStatus(const RunStatus& status) {
  impl_->status = status;
}

bool Viewer::RenderFrame() {
  if (impl_->failed) return false;
  try {
    return impl_->Frame();
  } catch (const std::exception& error) {
    impl_->ReportFailure(error.what());
    return false;
  }
}

double Viewer::render_scale() const {
  return impl_->engine->scale();
}

const FrameCosts& Viewer::costs() const {
  impl_->engine->CountLast(impl_->costs.draw_calls, impl_->costs.triangles);
  return impl_->costs;
}

std::vector<InputEvent> Viewer::TakeEvents() {
  return std::exchange(impl_->events, {});
}
std::vector<ViewerCommand> Viewer::TakeCommands() {
  return std::exchange(impl_->commands, {});
}
world::CameraSnapshot Viewer::Camera() const {
  return impl_->camera.pose();
}
int Viewer::width() const {
  return impl_->engine->width();
}
int Viewer::height() const {
  return impl_->engine->height();
}
void Viewer::SelectAgent(std::uint32_t agent_id) {
  impl_->selection.clear();
  if (agent_id != 0) impl_->selection.push_back(agent_id);
}
void Viewer::SelectAgents(std::vector<std::uint32_t> agent_ids) {
  impl_->selection = std::move(agent_ids);
}
std::uint32_t Viewer::selected_agent() const {
  return impl_->selection.empty() ? 0 : impl_->selection.front();
}
const std::vector<std::uint32_t>& Viewer::selection() const {
  return impl_->selection;
}

void Viewer::ShowOverlays(const world::OverlaySnapshot& overlays) {
  impl_->shows_news |= overlays.tick != impl_->overlays.tick;
  impl_->overlays = overlays;
  impl_->has_overlays = true;
}
world::OverlayWants Viewer::overlay_wants() const {
  return {impl_->IsOn(ViewerCommand::kNavigation), impl_->IsOn(ViewerCommand::kInfluence),
          impl_->IsOn(ViewerCommand::kPhysics), impl_->IsOn(ViewerCommand::kForces)};
}
void Viewer::SetGhosts(std::vector<Ghost> ghosts) {
  impl_->ghosts = std::move(ghosts);
}
void Viewer::Tell(std::string text) {
  impl_->Notice(std::move(text));
}
void Viewer::Do(ViewerCommand command) {
  impl_->Do(command);
}
bool Viewer::IsOn(ViewerCommand command) const {
  return impl_->IsOn(command);
}

Result<void> Viewer::Impl::SavePicture(const fs::path& path) {
  Diagnostic failure;
  failure.file = path.string();
  failure.hint = "is the folder there, and may you write to it? the name must end in .png";
  if (path.extension() != ".png") {
    failure.message = "a screenshot can be written as a PNG only";
    return failure;
  }
  const double scale = engine->scale();
  UseScale(options.render_scale > 0 ? scale : 1);
  try {
    engine->WritePicture(path);
  } catch (const std::exception& error) {
    failure.message = std::string("the screenshot cannot be written: ") + error.what();
  }
  UseScale(scale);
  if (!failure.message.empty()) return failure;
  return {};
}

Result<void> Viewer::SaveScreenshot(const fs::path& path) {
  return impl_->SavePicture(path);
}

namespace {

/// Of a window without panels.
template <typename T>
T& Nothing() {
  static T nothing;
  return nothing;
}

}  // namespace

PanelContents& Viewer::panel_contents() {
  return impl_->workspace ? impl_->workspace->contents : Nothing<PanelContents>();
}
std::vector<PanelRequest> Viewer::TakePanelRequests() {
  return impl_->workspace ? std::exchange(impl_->workspace->requests, {}) : std::vector<PanelRequest>{};
}
bool Viewer::panel_visible(PanelId panel) const {
  return impl_->workspace && impl_->workspace->layout().IsVisible(panel);
}
void Viewer::ShowPanel(PanelId panel) {
  if (impl_->workspace) impl_->workspace->layout().Show(panel);
}
const Layout& Viewer::layout() const {
  return impl_->workspace ? impl_->workspace->layout() : Nothing<Layout>();
}
bool Viewer::ui_script_over() const {
  return !impl_->workspace || impl_->workspace->script_over();
}
std::size_t Viewer::ui_script_at() const {
  return impl_->workspace ? impl_->workspace->script_at() : 0;
}
const std::optional<Diagnostic>& Viewer::ui_script_failure() const {
  return impl_->workspace ? impl_->workspace->script_failure() : Nothing<std::optional<Diagnostic>>();
}

}  // namespace soarbox::viewer
