// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <stdlib.h>

#include <cstdint>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "bytes/byte_stream.h"
#include "record/header.h"
#include "record/tick_codec.h"

namespace soarbox::record {

/// For tests: a folder that is removed with this object.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "soarbox-recording-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~ScratchFolder() { std::filesystem::remove_all(path_); }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline Header SomeHeader() {
  Header header;
  header.build = BuildId();
  header.scenario = "thesis";
  header.folder = "/somewhere";
  header.extra_folders = {"/a", "/b"};
  header.scenario_digest = 0x123456789abcdef0;
  header.seed = 77;
  header.level = Level::kAll;
  header.has_origins = true;
  header.files = {{0, "scout.soar", "sp {a (state <s>) --> (halt)}\n"}, {1, "more/x.lua", ""}};
  header.replaced_rules = {{"scout", "/a/better.soar"}};
  header.branched_from = "/somewhere/run.soarrec";
  header.branch_tick = 17;
  return header;
}

/// Ticks of a random world in which bodies are created, moved and removed, and events occur.
inline std::vector<TickRecord> SomeTicks(std::size_t count, std::uint32_t seed = 1) {
  std::mt19937 random(seed);
  const auto chance = [&](unsigned one_in) { return random() % one_in == 0; };
  const auto number = [&] { return static_cast<float>(random() % 1000) / 7.0f; };
  std::vector<TickRecord> ticks;
  TickRecord tick;
  std::uint32_t next_id = 1;
  for (std::size_t i = 0; i < count; ++i) {
    tick.tick = tick.scene.tick = i;
    tick.scene.time_s = static_cast<double>(i) / 30;
    tick.state_hash = (static_cast<std::uint64_t>(random()) << 32) | random();
    tick.inputs.clear();
    tick.events.clear();
    tick.minds.clear();
    world::SharedList<world::DrawableSnapshot>& drawables = tick.scene.drawables;
    // More than one block of them.
    for (int boxes = i == 0 ? 40 : static_cast<int>(chance(9)); boxes > 0; --boxes) {
      world::DrawableSnapshot box;
      box.id = next_id;
      box.mesh = "models/box" + std::to_string(next_id) + ".mesh";
      drawables.push_back(std::move(box));
      if (boxes > 1) {
        ++next_id;
        continue;
      }
      world::AgentSnapshot& agent = tick.scene.agents.emplace_back();
      agent.id = next_id++;
      agent.name = "agent" + std::to_string(agent.id);
    }
    if (drawables.size() > 3 && chance(11)) drawables.Erase(drawables.Find(drawables[random() % drawables.size()].id));
    for (auto at = drawables.Find(0); !drawables.IsEnd(at); at = drawables.After(at))
      if (at.block != i % 3 && chance(2)) drawables.Edit(at).position = {number(), number(), number()};
    for (world::AgentSnapshot& agent : tick.scene.agents)
      if (chance(2)) agent.velocity = {number(), 0, number()};
    if (chance(5))
      tick.scene.lines = {{{1, 2, 3}, {4, 5, 6}, {}}};
    else
      tick.scene.lines.clear();
    tick.scene.circles.clear();
    if (chance(5)) tick.scene.circles = {{{number(), 1, 2}, 0.5f, {1, 0, 0, 1}}, {{3, 2, 1}, number(), {}}};
    if (chance(7)) tick.inputs = {"key space_key down", "key space_key up"};
    if (chance(6)) {
      sim::RunEvent event;
      event.kind = sim::EventKind::kCommand;
      event.tick = i;
      event.agent = "agent1";
      event.text = "seek";
      event.position = {1, 2, 3};
      tick.events.push_back(event);
      event.values = sim::Speech{"team red", "contact", "^about contact"};
      tick.events.push_back(event);
      event.values = sim::CheckReport{"it arrives", "it stands still", "agent1", true};
      tick.events.push_back(event);
      event.values = {};
      event.kind = sim::EventKind::kDiagnostic;
      event.diagnostic.file = "x.soar";
      event.diagnostic.line = 3;
      event.diagnostic.message = "something is wrong";
      tick.events.push_back(event);
    }
    if (chance(3)) {
      MindRecord& mind = tick.minds.emplace_back();
      mind.agent = "agent1";
      mind.events.Add(mind::PerceptChanged{"self.", "speed", 0, 3.5});
      mind.events.Add(mind::OperatorSelected{1, "O1", "seek", {}});
      mind.events.Add(mind::RuleFired{"seek*apply", false});
      mind.events.Add(mind::CommandSaid{12, "seek", "seek*apply", {{0, false, "target", "red-1"}}});
    }
    ticks.push_back(tick);
  }
  return ticks;
}

/// All data of a record as bytes.
inline std::string Bytes(const TickRecord& tick) {
  std::string bytes;
  BufferedWriter out(bytes);
  MindsEncoder minds;
  WriteTick(out, {}, tick, minds);
  out.Flush();
  return bytes;
}
}  // namespace soarbox::record
