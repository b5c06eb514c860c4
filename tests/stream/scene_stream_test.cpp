// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>
#include <zlib.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <memory>

#include "bytes/byte_stream.h"
#include "sim/scenario.h"
#include "sim/simulation.h"
#include "stream/quantise.h"
#include "stream/scene_encoder.h"
#include "world/animation/animator.h"
#include "world/animation/rig.h"

namespace soarbox::stream {
namespace {

using Place = std::array<std::int64_t, 3>;

/// Reads the parts of a stream that these tests compare: texts, and positions of drawables and agents.
class TestReader {
 public:
  struct Thing {
    std::string mesh, material;
    Place place{}, turn{};
    std::size_t bones = 0;
    struct Movement {
      std::uint64_t clip = 0;
      float time_s = 0, weight = 0, speed = 0, weight_per_s = 0;
      friend bool operator==(const Movement&, const Movement&) = default;
    };
    std::vector<Movement> movements;  ///< As sent at moved_at_s.
    double moved_at_s = 0;
    friend bool operator==(const Thing&, const Thing&) = default;
  };
  struct Person {
    std::string name, command;
    Place place{};
    double health = 0;
    friend bool operator==(const Person&, const Person&) = default;
  };

  void Read(const std::string& block) {
    ASSERT_GT(block.size(), 3u);
    ASSERT_EQ(block[0], 0x53);
    ASSERT_EQ(block[1], 1);
    if ((block[2] & 1) != 0) {
      texts.assign(1, "");
      things.clear();
      people.clear();
    }
    std::string payload = block.substr(3);
    if ((block[2] & 2) != 0) {
      std::string plain(1 << 22, '\0');
      uLongf size = plain.size();
      ASSERT_EQ(uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                           reinterpret_cast<const Bytef*>(payload.data()), payload.size()),
                Z_OK);
      payload = plain.substr(0, size);
    }
    ByteReader in(payload);
    tick = in.Number();
    time_s = in.Double();
    for (std::uint64_t count = in.Number(); count > 0; --count) texts.emplace_back(in.Text());
    while (const std::uint8_t tag = in.Byte()) {
      ByteReader section(in.Text());
      if (tag == 3) Things(section);
      if (tag == 4) People(section);
      ASSERT_FALSE(section.failed());
    }
    ASSERT_FALSE(in.failed());
    ASSERT_TRUE(in.AtEnd());
  }

  std::uint64_t tick = 0;
  double time_s = 0;
  std::vector<std::string> texts;
  std::map<std::uint32_t, Thing> things;
  std::map<std::uint32_t, Person> people;

 private:
  static std::int64_t Signed(ByteReader& in) {
    const std::uint64_t n = in.Number();
    return static_cast<std::int64_t>(n >> 1) ^ -static_cast<std::int64_t>(n & 1);
  }
  static void Add(ByteReader& in, Place& to) {
    for (std::int64_t& part : to) part += Signed(in);
  }
  template <typename List>
  static void Remove(ByteReader& in, List& list) {
    std::uint32_t id = 0;
    for (std::uint64_t count = in.Number(); count > 0; --count) {
      id += static_cast<std::uint32_t>(in.Number());
      EXPECT_EQ(list.erase(id), 1u);
    }
  }

  void Things(ByteReader& in) {
    Remove(in, things);
    for (std::uint32_t id = 0; !in.AtEnd() && !in.failed();) {
      id += static_cast<std::uint32_t>(in.Number());
      Thing& thing = things[id];
      const std::uint8_t parts = in.Byte();
      if ((parts & 1) != 0) {
        ByteReader told(in.Text());
        told.Number();
        told.Byte();
        told.Byte();
        thing.mesh = texts.at(told.Number());
        thing.material = texts.at(told.Number());
      }
      if ((parts & 2) != 0) Add(in, thing.place);
      if ((parts & 4) != 0) Add(in, thing.turn);
      if ((parts & 8) != 0) thing.bones = in.Number();
      for (std::size_t i = 0; (parts & 8) != 0 && i < thing.bones; ++i) {
        const std::uint8_t how = in.Byte();
        Place unused{};
        if ((how & 1) != 0) Add(in, unused);
        if ((how & 2) != 0) Add(in, unused);
      }
      if ((parts & 16) == 0) continue;
      thing.movements.resize(in.Number());
      for (Thing::Movement& movement : thing.movements)
        movement = {in.Number(), in.Float(), in.Float(), in.Float(), in.Float()};
      thing.moved_at_s = time_s;
    }
  }
  void People(ByteReader& in) {
    Remove(in, people);
    for (std::uint32_t id = 0; !in.AtEnd() && !in.failed();) {
      id += static_cast<std::uint32_t>(in.Number());
      Person& person = people[id];
      const std::uint8_t parts = in.Byte();
      if ((parts & 1) != 0) {
        ByteReader told(in.Text());
        person.name = texts.at(told.Number());
      }
      if ((parts & 2) != 0) Add(in, person.place);
      Place unused{};
      if ((parts & 4) != 0) Add(in, unused);
      if ((parts & 16) == 0) continue;
      ByteReader state(in.Text());
      person.health = static_cast<double>(Signed(state)) / 10;
      state.Byte();
      person.command = texts.at(state.Number());
    }
  }
};

std::unique_ptr<sim::Simulation> Start(const std::string& name) {
  const std::string root = SOARBOX_SOURCE_DIR;
  auto scenario = sim::FindScenario(root + "/scenarios/" + name, {root + "/scenarios", root + "/media"});
  EXPECT_TRUE(scenario);
  auto made = sim::Simulation::Create(*scenario, {});
  EXPECT_TRUE(made);
  return std::move(*made);
}

Place Rounded(world::Vec3 v) {
  const auto steps = Steps(v, kPerMetre);
  return {steps[0], steps[1], steps[2]};
}

TEST(SceneEncoder, TellsEachMomentToTheMillimetre) {
  const auto simulation = Start("animation");
  SceneEncoder encoder;
  TestReader reader;
  int full = 0;
  for (int i = 0; i < 90; ++i) {
    simulation->Tick();
    const world::SceneSnapshot scene = simulation->Snapshot();
    const world::OverlaySnapshot overlay = simulation->Overlays({});
    const Block block = encoder.Encode(scene, &overlay);
    full += block.is_full ? 1 : 0;
    ASSERT_EQ((block.bytes[2] & 1) != 0, block.is_full);
    ASSERT_NO_FATAL_FAILURE(reader.Read(block.bytes));
    ASSERT_EQ(reader.tick, scene.tick);
    ASSERT_EQ(reader.things.size(), scene.drawables.size());
    for (const world::DrawableSnapshot& drawn : scene.drawables) {
      const TestReader::Thing& thing = reader.things.at(drawn.id);
      ASSERT_EQ(thing.place, Rounded(drawn.position));
      ASSERT_EQ(thing.mesh, drawn.mesh.value());
      ASSERT_EQ(thing.bones, drawn.bones.size());
    }
    ASSERT_EQ(reader.people.size(), scene.agents.size());
    for (const world::AgentSnapshot& agent : scene.agents) {
      ASSERT_EQ(reader.people.at(agent.id).place, Rounded(agent.position));
      ASSERT_EQ(reader.people.at(agent.id).name, agent.name);
      ASSERT_EQ(reader.people.at(agent.id).command, agent.last_command);
    }
  }
  EXPECT_EQ(full, 3);
}

TEST(SceneEncoder, GivesWhoComesLateTheSameAsWhoWasThereFromTheBeginning) {
  const auto simulation = Start("soar_skirmish");
  SceneEncoder encoder;
  TestReader early, late;
  bool has_joined = false;
  for (int i = 0; i < 75; ++i) {
    simulation->Tick();
    const Block block = encoder.Encode(simulation->Snapshot());
    ASSERT_NO_FATAL_FAILURE(early.Read(block.bytes));
    has_joined |= i > 40 && block.is_full;
    if (!has_joined) continue;
    ASSERT_NO_FATAL_FAILURE(late.Read(block.bytes));
    ASSERT_EQ(early.things, late.things);
    ASSERT_EQ(early.people, late.people);
  }
  EXPECT_TRUE(has_joined);
}

TEST(SceneEncoder, WritesWhatIsGoneAndWhatIsNotFinite) {
  world::SceneSnapshot scene;
  for (std::uint32_t id = 1; id <= 3; ++id) {
    world::DrawableSnapshot drawn;
    drawn.id = id;
    drawn.position = {std::nanf(""), INFINITY, 1e30f};
    scene.drawables.push_back(drawn);
  }
  SceneEncoder encoder({.full_every_s = 1e9});
  TestReader reader;
  reader.Read(encoder.Encode(scene).bytes);
  EXPECT_EQ(reader.things.size(), 3u);
  EXPECT_EQ(reader.things.at(2).place, (Place{0, 0, 1 << 30}));
  scene.drawables.Erase(scene.drawables.Find(2));
  const Block block = encoder.Encode(scene);
  EXPECT_FALSE(block.is_full);
  reader.Read(block.bytes);
  EXPECT_EQ(reader.things.size(), 2u);
  EXPECT_FALSE(reader.things.contains(2));
  // After going back in time, and on demand.
  EXPECT_TRUE(encoder.Encode(scene, nullptr, true).is_full);
  scene.time_s = -1;
  EXPECT_TRUE(encoder.Encode(scene).is_full);
}

TEST(SceneEncoder, TakesAtMostTwentyKilobytesASecondForFewAgents) {
  for (const char* name : {"tactics", "soar_skirmish", "crowd"}) {
    const auto simulation = Start(name);
    SceneEncoder encoder;
    std::size_t bytes = 0;
    constexpr int kSeconds = 6;
    for (int i = 0; i < 30 * kSeconds; ++i) {
      simulation->Tick();
      const world::OverlaySnapshot overlay = simulation->Overlays({});
      bytes += encoder.Encode(simulation->Snapshot(), &overlay).bytes.size();
    }
    std::printf("%s: %zu agents, %.2f KB/s\n", name, simulation->Snapshot().agents.size(),
                static_cast<double>(bytes) / kSeconds / 1000);
    EXPECT_LE(bytes / kSeconds, 20'000u) << name;
    EXPECT_GT(bytes, 1000u) << name;
  }
}

TEST(SceneEncoder, TakesAtMost400KilobytesASecondForTwoHundredSoldiers) {
  // Many copies of the soldiers of one scenario, each at another moment of it.
  const auto simulation = Start("tactics");
  std::vector<world::SceneSnapshot> moments;
  for (int i = 0; i < 400; ++i) {
    simulation->Tick();
    moments.push_back(simulation->Snapshot());
  }
  SceneEncoder encoder;
  std::size_t bytes = 0, soldiers = 0;
  constexpr int kSeconds = 5;
  for (std::size_t i = 0; i < 30 * kSeconds; ++i) {
    world::SceneSnapshot scene;
    scene.tick = moments[i].tick;
    scene.time_s = moments[i].time_s;
    std::uint32_t id = 0;
    soldiers = 0;
    for (std::size_t copy = 0; soldiers < 200; ++copy) {
      for (const world::DrawableSnapshot& drawn : moments[i + 7 * copy].drawables) {
        if (!drawn.belongs_to_agent) continue;
        soldiers += drawn.bones.size() > 10 ? 1 : 0;
        world::DrawableSnapshot other = drawn;
        other.id = ++id;
        other.position.x += 3.7f * static_cast<float>(copy);
        scene.drawables.push_back(other);
      }
      for (world::AgentSnapshot agent : moments[i + 7 * copy].agents) {
        agent.id = static_cast<std::uint32_t>(100 * copy) + agent.id;
        agent.name += std::to_string(copy);
        scene.agents.push_back(agent);
      }
    }
    bytes += encoder.Encode(scene).bytes.size();
  }
  std::printf("%zu soldiers: %.1f KB/s\n", soldiers, static_cast<double>(bytes) / kSeconds / 1000);
  EXPECT_GE(soldiers, 200u);
  EXPECT_LE(bytes / kSeconds, 400'000u);
}

world::Clip Nod(const char* name, float length_s) {
  world::BoneMovement movement;
  movement.position = {{0, length_s}, {{0, 0, 0}, {0, 1, 0}}, false};
  return world::Clip({.name = name, .length_s = length_s}, std::vector{movement});
}

/// A page continues the animations of models from files by itself.
TEST(SceneEncoder, SendsTheAnimationsOfModelsOnlyWhenTheyChange) {
  world::Rig made;
  made.model = "nodding.glb#0000000000000001";
  made.skeleton.AddToParent("head", -1, {});
  made.clips = {Nod("slow", 2), Nod("fast", 0.5f)};
  world::KeepRig(made);
  world::Animator animator(*world::FindRig(made.model));
  SceneEncoder encoder({.full_every_s = 100});
  TestReader reader;
  world::SceneSnapshot scene;
  world::DrawableSnapshot drawable;
  drawable.id = 5;
  drawable.mesh = made.model;
  scene.drawables.push_back(drawable);
  constexpr int kTicks = 300;
  constexpr float kStep_s = 1.0f / 30;
  std::size_t sent = 0;
  for (int tick = 0; tick < kTicks; ++tick) {
    if (tick == 20) animator.Play(0, true, 1, 0);
    if (tick == 200) animator.Play(1, false, 0.5f, 0.4f);
    animator.Advance(nullptr, kStep_s);
    scene.tick = static_cast<std::uint64_t>(tick);
    scene.time_s = static_cast<double>(tick) * static_cast<double>(kStep_s);
    scene.drawables.Edit(scene.drawables.Find(5)).bones = world::BodyBones(animator.NowPose());
    const std::vector<TestReader::Thing::Movement> before = reader.things[5].movements;
    reader.Read(encoder.Encode(scene).bytes);
    const TestReader::Thing& thing = reader.things[5];
    sent += thing.movements != before ? 1 : 0;
    const world::Pose pose = animator.NowPose();
    ASSERT_EQ(thing.movements.size(), pose.parts.size()) << tick;
    const auto since_s = static_cast<float>(scene.time_s - thing.moved_at_s);
    for (std::size_t i = 0; i < pose.parts.size(); ++i) {
      EXPECT_EQ(thing.movements[i].clip, pose.parts[i].clip);
      EXPECT_NEAR(thing.movements[i].time_s + thing.movements[i].speed * since_s, pose.parts[i].time_s, 0.005) << tick;
      EXPECT_NEAR(thing.movements[i].weight + thing.movements[i].weight_per_s * since_s, pose.parts[i].weight, 0.02)
          << tick;
    }
  }
  // At its start and once more with its speed, at the ends of loops, and while the two are blended.
  EXPECT_GE(sent, 6u);
  EXPECT_LE(sent, 14u);
  EXPECT_EQ(reader.things[5].bones, 0u);
}

world::SceneSnapshot HandMade() {
  world::SceneSnapshot scene;
  scene.tick = 300;
  scene.time_s = 10;
  scene.sky = "Evening";
  world::DrawableSnapshot box;
  box.id = 4;
  box.shape = world::ShapeKind::kBox;
  box.material = "Soarbox/Crate";
  box.size = {1, 2, 3};
  box.position = {1.5f, -2.25f, 1000};
  scene.drawables.push_back(box);
  world::DrawableSnapshot body;
  body.id = 9;
  body.owner_id = 2;
  body.belongs_to_agent = true;
  body.mesh = "models/of/nobody.mesh";
  body.orientation = {std::sqrt(0.5f), 0, std::sqrt(0.5f), 0};
  body.bones = std::vector<world::BonePose>{{{0, 1, 0}, {}}, {{0.5f, 1, 0}, {0, 1, 0, 0}}};
  scene.drawables.push_back(body);
  world::AgentSnapshot agent;
  agent.id = 2;
  agent.name = "<b>zo\u00eb</b>";
  agent.kind = "soar";
  agent.team = "blue";
  agent.position = {-3, 0, 0.001f};
  agent.health = 62.5f;
  scene.agents.push_back(agent);
  scene.lines.push_back({{0, 0, 0}, {1, 0, -1}, {1, 0, 0, 1}});
  world::UiSnapshot panel;
  panel.id = 3;
  panel.text = "Go";
  panel.material = "badge.png#0123456789abcdef";
  panel.button = "go";
  panel.has_bar = true;
  panel.bar = 0.25f;
  panel.bar_color = {1, 0, 0, 1};
  scene.ui.push_back(panel);
  panel = {};
  panel.id = 4;
  panel.text = "plain";
  scene.ui.push_back(panel);
  world::SoundSnapshot sound;
  sound.id = 7;
  sound.file = "bell.wav#0123456789abcdef";
  sound.volume = 0.5f;
  sound.in_world = true;
  sound.position = {1, 2, 3};
  scene.sounds.push_back(sound);
  return scene;
}

/// The tests of the page read the same bytes (web/src/format/scene_reader.test.ts).
TEST(SceneEncoder, WritesTheBytesThatThePageReads) {
  SceneEncoder encoder({.deflate_above = 1 << 20});
  world::SceneSnapshot scene = HandMade();
  world::OverlaySnapshot overlay;
  overlay.agents.emplace_back().id = 2;
  overlay.agents[0].operator_name = "wander";
  overlay.agents[0].path = {{1, 0, 1}, {2, 0, 1}};
  overlay.speech.push_back({2, 0, "hello", 0.5});
  overlay.places.push_back({world::PlaceSnapshot::Kind::kItem, "medkit", {1, 0.5f, 2}});
  std::string hex;
  const auto add = [&hex](const std::string& bytes) {
    for (const char c : bytes) {
      char text[3];
      std::snprintf(text, sizeof text, "%02x", static_cast<unsigned>(static_cast<unsigned char>(c)));
      hex += text;
    }
    hex += '\n';
  };
  add(encoder.Encode(scene, &overlay).bytes);
  scene.tick = 301;
  scene.time_s = 10.5;
  scene.drawables.Erase(scene.drawables.Find(4));
  scene.drawables.Edit(scene.drawables.Find(9)).position = {0.25f, 0, 0};
  scene.agents[0].alive = false;
  scene.sounds.clear();
  scene.lines.clear();
  overlay.speech.clear();
  add(encoder.Encode(scene, &overlay).bytes);
  const std::string file = std::string(SOARBOX_SOURCE_DIR) + "/tests/stream/scene_blocks.hex";
  if (std::getenv("SOARBOX_WRITE_GOLDEN") != nullptr) std::ofstream(file) << hex;
  std::ifstream in(file);
  const std::string golden{std::istreambuf_iterator<char>(in), {}};
  EXPECT_EQ(hex, golden) << "SOARBOX_WRITE_GOLDEN=1 writes the file anew; the page must read it, too";
}

}  // namespace
}  // namespace soarbox::stream
