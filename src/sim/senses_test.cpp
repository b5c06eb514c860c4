// SPDX-License-Identifier: BSD-2-Clause
#include "sim/senses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "sim/arena.h"
#include "sim/directions.h"
#include "sim/scene_sense.h"
#include "sim/soar_mind.h"
#include "sml_Client.h"
#include "vocabulary/vocabulary_percepts.h"
#include "world/world_random.h"

namespace soarbox::sim {
namespace {

/// A watcher that sees in all directions, and other agents.
class SensesTest : public testing::Test {
 protected:
  SensesTest() {
    BodyKind kind = BodyKinds().front();
    kind.senses.view_deg = 360;
    kind.looks = "capsule";
    watcher_ = &Add(kind, "watcher", "blue", 0);
  }

  Actor& Add(const BodyKind& kind, const std::string& name, const std::string& team, float z) {
    world::AgentDef def;
    def.name = name;
    const world::EntityId id = world_.CreateAgent(def);
    Actor& actor = arena_.Add(id, kind);
    actor.body().SetTeam(team);
    // Side by side, so that none hides another.
    actor.body().SetPosition({3 * static_cast<float>(arena_.actors().size()), 1, z});
    return actor;
  }
  Actor& Add(const std::string& name, const std::string& team, float z) {
    BodyKind kind = BodyKinds().front();
    kind.looks = "capsule";
    return Add(kind, name, team, z);
  }
  /// The ^agent objects of the watcher.
  vocabulary::PerceptList Seen() {
    world_.BeginTick();
    world_.PrepareForReaders();
    Notice(*watcher_);
    vocabulary::PerceptList seen;
    for (const vocabulary::Percept& percept : AllPercepts(*watcher_))
      if (percept.attribute == "agent") seen.push_back(percept);
    return seen;
  }
  static std::string Word(const vocabulary::Percept& object, std::string_view attribute) {
    return *vocabulary::FindPercept(std::get<vocabulary::PerceptList>(object.value), attribute)->Text();
  }

  world::World world_;
  Arena arena_{world_, [](RunEvent) {}};
  Actor* watcher_ = nullptr;
};

TEST_F(SensesTest, OneFriendAndOneEnemyAreTheNearestOfThoseInViewAndAlive) {
  Add("dead", "red", -4).body().SetHealth(0);
  Add("near", "red", -10);
  Add("far", "red", -20);
  Add("friend", "blue", 9);
  std::vector<std::string> nearest;
  for (const vocabulary::Percept& seen : Seen())
    if (Word(seen, "nearest") == "yes") nearest.push_back(Word(seen, "name"));
  EXPECT_EQ(nearest, (std::vector<std::string>{"near", "friend"}));
}

TEST_F(SensesTest, NoMoreFriendsAndEnemiesArePerceivedThanTheSensesTakeInAndTheNearestOnes) {
  BodyKind kind = watcher_->kind();
  kind.senses.most = 1;
  watcher_ = &Add(kind, "busy", "blue", 1);
  Add("far", "red", -20);
  Add("near", "red", -10);
  Add("mate", "blue", 30);
  std::vector<std::string> names;
  for (const vocabulary::Percept& seen : Seen()) names.push_back(Word(seen, "name"));
  EXPECT_EQ(names, (std::vector<std::string>{"watcher", "near"}));
}

TEST_F(SensesTest, AnImaginedSceneIsWhatTheActorKnows) {
  BodyKind kind = watcher_->kind();
  kind.senses.scene = true;
  kind.senses.sight_m = 30;
  kind.senses.hearing_m = 0;
  kind.senses.memory_s = 2;
  watcher_ = &Add(kind, "dreamer", "blue", 1);
  world::Agent& other = Add("some body", "red", -10).body();
  SceneSense scene;
  const auto update = [&] {
    Seen();
    return scene.Update(*watcher_, true);
  };
  const auto has = [](const std::string& lines, const std::string& part) {
    return lines.find(part) != std::string::npos;
  };
  std::string lines = update();
  for (const char* part :
       {"add self world v ", "add eye world v 0 0 0 p ", "add reach world b 1.85 p ", "add some-body world v ",
        "tag change some-body relation enemy\n", "tag change some-body visible yes\n", "add watcher world v "}) {
    EXPECT_TRUE(has(lines, part)) << part << " in\n" << lines;
  }
  EXPECT_EQ(update(), "") << "nothing changed";
  other.SetPosition({9, 1, -12});
  lines = update();
  EXPECT_EQ(lines, "change some-body p 9 1 -12 r 0 0 0\n");
  // Out of view it stays at its last position, and is forgotten after some time.
  other.SetPosition({9, 1, -100});
  EXPECT_EQ(update(), "tag change some-body visible no\n");
  for (int tick = 0; tick < 80; ++tick) Seen();
  EXPECT_EQ(update(), "delete some-body\n");
}

TEST_F(SensesTest, AMindThatImaginesHasTheSceneOfItsBody) {
  std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener));
  sml::Agent* const agent = kernel->CreateAgent("watcher");
  MindSettings settings;
  settings.has_distance = false;
  settings.imagines = true;
  SoarMind mind(*agent, settings);
  Add("other", "red", -10);
  Seen();
  mind.Perceive(*watcher_, true);
  mind.Decide();
  EXPECT_EQ(agent->SVSQuery("list-all-objs"), "objs 5 world self eye reach other\n");
  EXPECT_EQ(agent->SVSQuery("objs-with-flag solid yes"), "objs 1 other\n");
  EXPECT_EQ(agent->GetSVSOutput(), "") << "nothing was refused";
}

TEST_F(SensesTest, MessagesAreHeardOnceAndForgottenAfterThreeSeconds) {
  std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener));
  PerceptLink link(*kernel->CreateAgent("watcher"));
  InputMirror heard(link);
  std::uint32_t last = 0;
  const auto say = [this](const char* about, const char* team) {
    world::Message message;
    message.from = Add("mate", "blue", 3).id();
    message.team = team;
    message.about = about;
    arena_.board().Post(message, world_.tick());
  };
  const auto changes = [&] {
    HearMessages(*watcher_, last, heard);
    return heard.changes();
  };
  constexpr std::size_t kElements = 4;  // The message, and from, about and time.
  world_.BeginTick();
  say("enemy", "blue");
  say("enemy", "red");
  say("order", "blue");
  EXPECT_EQ(changes(), kElements);
  EXPECT_EQ(changes(), 0u);
  for (int tick = 0; tick < 30; ++tick) world_.BeginTick();
  say("food", "blue");
  EXPECT_EQ(changes(), kElements);
  for (int tick = 0; tick < 61; ++tick) world_.BeginTick();
  EXPECT_EQ(changes(), 1u);  // The first was removed.
  for (int tick = 0; tick < 30; ++tick) world_.BeginTick();
  EXPECT_EQ(changes(), 1u);
  EXPECT_EQ(changes(), 0u);
  kernel->Shutdown();
}

TEST(Directions, ABearingToRoundIsTheBearingInWholeDegrees) {
  world::RandomStream random(5, 1);
  const auto any = [&] { return random.Unit() * 2 - 1; };
  for (int i = 0; i < 200'000; ++i) {
    const float reach_m = i % 3 == 0 ? 0.01f : i % 3 == 1 ? 30.0f : 90'000.0f;
    const world::Vec3 from{any() * reach_m, 1, any() * reach_m};
    world::Vec3 forward = i % 5 == 0 ? world::Vec3{any(), any(), any()} : AlongHeading(any() * 180);
    if (i % 1000 == 0) forward = {0, i % 2000 == 0 ? 1.0f : 0.0f, 0};
    // Includes angles close to a half of a degree, and to the front, the back and the sides.
    const float off_deg = std::round(any() * 180) + (i % 2 == 0 ? 0.5f + any() * 0.02f : any() * 0.02f);
    world::Vec3 to = from + AlongHeading(HeadingOf(forward) + off_deg) * (random.Unit() * reach_m);
    if (i % 700 == 0) to = from;
    const auto perceived = [](float bearing_deg) {
      return vocabulary::AsPerceived(vocabulary::RowOf("agent.bearing"), static_cast<double>(bearing_deg));
    };
    ASSERT_EQ(perceived(BearingToRound(from, forward, to)), perceived(BearingOf(from, forward, to))) << i;
  }
}

}  // namespace
}  // namespace soarbox::sim
