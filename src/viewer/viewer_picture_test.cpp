// SPDX-License-Identifier: BSD-2-Clause
// Draws real pictures and checks them. Starts a virtual display if there is none.
#include <OgreColourValue.h>
#include <OgreDataStream.h>
#include <OgreImage.h>
#include <SDL.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <optional>

#include "model/model.h"
#include "viewer/demo_scene_test_support.h"
#include "viewer/picking.h"
#include "viewer/viewer.h"
#include "world/body_meshes.h"

namespace soarbox::viewer {
namespace {

using testing::Each;
using testing::HasSubstr;
using world::Vec3;

constexpr int kWidth = 1280, kHeight = 720;
/// Size of most pictures: a quarter of the pixels.
constexpr int kSmallWidth = 640, kSmallHeight = 360;

struct Pixel {
  int r, g, b;
  int light() const { return r + g + b; }
};

/// A PNG file, read back.
class Picture {
 public:
  explicit Picture(const std::filesystem::path& path) {
    auto* file = new std::ifstream(path, std::ios::binary);  // Owned by the stream below.
    Ogre::DataStreamPtr stream(new Ogre::FileStreamDataStream(file, true));
    image_.load(stream, "png");
  }
  int width() const { return static_cast<int>(image_.getWidth()); }
  int height() const { return static_cast<int>(image_.getHeight()); }
  Pixel At(int x, int y) const {
    const Ogre::ColourValue c = image_.getColourAt(static_cast<std::size_t>(x), static_cast<std::size_t>(y), 0);
    return {static_cast<int>(c.r * 255), static_cast<int>(c.g * 255), static_cast<int>(c.b * 255)};
  }
  template <typename Wanted>
  int Count(int left, int top, int right, int bottom, Wanted&& wanted) const {
    int count = 0;
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) count += wanted(At(x, y)) ? 1 : 0;
    }
    return count;
  }

 private:
  Ogre::Image image_;
};

class PictureTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::getenv("DISPLAY") == nullptr) GTEST_SKIP() << "there is no display, and Xvfb is not installed";
    path_ = std::filesystem::temp_directory_path() / ("soarbox-picture-" + std::to_string(getpid()) + ".png");
  }
  void TearDown() override { std::filesystem::remove(path_); }

  std::unique_ptr<Viewer> OpenHidden(int width = kSmallWidth, int height = kSmallHeight, Detail detail = Detail::kLow) {
    ViewerOptions options;
    options.width = width;
    options.height = height;
    options.hidden = true;
    options.detail = detail;
    options.on_diagnostic = [this](const Diagnostic& d) { diagnostics_.push_back(Format(d)); };
    auto viewer = Viewer::Open(options);
    if (!viewer) {
      ADD_FAILURE() << Format(viewer.error());
      return nullptr;
    }
    return std::move(*viewer);
  }

  Picture Draw(Viewer& viewer, const world::SceneSnapshot& scene) {
    viewer.Show(scene);
    EXPECT_TRUE(viewer.RenderFrame());
    const auto saved = viewer.SaveScreenshot(path_);
    if (!saved) ADD_FAILURE() << Format(saved.error());
    return Picture(path_);
  }

  std::filesystem::path path_;
  std::vector<std::string> diagnostics_;
};

TEST_F(PictureTest, ShowsSkyGroundAgentsAndText) {
  const auto viewer = OpenHidden(kWidth, kHeight, Detail::kFull);
  ASSERT_NE(viewer, nullptr);
  const Picture picture = Draw(*viewer, DemoScene(6, kWidth, kHeight).At(3));
  ASSERT_EQ(picture.width(), kWidth);
  ASSERT_EQ(picture.height(), kHeight);

  const auto bluish = [](Pixel p) { return p.b > p.r + 8 && p.b > 120; };
  const auto earthy = [](Pixel p) { return p.r >= p.b && p.light() > 120 && p.light() < 700; };
  EXPECT_GT(picture.Count(0, 40, kWidth, 160, bluish), kWidth * 120 / 3) << "sky";
  EXPECT_GT(picture.Count(0, 560, 900, kHeight, earthy), 900 * 160 * 8 / 10) << "ground";

  // Bodies of the followers, the waypoint agent, the seeker and the leader, each in its colour.
  EXPECT_GT(picture.Count(0, 200, 900, 700, [](Pixel p) { return p.b > 140 && p.r < 70; }), 800) << "followers";
  EXPECT_GT(picture.Count(0, 200, 900, 700, [](Pixel p) { return p.g > 140 && p.r < 90 && p.b < 130 && p.b > 20; }),
            200)
      << "waypoint agent";
  EXPECT_GT(picture.Count(0, 200, 900, 700, [](Pixel p) { return p.r > 170 && p.g < 90 && p.b < 80 && p.b > 10; }), 200)
      << "seeker";
  EXPECT_GT(picture.Count(0, 200, 900, 700,
                          [](Pixel p) { return p.r > 200 && p.g > 120 && p.g < 200 && p.b < 80 && p.b > 5; }),
            200)
      << "leader";

  // The time, in the upper left corner.
  EXPECT_GT(picture.Count(2, 2, 60, 20, [](Pixel p) { return p.light() > 600; }), 40);
  EXPECT_GT(picture.Count(0, 0, 50, 20, [](Pixel p) { return p.light() < 200; }), 500);
  // The help text: bright letters in a dark box at the bottom right.
  const int letters = picture.Count(960, 505, 1260, 685, [](Pixel p) { return p.light() > 600; });
  const int dark = picture.Count(960, 505, 1260, 685, [](Pixel p) { return p.light() < 330; });
  EXPECT_GT(letters, 1000);
  EXPECT_GT(dark, 300 * 180 / 2);
  EXPECT_THAT(diagnostics_, testing::IsEmpty());
}

TEST_F(PictureTest, ASceneThatIsDrawnSmallerLooksTheSameAndTextsStaySharp) {
  world::SceneSnapshot scene = DemoScene(6, kWidth, kHeight).At(3);
  std::vector<Picture> pictures;
  for (const double scale : {1.0, 0.75}) {
    ViewerOptions options;
    options.width = kWidth;
    options.height = kHeight;
    options.hidden = true;
    options.detail = Detail::kLow;
    options.render_scale = scale;
    const auto viewer = Viewer::Open(options);
    ASSERT_TRUE(viewer.ok());
    EXPECT_EQ((*viewer)->render_scale(), scale);
    pictures.push_back(Draw(**viewer, scene));
  }
  // The same things at the same places: only edges may differ.
  double difference = 0;
  int edges = 0, count = 0;
  for (int y = 40; y < 480; y += 3) {
    for (int x = 0; x < kWidth; x += 3, ++count) {
      const Pixel a = pictures[0].At(x, y), b = pictures[1].At(x, y);
      const int apart = std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
      difference += apart;
      edges += apart > 120 ? 1 : 0;
    }
  }
  EXPECT_LT(difference / count, 12);
  EXPECT_LT(edges, count / 50);
  EXPECT_GT(difference, 0);
  // The help text is in its box over the scene; its letters are those of the large picture.
  int different_letters = 0;
  for (int y = 505; y < 685; ++y) {
    for (int x = 960; x < 1260; ++x) {
      const bool was = pictures[0].At(x, y).light() > 600, is = pictures[1].At(x, y).light() > 600;
      different_letters += was != is ? 1 : 0;
    }
  }
  EXPECT_LT(different_letters, 60);
}

TEST_F(PictureTest, PicturesAreSavedInFullUnlessASizeWasAskedFor) {
  const auto viewer = OpenHidden();
  ASSERT_NE(viewer, nullptr);
  const world::SceneSnapshot scene = DemoScene(6, kSmallWidth, kSmallHeight).At(3);
  const Picture before = Draw(*viewer, scene);
  viewer->Do(ViewerCommand::kScaleHalf);
  EXPECT_EQ(viewer->render_scale(), 0.5);
  EXPECT_TRUE(viewer->IsOn(ViewerCommand::kScaleHalf));
  EXPECT_FALSE(viewer->IsOn(ViewerCommand::kScaleAuto));
  const Picture after = Draw(*viewer, scene);
  EXPECT_EQ(viewer->render_scale(), 0.5);
  int different = 0;
  for (int y = 0; y < kSmallHeight; y += 2) {
    for (int x = 0; x < kSmallWidth; x += 2) different += before.At(x, y).light() != after.At(x, y).light() ? 1 : 0;
  }
  EXPECT_EQ(different, 0);
  viewer->Do(ViewerCommand::kScaleAuto);
  EXPECT_EQ(viewer->render_scale(), 1);
}

TEST_F(PictureTest, ThingsCastShadowsAndWhatIsMissingIsMagentaAndReportedOnce) {
  const auto viewer = OpenHidden();
  ASSERT_NE(viewer, nullptr);
  world::SceneSnapshot scene = DemoScene(0, kSmallWidth, kSmallHeight).At(0);
  scene.ui.clear();
  scene.camera.position = {0, 6, 9};
  scene.camera.orientation = {std::cos(0.3f), -std::sin(0.3f), 0, 0};
  world::DrawableSnapshot box;
  box.id = 1;
  box.shape = world::ShapeKind::kBox;
  box.size = {1, 2, 1};
  box.position = {0, 1, 0};
  scene.drawables.push_back(box);
  for (const std::uint32_t id : {2u, 3u}) {
    world::DrawableSnapshot missing;
    missing.id = id;
    missing.mesh = "models/unicorn.mesh";
    missing.position = {-4.0f + 8.0f * static_cast<float>(id - 2), 0.5f, 0};
    scene.drawables.push_back(missing);
  }
  box.id = 4;
  box.position = {-2, 1, -3};
  box.material = "Mahogany";
  scene.drawables.push_back(box);
  const Picture picture = Draw(*viewer, scene);
  viewer->Show(scene);

  // The sun shines along (1, -1, 1): the box's shadow is to its right, towards the camera.
  const Projection view(scene.camera, kSmallWidth, kSmallHeight);
  const auto light_at = [&](Vec3 place) {
    const auto at = view.Project(place);
    EXPECT_TRUE(at.has_value());
    return at ? picture.At(static_cast<int>(at->x), static_cast<int>(at->y)).light() : 0;
  };
  const int shadow = light_at({1.1f, 0, 1.1f}), lit = light_at({-1.5f, 0, 2.5f});
  EXPECT_LT(shadow, 0.7 * lit);
  EXPECT_GT(shadow, 20) << "ambient light reaches into shadows";

  EXPECT_GT(picture.Count(0, 0, kSmallWidth, kSmallHeight, [](Pixel p) { return p.r > 150 && p.b > 150 && p.g < 60; }),
            250);
  ASSERT_EQ(diagnostics_.size(), 2u);
  EXPECT_THAT(diagnostics_, Each(HasSubstr("warning")));
  EXPECT_THAT(diagnostics_[0], HasSubstr("models/unicorn.mesh"));
  EXPECT_THAT(diagnostics_[1], HasSubstr("Mahogany"));
}

TEST_F(PictureTest, AVisibleWindowAnswersClicksKeysAndItsNewSize) {
  ViewerOptions options;
  options.width = 800;
  options.height = 600;
  auto opened = Viewer::Open(options);
  ASSERT_TRUE(opened.ok()) << Format(opened.error());
  Viewer& viewer = **opened;
  const world::SceneSnapshot scene = DemoScene(6, 800, 600).At(0);
  viewer.Show(scene);
  ASSERT_TRUE(viewer.RenderFrame());
  viewer.TakeEvents();

  const auto agent = Projection(scene.camera, 800, 600).Project(scene.agents[4].position);
  ASSERT_TRUE(agent.has_value());
  SDL_Event event{};
  event.button.button = SDL_BUTTON_LEFT;
  event.button.x = static_cast<int>(agent->x);
  event.button.y = static_cast<int>(agent->y);
  for (const std::uint32_t type : {SDL_MOUSEBUTTONDOWN, SDL_MOUSEBUTTONUP}) {
    event.type = type;
    SDL_PushEvent(&event);
  }
  SDL_Event key{};
  key.type = SDL_KEYDOWN;
  key.key.keysym.scancode = SDL_SCANCODE_P;
  SDL_PushEvent(&key);
  SDL_Event resized{};
  resized.type = SDL_WINDOWEVENT;
  resized.window.event = SDL_WINDOWEVENT_SIZE_CHANGED;
  resized.window.data1 = 640;
  resized.window.data2 = 400;
  SDL_PushEvent(&resized);
  ASSERT_TRUE(viewer.RenderFrame());

  EXPECT_EQ(viewer.selected_agent(), scene.agents[4].id);
  EXPECT_THAT(viewer.TakeCommands(), testing::ElementsAre(ViewerCommand::kTogglePause));
  EXPECT_GE(viewer.TakeEvents().size(), 3u);
  EXPECT_EQ(viewer.width(), 640);
  const Picture picture = Draw(viewer, scene);
  EXPECT_EQ(picture.width(), 640);
  EXPECT_EQ(picture.height(), 400);

  SDL_Event close{};
  close.type = SDL_QUIT;
  SDL_PushEvent(&close);
  EXPECT_FALSE(viewer.RenderFrame());
}

TEST_F(PictureTest, TheCameraObeysScriptsOnlyWhenTheyMoveIt) {
  const auto viewer = OpenHidden();
  ASSERT_NE(viewer, nullptr);
  world::SceneSnapshot scene = DemoScene(1, kSmallWidth, kSmallHeight).At(0);
  viewer->Show(scene);
  EXPECT_EQ(viewer->Camera().position, scene.camera.position);
  scene.camera.position = {1, 2, 3};
  viewer->Show(scene);
  EXPECT_NE(viewer->Camera().position, scene.camera.position);
  ++scene.camera_moves;
  viewer->Show(scene);
  EXPECT_EQ(viewer->Camera().position, scene.camera.position);
}

/// Overlays for the agents of a scene. The first agent sees far, has a goal, and remembers the second at a wrong place;
/// the second one was hit.
world::OverlaySnapshot OverlaysOf(const world::SceneSnapshot& scene) {
  world::OverlaySnapshot overlays;
  overlays.tick = scene.tick;
  for (const world::AgentSnapshot& agent : scene.agents) {
    world::AgentOverlay& out = overlays.agents.emplace_back();
    out.id = agent.id;
    out.operator_name = "patrol";
    out.has_senses = true;
    out.sight_m = 9;
    out.view_deg = 120;
    out.hearing_m = 5;
    out.path = {agent.position + Vec3{3, -1, 0}, agent.position + Vec3{3, -1, 4}};
    out.goal = out.path.back();
    out.target_id = scene.agents[agent.id == scene.agents[0].id ? 1 : 0].id;
  }
  world::ContactSnapshot contact;
  contact.agent_id = scene.agents[1].id;
  contact.position = scene.agents[1].position + Vec3{2.5f, 0, 1};
  contact.age_s = 4;
  overlays.agents[0].contacts.push_back(contact);
  const Vec3 a = scene.agents[0].position, b = scene.agents[1].position;
  overlays.shots.push_back({a, b, scene.agents[0].id, scene.agents[1].id, 0.1});
  overlays.speech.push_back({scene.agents[0].id, 0, "enemy in sight", 0.2});
  return overlays;
}

TEST_F(PictureTest, EachOverlayAddsToThePictureAndGoesAgain) {
  constexpr int kWide = 960, kHigh = 540;
  const auto viewer = OpenHidden(kWide, kHigh);
  ASSERT_NE(viewer, nullptr);
  DemoScene demo(6, kWide, kHigh);
  world::SceneSnapshot scene = demo.At(0);
  for (int tick = 1; tick <= 40; ++tick) {
    scene = demo.At(tick / 10.0);
    scene.tick = static_cast<std::uint64_t>(tick);
    for (auto& agent : scene.agents) agent.velocity = {2, 0, static_cast<float>(tick % 2)};
    viewer->Show(scene);
  }
  viewer->ShowOverlays(OverlaysOf(scene));
  viewer->SelectAgent(scene.agents[0].id);
  // First those that are on at the start.
  for (const ViewerCommand command : {ViewerCommand::kLabels, ViewerCommand::kShots, ViewerCommand::kMessages}) {
    EXPECT_TRUE(viewer->IsOn(command));
    viewer->Do(command);
  }
  ASSERT_TRUE(viewer->RenderFrame());  // Panels determine their size in their first frame.
  const Picture plain = Draw(*viewer, scene);
  const auto differing = [&](const Picture& picture) {
    int count = 0;
    for (int y = 30; y < kHigh; ++y) {
      for (int x = 0; x < kWide; ++x) {
        const Pixel p = picture.At(x, y), q = plain.At(x, y);
        count += std::abs(p.r - q.r) + std::abs(p.g - q.g) + std::abs(p.b - q.b) > 24 ? 1 : 0;
      }
    }
    return count;
  };
  for (const ViewerCommand command : {ViewerCommand::kLabels, ViewerCommand::kTrails, ViewerCommand::kSenses,
                                      ViewerCommand::kPaths, ViewerCommand::kTargets, ViewerCommand::kShots,
                                      ViewerCommand::kMessages, ViewerCommand::kForces, ViewerCommand::kBelief}) {
    viewer->Do(command);
    EXPECT_GT(differing(Draw(*viewer, scene)), 60) << InfoOf(command).title;
    viewer->Do(command);
  }
  EXPECT_LT(differing(Draw(*viewer, scene)), 10) << "something stays";
  viewer->Do(ViewerCommand::kNavigation);
  EXPECT_TRUE(viewer->overlay_wants().navigation);
  EXPECT_FALSE(viewer->overlay_wants().physics);
}

/// Agents in rows on the ground of the demo, each with one drawable, which `dress` completes.
template <typename Dress>
world::SceneSnapshot CrowdOf(std::uint32_t count, Dress&& dress) {
  world::SceneSnapshot scene = DemoScene(0, kSmallWidth, kSmallHeight).At(0);
  scene.ui.clear();
  scene.camera.position = {0, 30, 50};
  scene.camera.orientation = {std::cos(0.3f), -std::sin(0.3f), 0, 0};
  constexpr std::uint32_t kPerRow = 40;
  for (std::uint32_t i = 0; i < count; ++i) {
    world::AgentSnapshot& agent = scene.agents.emplace_back();
    agent.id = 1000000 + i;
    agent.kind = i % 2 == 0 ? "lua" : "soar seeking";
    agent.team = i % 2 == 0 ? "blue" : "red";
    agent.position = {2.0f * static_cast<float>(i % kPerRow) - kPerRow, 0.9f,
                      20 - 2.0f * static_cast<float>(i / kPerRow)};
    world::DrawableSnapshot drawable;
    drawable.id = drawable.owner_id = agent.id;
    drawable.belongs_to_agent = true;
    drawable.position = agent.position;
    dress(drawable);
    scene.drawables.push_back(std::move(drawable));
  }
  return scene;
}

TEST_F(PictureTest, ThingsThatAreAlikeAreFewDrawCallsHoweverManyTheyAre) {
  const auto viewer = OpenHidden(kSmallWidth, kSmallHeight, Detail::kFull);
  ASSERT_NE(viewer, nullptr);
  const auto capsule = [](world::DrawableSnapshot& drawable) {
    drawable.shape = world::ShapeKind::kCapsule;
    drawable.size = {0.4f, 1.8f, 0.4f};
  };
  std::vector<world::BonePose> bones;
  const world::Skeleton& skeleton = world::SoldierRig().skeleton;
  for (int i = 0; i < skeleton.count(); ++i) bones.push_back(skeleton.BindInModel(i));
  const world::BodyBones standing = bones;
  const auto soldier = [&](world::DrawableSnapshot& drawable) {
    drawable.mesh = "models/soarbox/soldier.mesh";
    drawable.position.y = 0;
    drawable.bones = standing;
  };
  // The number of draw calls is the same for ten times as many, in the picture and both shadow maps.
  Draw(*viewer, CrowdOf(100, capsule));
  const std::size_t calls = viewer->costs().draw_calls;
  EXPECT_LT(calls, 40u);
  Draw(*viewer, CrowdOf(1000, capsule));
  EXPECT_LE(viewer->costs().draw_calls, calls + 4);
  EXPECT_LT(viewer->costs().triangles, 500'000u);
  Draw(*viewer, CrowdOf(200, soldier));
  EXPECT_LT(viewer->costs().draw_calls, 40u);
  EXPECT_LT(viewer->costs().triangles, 250'000u);
  EXPECT_THAT(diagnostics_, testing::IsEmpty());
}

/// A red square of 1 m that faces along z, moved by one bone. The model is stored under this key.
std::string RedSquareOnABone() {
  model::Model model;
  const Vec3 corners[] = {{-0.5f, -0.5f, 0}, {0.5f, -0.5f, 0}, {0.5f, 0.5f, 0}, {-0.5f, 0.5f, 0}};
  for (const Vec3 corner : corners) {
    model.corners.push_back({corner, {0, 0, 1}, 1, 0, 0});
    model.skins.push_back({corner, {0, 0, 1}, {}, {1, 0, 0, 0}});
  }
  model.indices = {0, 1, 2, 0, 2, 3};
  model.min = corners[0];
  model.max = corners[2];
  model.joints = {{0, {}}};
  model.rig.skeleton.AddToParent("bone", -1, {});
  return model::KeepModel("square.glb", std::move(model));
}

TEST_F(PictureTest, ModelsThatMoveAreWhereTheirBonesAre) {
  const auto viewer = OpenHidden();
  ASSERT_NE(viewer, nullptr);
  const std::string key = RedSquareOnABone();
  world::SceneSnapshot scene = CrowdOf(1, [&](world::DrawableSnapshot& drawable) {
    drawable.mesh = key;
    drawable.position = {0, 1.2f, 0};
    drawable.bones = std::vector<world::BonePose>{{{1, 0, 0}, {}}};
  });
  scene.camera.position = {0, 1.2f, 4.5f};
  scene.camera.orientation = {};
  viewer->Do(ViewerCommand::kLabels);
  const auto reddish = [](Pixel p) { return p.r > p.b + 60 && p.r > p.g + 60; };
  constexpr int kMiddle = kSmallWidth / 2;
  const Picture right = Draw(*viewer, scene);
  EXPECT_GT(right.Count(kMiddle, 60, kSmallWidth, kSmallHeight, reddish), 400);
  EXPECT_EQ(right.Count(0, 60, kMiddle, kSmallHeight, reddish), 0);
  scene.tick += 1;
  scene.drawables.Edit(scene.drawables.Find(scene.agents[0].id)).bones = std::vector<world::BonePose>{{{-1, 0, 0}, {}}};
  const Picture left = Draw(*viewer, scene);
  EXPECT_GT(left.Count(0, 60, kMiddle, kSmallHeight, reddish), 400);
  EXPECT_EQ(left.Count(kMiddle, 60, kSmallWidth, kSmallHeight, reddish), 0);
  EXPECT_THAT(diagnostics_, testing::IsEmpty());
}

TEST_F(PictureTest, BodiesStandWhereTheirBonesAreInTheColoursOfTheirTeam) {
  const auto viewer = OpenHidden();
  ASSERT_NE(viewer, nullptr);
  std::vector<world::BonePose> bones;
  const world::Skeleton& skeleton = world::SoldierRig().skeleton;
  for (int i = 0; i < skeleton.count(); ++i) bones.push_back(skeleton.BindInModel(i));
  world::SceneSnapshot scene = CrowdOf(2, [&](world::DrawableSnapshot& drawable) {
    drawable.mesh = "models/soarbox/soldier.mesh";
    drawable.bones = bones;
  });
  for (const std::uint32_t i : {0u, 1u}) {
    world::DrawableSnapshot& drawable = scene.drawables.Edit(scene.drawables.Find(scene.agents[i].id));
    drawable.position = {i == 0 ? -0.8f : 0.8f, 0, 0};
    scene.agents[i].position = drawable.position + Vec3{0, 0.9f, 0};
  }
  scene.camera.position = {0, 1.2f, 4.5f};
  scene.camera.orientation = {};
  viewer->Do(ViewerCommand::kLabels);
  const Picture picture = Draw(*viewer, scene);
  const auto bluish = [](Pixel p) { return p.b > p.r + 60 && p.b > p.g + 40; };
  const auto reddish = [](Pixel p) { return p.r > p.b + 60 && p.r > p.g + 60; };
  constexpr int kMiddle = kSmallWidth / 2, kGround = kSmallHeight * 3 / 4;
  EXPECT_GT(picture.Count(kMiddle - 140, 60, kMiddle, kGround, bluish), 60) << "a blue one stands to the left";
  EXPECT_GT(picture.Count(kMiddle, 60, kMiddle + 140, kGround, reddish), 60) << "a red one stands to the right";
  EXPECT_EQ(picture.Count(kMiddle - 140, 60, kMiddle, kGround, reddish), 0);
}

TEST_F(PictureTest, GhostsStandWhereTheyAreSaidToAndAreSeenThrough) {
  const auto viewer = OpenHidden();
  ASSERT_NE(viewer, nullptr);
  world::SceneSnapshot scene = DemoScene(0, kSmallWidth, kSmallHeight).At(0);
  scene.ui.clear();
  const Picture without = Draw(*viewer, scene);
  const Projection view(viewer->Camera(), kSmallWidth, kSmallHeight);
  const Vec3 place = scene.camera.position + view.RayThrough({200, 215}) * 7.0f;
  viewer->SetGhosts({{.name = "elsewhere", .position = place, .color = {1, 0.2f, 0.9f, 1}, .opacity = 0.7f}});
  const Picture with = Draw(*viewer, scene);
  const auto is_ink = [](Pixel p) { return p.r > 190 && p.b > 180 && p.g < 190; };
  const Pixel before = without.At(200, 215), after = with.At(200, 215);
  EXPECT_GT(after.r + after.b - before.r - before.b, 30);
  EXPECT_GT(with.Count(80, 60, 320, 215, is_ink), without.Count(80, 60, 320, 215, is_ink) + 20) << "its name";
  viewer->SetGhosts({});
  const Pixel again = Draw(*viewer, scene).At(200, 215);
  EXPECT_NEAR(again.r, before.r, 4);
}

TEST_F(PictureTest, ADragSelectsABoxAndCamerasObeyTheirKeys) {
  const auto viewer = OpenHidden();
  ASSERT_NE(viewer, nullptr);
  const world::SceneSnapshot scene = DemoScene(6, kSmallWidth, kSmallHeight).At(0);
  viewer->Show(scene);
  ASSERT_TRUE(viewer->RenderFrame());
  const auto button = [](std::uint32_t type, int x, int y) {
    SDL_Event event{};
    event.type = type;
    event.button.button = SDL_BUTTON_LEFT;
    event.button.x = x;
    event.button.y = y;
    SDL_PushEvent(&event);
  };
  button(SDL_MOUSEBUTTONDOWN, 1, 1);
  SDL_Event move{};
  move.type = SDL_MOUSEMOTION;
  move.motion.x = kSmallWidth - 2;
  move.motion.y = kSmallHeight - 2;
  SDL_PushEvent(&move);
  button(SDL_MOUSEBUTTONUP, kSmallWidth - 2, kSmallHeight - 2);
  ASSERT_TRUE(viewer->RenderFrame());
  const Projection view(scene.camera, kSmallWidth, kSmallHeight);
  EXPECT_EQ(
      viewer->selection(),
      view.AgentsIn({1, 1}, {static_cast<float>(kSmallWidth - 2), static_cast<float>(kSmallHeight - 2)}, scene.agents));
  EXPECT_GE(viewer->selection().size(), 2u);

  const auto press = [&](int scancode) {
    SDL_Event key{};
    key.type = SDL_KEYDOWN;
    key.key.keysym.scancode = static_cast<SDL_Scancode>(scancode);
    SDL_PushEvent(&key);
    EXPECT_TRUE(viewer->RenderFrame());
  };
  press(SDL_SCANCODE_5);
  EXPECT_TRUE(viewer->IsOn(ViewerCommand::kMapCamera));
  EXPECT_LT(Rotate(viewer->Camera().orientation, {0, 0, -1}).y, -0.99f);
  const Projection map(viewer->Camera(), kSmallWidth, kSmallHeight);
  EXPECT_EQ(map.AgentsIn({0, 0}, {kSmallWidth, kSmallHeight}, scene.agents).size(), scene.agents.size())
      << "a map shows all";
  press(SDL_SCANCODE_4);
  EXPECT_TRUE(viewer->IsOn(ViewerCommand::kEyesCamera));
  EXPECT_LT(world::Distance(viewer->Camera().position, scene.agents[0].position), 30);
  press(SDL_SCANCODE_HOME);
  EXPECT_TRUE(viewer->IsOn(ViewerCommand::kFreeCamera));
  EXPECT_EQ(Projection(viewer->Camera(), kSmallWidth, kSmallHeight)
                .AgentsIn({0, 0}, {kSmallWidth, kSmallHeight}, scene.agents)
                .size(),
            scene.agents.size());
  press(SDL_SCANCODE_TAB);
  EXPECT_EQ(viewer->selection().size(), 1u);
}

TEST_F(PictureTest, MistakesComeBackAsDiagnostics) {
  {
    const auto viewer = OpenHidden();
    ASSERT_NE(viewer, nullptr);
    EXPECT_TRUE(viewer->RenderFrame());
    const auto nowhere = viewer->SaveScreenshot("/no/such/folder/picture.png");
    ASSERT_FALSE(nowhere.ok());
    EXPECT_EQ(nowhere.error().file, "/no/such/folder/picture.png");
    EXPECT_FALSE(viewer->SaveScreenshot("picture.bmp").ok());
    const auto second = Viewer::Open({});
    ASSERT_FALSE(second.ok());
    EXPECT_THAT(second.error().message, HasSubstr("already open"));
  }
  ViewerOptions options;
  options.hidden = true;
  options.media_dir = "/no/media/here";
  const auto none = Viewer::Open(options);
  ASSERT_FALSE(none.ok());
  EXPECT_THAT(none.error().file, HasSubstr("/no/media/here/shaders"));
}

}  // namespace
}  // namespace soarbox::viewer

namespace {

/// A virtual display for the tests, if there is none, until the end of the program.
class VirtualDisplay {
 public:
  VirtualDisplay() {
    int said[2];
    if (pipe(said) != 0) return;
    server_ = fork();
    if (server_ == 0) {
      const std::string number = std::to_string(said[1]);
      close(said[0]);
      // Without -noreset the server restarts after a test has closed its window, and refuses the next one meanwhile.
      execlp("Xvfb", "Xvfb", "-displayfd", number.c_str(), "-screen", "0", "1280x720x24", "-nolisten", "tcp",
             "-noreset", static_cast<char*>(nullptr));
      _exit(127);  // It is not installed; the tests are skipped.
    }
    close(said[1]);
    // The server prints its number when it is ready.
    std::string number;
    for (char digit = 0; read(said[0], &digit, 1) == 1 && digit != '\n';) number += digit;
    close(said[0]);
    if (!number.empty()) setenv("DISPLAY", (":" + number).c_str(), 1);
  }
  ~VirtualDisplay() {
    if (server_ <= 0) return;
    kill(server_, SIGTERM);
    waitpid(server_, nullptr, 0);
  }
  VirtualDisplay(const VirtualDisplay&) = delete;
  VirtualDisplay& operator=(const VirtualDisplay&) = delete;

 private:
  pid_t server_ = -1;
};

}  // namespace

int main(int argc, char** argv) {
  bool only_lists = false;
  for (int i = 1; i < argc; ++i)
    only_lists = only_lists || std::string(argv[i]).find("list_tests") != std::string::npos;
  std::optional<VirtualDisplay> display;
  if (std::getenv("DISPLAY") == nullptr && !only_lists) display.emplace();
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
