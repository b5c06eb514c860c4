// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/viewer.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numbers>
#include <optional>
#include <thread>

#include "diagnostics/problem.h"
#include "viewer/imagined_painter.h"
#include "viewer/interpolate.h"
#include "viewer/viewer_impl.h"

namespace soarbox::viewer {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr float kLineWidth_px = 2.2f;

/// The default folder of the media: next to an installed program, else the folder of the build.
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

/// A ring on the ground around a selected agent; brighter for the first one.
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

Result<void> Viewer::Impl::Build() {
  const fs::path media = options.media_dir.empty() ? DefaultMediaDir() : options.media_dir;
  auto loaded = Shaders::Load(media / "shaders", engine->low_detail());
  if (!loaded) return loaded.error();
  shaders = *loaded;
  Ogre::SceneManager& scene_manager = engine->scene();
  materials.emplace(*shaders, engine->low_detail());
  lights.emplace(scene_manager, *shaders, materials->ShadowCaster(Placing::kOne), engine->low_detail());
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
    workspace.emplace(*engine, *panels, *options.panels, *options.layout);
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
  if (!sky->Show(newest.sky)) things->WarnOnce("sky", newest.sky, "clouds over water are shown instead");

  if (!options.hidden) sounds.Take(newest, camera.pose(), !status.paused && !IsOn(ViewerCommand::kMute));
  // Simulated time since the last call. The camera of a hidden window advances by it.
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
    // Agents keep their order; new ones are appended.
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
  if (camera.keeps() || !has_framed) scenery = SceneryAround(newest, Places());
  if (options.hidden && passed_s > 0) {
    KeepInView(passed_s);
    camera.Update({}, passed_s, camera.agent() != 0 ? Find(camera.agent()) : nullptr,
                  static_cast<float>(engine->height()));
  }
  if (options.frame_agents && !has_framed && !scene.agents.empty()) {
    has_framed = true;
    // Among many pieces of buildings, agents are visible only from above.
    constexpr std::ptrdiff_t kManyPieces = 40;
    has_walls = kManyPieces < std::count_if(
                                  newest.drawables.begin(), newest.drawables.end(),
                                  [](const auto& drawable) {
                                    return !drawable.belongs_to_agent && drawable.shape == world::ShapeKind::kMesh &&
                                           drawable.mesh.value().find("/modular_") != std::string::npos;
                                  });
    const bool is_chosen = newest.camera_moves > 0 && newest.camera_is_fixed;
    if (!is_chosen && (newest.camera_moves == 0 || has_walls || !SeesAgentsWell())) Frame({}, true);
    camera.Arrive();
    if (!is_chosen) camera.BeginKeeping();
  }
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
  if (kept_before && !camera.keeps()) Notice("You control the camera; Home makes it automatic again");
  hovered = cursor ? AgentUnder(*cursor) : 0;
  notice_s = std::max(0.0f, notice_s - seconds);
}

/// Whether the last frame still shows the current state. Then the window waits a moment for the user.
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
  FrameInput in = input->Read(workspace ? workspace->Claims() : InputClaims{});
  TakeButtonClicks(in);
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
  PaintImagined(imagined, answer, drawn);
  shown_ghosts.clear();
  for (const Ghost& ghost : ghosts) {
    // An agent at the place of its ghost needs no ghost.
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
  skeleton_lines->Update(things->skeleton_lines(), {});
  PlaceCamera();
  watch.Lap(costs.marks_s);
  things->BeginFrame(engine->camera(), engine->height(), Inside());
  ghost_view->Update(shown_ghosts, *things, things->bones());
  things->EndFrame();
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
  // A script that plays a user needs the texts of panels. Of hidden frames only one in four is drawn.
  if (options.ui_script.empty() || ++scripted_frames % 4 == 0)
    engine->Draw(!shows_same);
  else
    ImGui::Render();
  watch.Lap(costs.draw_s);
  ++costs.frames;
  last_drawn = Clock::now();
  drawing_s = std::chrono::duration<double>(last_drawn - now).count();
  // With software rendering, more frames than the screen shows would slow down the world.
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
  impl->engine = std::move(*engine);
  try {
    if (Result<void> built = impl->Build(); !built) return built.error();
  } catch (const std::exception& error) {
    return NewProblem(std::string("the window cannot be set up: ") + error.what(),
                      "it needs OpenGL 3.3; 'glxinfo -B' shows what the display offers");
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
void Viewer::SetGhosts(std::vector<Ghost> ghosts, std::vector<debugger::SceneShape> imagined,
                       debugger::AnswerLines answer) {
  impl_->ghosts = std::move(ghosts);
  impl_->imagined = std::move(imagined);
  impl_->answer = std::move(answer);
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

}  // namespace soarbox::viewer
