// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/viewer.h"

#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>

#include "viewer/engine.h"
#include "viewer/fill_batch.h"
#include "viewer/input_reader.h"
#include "viewer/interpolate.h"
#include "viewer/light_rig.h"
#include "viewer/line_batch.h"
#include "viewer/panels.h"
#include "viewer/particle_lines.h"
#include "viewer/scene_view.h"
#include "viewer/script_ui.h"
#include "viewer/sky_view.h"

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

/// A ring on the ground around the selected agent.
std::vector<world::LineSnapshot> RingAround(const world::AgentSnapshot& agent) {
  constexpr int kPieces = 40;
  std::vector<world::LineSnapshot> ring;
  const float radius = agent.radius_m * 1.5f, y = agent.position.y - agent.height_m / 2 + 0.06f;
  const auto point = [&](int i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / kPieces;
    return world::Vec3{agent.position.x + radius * std::cos(angle), y, agent.position.z + radius * std::sin(angle)};
  };
  for (int i = 0; i < kPieces; ++i) ring.push_back({point(i), point(i + 1), {1.0f, 0.86f, 0.35f, 1}});
  return ring;
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

  FreeCamera camera;
  ParticleLines particles;
  std::optional<std::uint32_t> camera_moves;
  world::SceneSnapshot scene;  ///< Without its drawables; agents stand where they are drawn.
  RunStatus status;
  std::vector<InputEvent> events;
  std::vector<ViewerCommand> commands;
  std::uint32_t selected = 0;
  bool show_labels = true, show_help = false, follows = false;
  bool failed = false;
  Clock::time_point last_frame = Clock::now();
  float frames_per_second = 0;

  Result<void> Build();
  void Show(const world::SceneSnapshot& newest, const world::SceneSnapshot* previous, float blend);
  bool Frame();
  void Apply(const FrameInput& in, float seconds);
  void PlaceCamera();
  void DrawPanels(float seconds);
  void ReportFailure(const std::string& what);
  const world::AgentSnapshot* Selected() const;
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
  materials.emplace(*shaders);
  lights.emplace(scene_manager, *shaders, materials->ShadowCaster(), engine->low_detail());
  sky.emplace(scene_manager, *materials);
  things.emplace(scene_manager, *materials, engine->low_detail() ? 0.45f : 1.0f, options.on_diagnostic);
  lines = std::make_unique<LineBatch>(materials->LineMaterial(kLineWidth_px));
  skeleton_lines = std::make_unique<LineBatch>(materials->LineMaterial(kLineWidth_px, true));
  fills = std::make_unique<FillBatch>(materials->FillMaterial());
  scene_manager.getRootSceneNode()->createChildSceneNode()->attachObject(lines.get());
  scene_manager.getRootSceneNode()->createChildSceneNode()->attachObject(skeleton_lines.get());
  scene_manager.getRootSceneNode()->createChildSceneNode()->attachObject(fills.get());
  panels.emplace(*materials);
  input.emplace(engine->window());
  return {};
}

const world::AgentSnapshot* Viewer::Impl::Selected() const {
  for (const auto& agent : scene.agents) {
    if (agent.id == selected) return &agent;
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
  things->Update(newest, previous, blend, camera.pose().position);
  lights->Update(newest);
  lights->SetSkyRotation(newest.sky_rotation_deg);
  if (!sky->Show(newest.sky)) things->WarnOnce("sky", newest.sky, "clouds over water stand in for it");

  scene.tick = newest.tick;
  scene.time_s = newest.time_s;
  scene.ui = newest.ui;
  scene.markup_palette = newest.markup_palette;
  scene.agents = newest.agents;
  scene.lines = newest.lines;
  particles.AddLines(newest, scene.lines);
  fills->Update(newest.triangles);
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
    follows = false;
  }
}

void Viewer::Impl::Apply(const FrameInput& in, float seconds) {
  events.insert(events.end(), in.events.begin(), in.events.end());
  commands.insert(commands.end(), in.commands.begin(), in.commands.end());
  show_help ^= in.toggle_help;
  show_labels ^= in.toggle_labels;
  for (const ScreenPoint click : in.clicks) selected = View().AgentAt(click, scene.agents);
  if (in.new_width > 0) engine->Resize(in.new_width, in.new_height);
  if (in.toggle_follow) follows = !follows && Selected() != nullptr;
  camera.Update(in.camera, seconds);
  if (in.camera.forward != 0 || in.camera.left != 0 || in.camera.up != 0) follows = false;
  const world::AgentSnapshot* agent = follows ? Selected() : nullptr;
  if (agent != nullptr)
    camera.Follow(agent->position + world::Vec3{0, 0.3f, 0});
  else
    camera.StopFollowing();
}

void Viewer::Impl::PlaceCamera() {
  const world::CameraSnapshot& pose = camera.pose();
  engine->camera_node().setPosition(ToOgre(pose.position));
  engine->camera_node().setOrientation(ToOgre(pose.orientation));
  engine->camera().setFOVy(Ogre::Degree(pose.vertical_fov_deg));
  sky->Follow(ToOgre(pose.position));
}

void Viewer::Impl::DrawPanels(float seconds) {
  panels->BeginFrame(engine->width(), engine->height(), seconds);
  const Projection view = View();
  if (show_labels) DrawAgentLabels(*panels, scene.agents, camera.pose(), view, selected);
  DrawScriptUi(scene, view, *panels);
  if (const auto* agent = Selected()) DrawAgentCard(*panels, *agent, follows);
  if (show_help) DrawKeyHelp(*panels);
  if (options.show_status_bar) DrawStatusBar(*panels, status, scene, options.hidden ? 0 : frames_per_second);
  panels->EndFrame();
}

bool Viewer::Impl::Frame() {
  const Clock::time_point now = Clock::now();
  const float seconds = std::chrono::duration<float>(now - last_frame).count();
  last_frame = now;
  if (seconds > 0) {
    const float rate = 1 / std::max(seconds, 1e-3f);
    frames_per_second = frames_per_second == 0 ? rate : frames_per_second + 0.08f * (rate - frames_per_second);
  }
  const FrameInput in = input->Read();
  Apply(in, seconds);
  if (in.closed) {
    commands.push_back(ViewerCommand::kQuit);
    return false;
  }
  const auto* agent = Selected();
  lines->Update(scene.lines, agent != nullptr ? RingAround(*agent) : std::vector<world::LineSnapshot>{});
  skeleton_lines->Update(things->skeleton_lines(), {});
  PlaceCamera();
  DrawPanels(seconds);
  engine->Draw();
  return true;
}

Viewer::Viewer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Viewer::~Viewer() = default;

Result<std::unique_ptr<Viewer>> Viewer::Open(const ViewerOptions& options) {
  auto engine = Engine::Start(options);
  if (!engine) return engine.error();
  auto impl = std::make_unique<Impl>();
  impl->options = options;
  impl->show_labels = options.show_labels;
  impl->show_help = options.show_help;
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
    impl_->Show(newest, previous, static_cast<float>(std::clamp(blend, 0.0, 1.0)));
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
  impl_->selected = agent_id;
}
std::uint32_t Viewer::selected_agent() const {
  return impl_->selected;
}

Result<void> Viewer::SaveScreenshot(const fs::path& path) {
  Diagnostic failure;
  failure.file = path.string();
  failure.hint = "is the folder there, and may you write to it? the name must end in .png";
  if (path.extension() != ".png") {
    failure.message = "a screenshot can be written as a PNG only";
    return failure;
  }
  try {
    impl_->engine->WritePicture(path);
  } catch (const std::exception& error) {
    failure.message = std::string("the screenshot cannot be written: ") + error.what();
    return failure;
  }
  return {};
}

}  // namespace soarbox::viewer
