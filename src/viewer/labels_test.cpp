// SPDX-License-Identifier: BSD-2-Clause
// Labels and bubbles do not overlap and stay inside the picture: in a real fight, and in a crowd of hundreds. Needs no
// display: only the sizes of letters come from ImGui.
#include "viewer/labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "sim/simulation.h"
#include "viewer/camera_rig.h"

namespace soarbox::viewer {
namespace {

using Kind = ShownLabel::Kind;
using world::Vec3;

/// A picture without a window, with the window's fonts at a text size.
class Paper {
 public:
  Paper(int width, int height, float text_scale) : width_(width), height_(height) {
    context_ = ImGui::CreateContext();
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    ImFontConfig config;
    config.SizePixels = std::round(15 * text_scale);
    font_ = io.Fonts->AddFontDefault(&config);
    unsigned char* pixels = nullptr;
    int x = 0, y = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &x, &y);
  }
  ~Paper() { ImGui::DestroyContext(context_); }
  Paper(const Paper&) = delete;
  Paper& operator=(const Paper&) = delete;

  const std::vector<ShownLabel>& Draw(const LabelScene& scene, const world::CameraSnapshot& camera) {
    ImGui::SetCurrentContext(context_);
    ImGui::GetIO().DeltaTime = 1.0f / 60;
    ImGui::NewFrame();
    labels_.Draw(font_, font_, scene, camera, Projection(camera, width_, height_));
    ImGui::EndFrame();
    return labels_.shown();
  }
  const AgentLabels& labels() const { return labels_; }
  float aspect() const { return static_cast<float>(width_) / static_cast<float>(height_); }
  ScreenBox edge() const { return {0, 0, static_cast<float>(width_), static_cast<float>(height_)}; }

 private:
  int width_, height_;
  ImGuiContext* context_ = nullptr;
  ImFont* font_ = nullptr;
  AgentLabels labels_;
};

void ExpectClear(const std::vector<ShownLabel>& shown, const ScreenBox& edge, const std::string& where) {
  for (std::size_t i = 0; i < shown.size(); ++i) {
    EXPECT_TRUE(Holds(edge, shown[i].box)) << where << ": label " << i << " is cut";
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(Meet(shown[i].box, shown[j].box)) << where << ": labels " << i << " and " << j;
  }
}

std::size_t Count(const std::vector<ShownLabel>& shown, Kind kind) {
  return static_cast<std::size_t>(
      std::count_if(shown.begin(), shown.end(), [kind](const ShownLabel& label) { return label.kind == kind; }));
}

world::CameraSnapshot Framing(const std::vector<world::AgentSnapshot>& agents, float aspect) {
  std::vector<const world::AgentSnapshot*> all;
  for (const auto& agent : agents) all.push_back(&agent);
  CameraRig rig;
  rig.Frame(all, aspect, true);
  rig.Arrive();
  return rig.pose();
}

TEST(Labels, KeepApartAndWholeInAFightAtEverySizeOfThePicture) {
  const std::string root = SOARBOX_SOURCE_DIR;
  const sim::Scenario scenario = sim::FindScenario("soar_skirmish", {root + "/scenarios", root + "/media"}).value();
  const auto simulation = std::move(sim::Simulation::Create(scenario, {}).value());
  Paper small(1280, 720, 1), small_with_large_text(1280, 720, 1.5f), large(2560, 1440, 1.5f), tiny(640, 360, 2);
  std::size_t bubbles = 0;
  for (int tick = 1; tick <= 270; ++tick) {
    simulation->Tick();
    simulation->TakeEvents();
    if (tick % 30 != 0) continue;
    const world::SceneSnapshot scene = simulation->Snapshot();
    const world::OverlaySnapshot overlays = simulation->Overlays({});
    const std::vector<std::uint32_t> selection{scene.agents[1].id};
    for (Paper* paper : {&small, &small_with_large_text, &large, &tiny}) {
      const auto& shown = paper->Draw({scene.agents, overlays, selection}, Framing(scene.agents, paper->aspect()));
      std::string where = std::to_string(static_cast<int>(paper->edge().right));
      where.append(" px wide at tick ").append(std::to_string(tick));
      ExpectClear(shown, paper->edge(), where);
      EXPECT_GE(Count(shown, Kind::kName) + Count(shown, Kind::kDot), 4u) << where;
      EXPECT_TRUE(std::any_of(
          shown.begin(), shown.end(),
          [&](const ShownLabel& label) { return label.kind == Kind::kName && label.agent_id == selection[0]; }))
          << "the selected one has no name: " << where;
      bubbles += Count(shown, Kind::kSpeech);
    }
  }
  EXPECT_GT(bubbles, 12u);
}

/// A crowd of two teams on a grid a metre wide.
std::vector<world::AgentSnapshot> Crowd(int count) {
  std::vector<world::AgentSnapshot> agents;
  for (int i = 0; i < count; ++i) {
    world::AgentSnapshot& agent = agents.emplace_back();
    agent.id = static_cast<std::uint32_t>(i + 1);
    agent.name = "soldier-" + std::to_string(i);
    agent.team = i % 2 == 0 ? "blue" : "red";
    agent.last_command = "take-cover";
    agent.position = {static_cast<float>(i % 20), 0.9f, static_cast<float>(i / 20)};
  }
  return agents;
}

TEST(Labels, StandForTheirAgents) {
  const std::vector<world::AgentSnapshot> agents = Crowd(9);
  const world::OverlaySnapshot overlays;
  const std::vector<std::uint32_t> selection;
  Paper paper(1280, 720, 1);
  const std::vector<ShownLabel> shown = paper.Draw({agents, overlays, selection}, Framing(agents, paper.aspect()));
  ASSERT_GE(Count(shown, Kind::kName), 5u);
  for (const ShownLabel& label : shown) {
    const ScreenPoint middle{(label.box.left + label.box.right) / 2, (label.box.top + label.box.bottom) / 2};
    EXPECT_EQ(paper.labels().AgentAt(middle), label.agent_id);
  }
  EXPECT_EQ(paper.labels().AgentAt({2, 2}), 0u);
}

TEST(Labels, OfACrowdTheNearHaveNamesAndTheOthersDots) {
  const std::vector<world::AgentSnapshot> agents = Crowd(200);
  world::OverlaySnapshot overlays;
  for (std::uint32_t id = 1; id <= 40; ++id)
    overlays.speech.push_back({id, 0, "contact " + std::to_string(id % 7), 0.1});
  Paper paper(1280, 720, 1);
  const std::vector<std::uint32_t> selection{101, 150};
  const LabelScene wanted{agents, overlays, selection, 42};
  const world::CameraSnapshot camera = Framing(agents, paper.aspect());
  const std::vector<ShownLabel> shown = paper.Draw(wanted, camera);
  ExpectClear(shown, paper.edge(), "200 agents");
  EXPECT_GE(Count(shown, Kind::kName), 10u);
  EXPECT_GE(Count(shown, Kind::kDot), 60u);
  EXPECT_GE(Count(shown, Kind::kSpeech), 1u);
  for (const std::uint32_t id : {101u, 150u, 42u})
    EXPECT_TRUE(std::any_of(shown.begin(), shown.end(), [id](const ShownLabel& l) {
      return l.kind == Kind::kName && l.agent_id == id;
    })) << id;

  // No agent moved, so no label moves.
  const std::vector<ShownLabel> again = paper.Draw(wanted, camera);
  const std::vector<ShownLabel> settled = paper.Draw(wanted, camera);
  ASSERT_EQ(again.size(), settled.size());
  for (std::size_t i = 0; i < again.size(); ++i) EXPECT_EQ(again[i].box, settled[i].box);
}

TEST(Labels, KeepOutOfWhatIsBlocked) {
  const std::vector<world::AgentSnapshot> agents = Crowd(12);
  const world::OverlaySnapshot overlays;
  const std::vector<std::uint32_t> nobody;
  Paper paper(800, 600, 1);
  const ScreenBox blocked[] = {{0, 0, 380, 600}, {380, 0, 800, 26}};
  LabelScene wanted{agents, overlays, nobody};
  wanted.blocked = blocked;
  const auto& shown = paper.Draw(wanted, Framing(agents, paper.aspect()));
  ASSERT_FALSE(shown.empty());
  for (const ShownLabel& label : shown)
    for (const ScreenBox& box : blocked) EXPECT_FALSE(Meet(label.box, box));
}

TEST(Labels, SeveralWhoSayTheSameShareABubbleAndLongNamesAreCutBetweenLetters) {
  std::vector<world::AgentSnapshot> agents = Crowd(3);
  agents[0].name = std::string(38, 'a') + "\xc3\xa9\xc3\xa9\xc3\xa9";
  EXPECT_EQ(LabelName(agents[0]), std::string(38, 'a') + "\xe2\x80\xa6");
  world::OverlaySnapshot overlays;
  for (std::uint32_t id = 1; id <= 3; ++id) overlays.speech.push_back({id, 0, "enemy in sight", 0.1});
  const std::vector<std::uint32_t> nobody;
  Paper paper(1280, 720, 1);
  const auto& shown = paper.Draw({agents, overlays, nobody}, Framing(Crowd(60), paper.aspect()));
  EXPECT_EQ(Count(shown, Kind::kSpeech), 1u);
  EXPECT_EQ(Count(shown, Kind::kName), 3u);
}

}  // namespace
}  // namespace soarbox::viewer
