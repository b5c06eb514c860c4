// SPDX-License-Identifier: BSD-2-Clause
#include "sim/senses.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "sim/arena.h"
#include "sml_Client.h"

namespace soarbox::sim {
namespace {

/// A watcher that sees all around it, and others.
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
    // Beside each other, so that nobody hides anybody.
    actor.body().SetPosition({3 * static_cast<float>(arena_.actors().size()), 1, z});
    return actor;
  }
  Actor& Add(const std::string& name, const std::string& team, float z) {
    BodyKind kind = BodyKinds().front();
    kind.looks = "capsule";
    return Add(kind, name, team, z);
  }
  /// The watcher's ^agent objects.
  vocabulary::PerceptList Seen() {
    world_.BeginTick();
    world_.PrepareForReaders();
    NoticeOthers(*watcher_);
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

TEST_F(SensesTest, MessagesAreHeardOnceAndForgottenAfterThreeSeconds) {
  std::unique_ptr<sml::Kernel> kernel(sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener));
  InputMirror heard(*kernel->CreateAgent("watcher"));
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
  EXPECT_EQ(changes(), 1u);  // The first one has gone.
  for (int tick = 0; tick < 30; ++tick) world_.BeginTick();
  EXPECT_EQ(changes(), 1u);
  EXPECT_EQ(changes(), 0u);
  kernel->Shutdown();
}

}  // namespace
}  // namespace soarbox::sim
