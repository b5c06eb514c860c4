// SPDX-License-Identifier: BSD-2-Clause
#include "app/scene_report.h"

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>
#include <vector>

#include "app/shape_contents.h"
#include "bytes/base64.h"
#include "debugger/recorded_mind.h"
#include "debugger/run_models.h"
#include "diagnostics/json_text.h"
#include "record/reader.h"
#include "record/rerun.h"
#include "stream/deflate.h"
#include "stream/scene_encoder.h"
#include "workbench/checks.h"
#include "workbench/contents_json.h"

namespace soarbox::app {
namespace {

using Json = nlohmann::ordered_json;

/// Maximum sizes of the scene and of the compressed contents, before they are encoded as text.
constexpr std::size_t kMostSceneBytes = 5u << 19, kMostContentsBytes = 1u << 20;
/// Intervals of the scene and of the contents if the size permits.
constexpr double kSceneEvery_s = 0.1, kContentsEvery_s = 0.5, kWholeEvery_s = 4;

/// Iterates over the moments of a recording at the requested intervals; skips damaged ones.
class Moments {
 public:
  Moments(record::Reader& recording, std::uint64_t scene_every, std::uint64_t contents_every)
      : recording_(recording), scene_every_(scene_every), contents_every_(contents_every), encoder_(Settings()) {}

  void Read() {
    const std::uint64_t first = recording_.first_tick(), last = recording_.last_tick();
    for (std::uint64_t tick = first; tick <= last; ++tick) {
      const Result<const record::TickRecord*> record = recording_.At(tick);
      if (!record) continue;
      Learn(**record);
      const bool is_end = tick == last;
      if ((tick - first) % scene_every_ == 0 || is_end) AddScene(tick, (*record)->scene);
      if ((tick - first) % contents_every_ == 0 || is_end) AddContents(tick, **record);
    }
  }

  std::size_t scene_bytes() const { return scene_bytes_; }
  std::size_t contents_bytes() const { return contents_bytes_; }
  Json TakeScene() { return std::move(scene_); }
  Json TakeContents() { return std::move(contents_); }

 private:
  static stream::SceneEncoder::Settings Settings() {
    stream::SceneEncoder::Settings settings;
    settings.full_every_s = kWholeEvery_s;
    return settings;
  }

  void Learn(const record::TickRecord& record) {
    models_.Add(record);
    recorded_.Add(record);
    for (const sim::RunEvent& event : record.events) workbench::NoteCheck(event, shown_.checks);
  }

  void AddScene(std::uint64_t tick, const world::SceneSnapshot& scene) {
    for (ShapeContents::Told& told : shapes_.New(scene))
      contents_.push_back({{"tick", tick}, {"agent", ""}, {"name", told.name}, {"content", std::move(told.content)}});
    const stream::Block block = encoder_.Encode(scene);
    scene_bytes_ += block.bytes.size();
    scene_.push_back({{"tick", tick}, {"full", block.is_full}, {"block", ToBase64(block.bytes)}});
  }

  /// Contents that do not belong to one mind are stored under "", others under the agent's name.
  void AddContents(std::uint64_t tick, const record::TickRecord& record) {
    shown_.moment.shown_tick = tick;
    shown_.agent.clear();
    shown_.has_mind = false;
    shown_.agent_count = record.scene.agents.size();
    shown_.agents = debugger::ListAgents(record, models_.timeline, models_.troubles);
    shown_.timeline = &models_.timeline;
    shown_.messages = &models_.messages;
    shown_.trace = &models_.trace;
    for (const char* const name : {"agents", "messages", "mission"}) Tell(tick, "", name);
    // These contain a span of time, so they are not stored for each moment.
    constexpr std::uint64_t kLongEvery = 40;
    if (contents_told_++ % kLongEvery == 0 || tick == recording_.last_tick())
      for (const char* const name : {"timeline", "trace"}) Tell(tick, "", name);
    for (const debugger::AgentRow& agent : shown_.agents) {
      const debugger::RecordedMind* recorded = recorded_.Find(agent.name);
      const std::unique_ptr<explain::Inspector> mind = recorded_.Inspect(agent.name);
      if (recorded == nullptr || mind == nullptr) continue;
      shown_.agent = agent.name;
      shown_.has_mind = true;
      shown_.stack = debugger::LookAtStack(*mind);
      shown_.operators = debugger::LookAtOperators(*mind, {});
      shown_.why = {"Why does " + agent.name + " do what it does?", debugger::WhyRecorded(*recorded, agent.name)};
      for (const char* const name : {"mind", "why"}) Tell(tick, agent.name, name);
      shown_.imagery = debugger::LookAtImagery(*mind);
      if (shown_.imagery.scenes.empty()) continue;
      shown_.shapes = debugger::ShapesOf(shown_.imagery, {});
      for (const char* const name : {"imagery", "ghosts"}) Tell(tick, agent.name, name);
    }
  }

  /// Stores contents only when they have changed.
  void Tell(std::uint64_t tick, const std::string& agent, const char* name) {
    Json content = workbench::PageJson(shown_, name);
    // A page draws the lines of the selected answer.
    if (std::string_view(name) == "imagery") content.update(workbench::ToJson(shown_, name));
    const std::string text = JsonText(content);
    const std::size_t hash = std::hash<std::string>{}(text);
    std::size_t& before = told_[agent + '\0' + name];
    if (before == hash) return;
    before = hash;
    contents_bytes_ += text.size();
    contents_.push_back({{"tick", tick}, {"agent", agent}, {"name", name}, {"content", std::move(content)}});
  }

  record::Reader& recording_;
  std::uint64_t scene_every_, contents_every_;
  stream::SceneEncoder encoder_;
  ShapeContents shapes_;
  debugger::RunModels models_;
  debugger::RecordedMinds recorded_;
  workbench::Contents shown_;
  std::map<std::string, std::size_t> told_;  ///< Hashes of the last stored contents.
  Json scene_ = Json::array(), contents_ = Json::array();
  std::size_t scene_bytes_ = 0, contents_bytes_ = 0;
  std::uint64_t contents_told_ = 0;
};

/// Increases the interval so that the data fit.
std::uint64_t Fewer(std::uint64_t every, std::size_t bytes, std::size_t most) {
  return bytes <= most ? every : every * (1 + bytes * 5 / 4 / most);
}

Json Hello(record::Reader& recording) {
  Json agents = Json::array(), minds = Json::array();
  if (const Result<const record::TickRecord*> first = recording.At(recording.first_tick())) {
    for (const world::AgentSnapshot& agent : (*first)->scene.agents) {
      agents.push_back(agent.name);
      if (record::FindMind(**first, agent.name) != nullptr || agent.kind.starts_with("soar"))
        minds.push_back(agent.name);
    }
  }
  const record::Header& header = recording.header();
  return {{"scenario", header.scenario},
          {"seed", header.seed},
          {"agents", std::move(agents)},
          {"minds", std::move(minds)},
          {"step_s", header.step_s},
          {"turn_ticks", record::TurnTicks(header)},
          {"first_tick", recording.first_tick()},
          {"last_tick", recording.last_tick()}};
}

}  // namespace

Result<std::string> RecordedRun(const std::filesystem::path& file) {
  Result<std::unique_ptr<record::Reader>> opened = record::Reader::Open(file);
  if (!opened) return opened.error();
  record::Reader& recording = **opened;
  const auto ticks = [&](double seconds) {
    return std::max<std::uint64_t>(1, static_cast<std::uint64_t>(seconds / recording.header().step_s + 0.5));
  };
  std::uint64_t scene_every = ticks(kSceneEvery_s), contents_every = ticks(kContentsEvery_s);
  Json whole = Hello(recording);
  constexpr int kMostTries = 4;
  for (int tried = 1; tried <= kMostTries; ++tried) {
    Moments moments(recording, scene_every, contents_every);
    moments.Read();
    const std::uint64_t fewer = Fewer(scene_every, moments.scene_bytes(), kMostSceneBytes),
                        fewer_contents = Fewer(contents_every, moments.contents_bytes() / 8, kMostContentsBytes);
    const bool fits = fewer == scene_every && fewer_contents == contents_every;
    scene_every = fewer;
    contents_every = fewer_contents;
    if (!fits && tried < kMostTries) continue;
    whole["scene"] = moments.TakeScene();
    // The contents are repetitive: compressed, they take an eighth.
    whole["contents"] = ToBase64(stream::Deflate(JsonText(moments.TakeContents())));
    break;
  }
  return JsonText(whole);
}

}  // namespace soarbox::app
