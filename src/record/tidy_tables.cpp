// SPDX-License-Identifier: BSD-2-Clause
#include "record/tidy_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "record/manifest.h"
#include "record/percept_values.h"
#include "wording/mind_words.h"

namespace soarbox::record {
namespace {

enum Tables : std::size_t { kAgents, kEvents, kPercepts };

Cell Of(float value) {
  return static_cast<double>(value);
}
Cell Of(std::string_view text) {
  return text.empty() ? Cell() : Cell(std::string(text));
}

/// The goal stack of a mind according to the events so far, with the operator of each state.
class MindState {
 public:
  void See(const mind::EventLog& events) {
    decisions_ = 0;
    events.ForEach(mind::Cases{[&](const mind::OperatorSelected& selected) {
                                 Level(selected.level) = selected.name.empty() ? selected.id : selected.name;
                                 ++decisions_;
                               },
                               [&](const mind::StateMade& made) { Level(made.level).clear(); },
                               [&](const mind::StateGone& gone) { KeepLevels(gone.level - 1); }, [](const auto&) {}});
  }
  void Pass() { decisions_ = 0; }
  std::size_t depth() const { return operators_.size(); }
  std::size_t decisions() const { return decisions_; }
  /// The operator of the lowest state that has one.
  std::string_view operator_name() const {
    for (auto at = operators_.rbegin(); at != operators_.rend(); ++at)
      if (!at->empty()) return *at;
    return {};
  }

 private:
  void KeepLevels(int count) {
    operators_.resize(std::min<std::size_t>(operators_.size(), static_cast<std::size_t>(std::max(count, 0))));
  }
  /// The operator of a state. Removes the states below it.
  std::string& Level(int level) {
    const int sound = std::clamp(level, 1, static_cast<int>(mind::kDeepestLevel));
    KeepLevels(sound);
    operators_.resize(static_cast<std::size_t>(sound));
    return operators_.back();
  }
  std::vector<std::string> operators_;
  std::size_t decisions_ = 0;
};

/// Writes the rows of one recording.
class Rows {
 public:
  explicit Rows(TableSink& sink) : sink_(sink) {}

  Result<void> Begin() {
    const Column tick{"tick", kWhole}, time{"time_s"}, agent{"agent", kText};
    if (Result<void> begun = sink_.Begin("agents", {tick,
                                                    time,
                                                    agent,
                                                    {"team", kText},
                                                    {"x_m"},
                                                    {"y_m"},
                                                    {"z_m"},
                                                    {"vx_mps"},
                                                    {"vy_mps"},
                                                    {"vz_mps"},
                                                    {"speed_mps"},
                                                    {"heading_deg"},
                                                    {"health"},
                                                    {"alive", kWhole},
                                                    {"score"},
                                                    {"command", kText},
                                                    {"operator", kText},
                                                    {"depth", kWhole},
                                                    {"decisions", kWhole}});
        !begun)
      return begun;
    if (Result<void> begun = sink_.Begin("events", {tick,
                                                    time,
                                                    agent,
                                                    {"source", kText},
                                                    {"event", kText},
                                                    {"name", kText},
                                                    {"level", kWhole},
                                                    {"value"},
                                                    {"text", kText}});
        !begun)
      return begun;
    return sink_.Begin("percepts",
                       {tick, time, agent, {"percept", kText}, {"change", kText}, {"value"}, {"word", kText}});
  }

  /// `is_in_range`: false for earlier ticks, which only update the states of minds.
  void See(const TickRecord& record, bool is_in_range) {
    for (auto& [agent, mind] : minds_) mind.Pass();
    for (const MindRecord& mind : record.minds) minds_[mind.agent].See(mind.events);
    if (!is_in_range) return;
    for (const world::AgentSnapshot& agent : record.scene.agents) AddAgent(record, agent);
    for (const sim::RunEvent& event : record.events) AddWorldEvent(record, event);
    for (const MindRecord& mind : record.minds) AddMindEvents(record, mind);
  }

  const Result<void>& result() const { return result_; }
  const TidyCounts& counts() const { return counts_; }

 private:
  void Add(std::size_t table, const TickRecord& record, std::string_view agent, std::vector<Cell> cells) {
    if (!result_) return;
    std::vector<Cell> row = {static_cast<std::int64_t>(record.tick), record.scene.time_s, Of(agent)};
    row.insert(row.end(), std::make_move_iterator(cells.begin()), std::make_move_iterator(cells.end()));
    result_ = sink_.Add(table, row);
    ++(table == kAgents ? counts_.agents : table == kEvents ? counts_.events : counts_.percepts);
  }

  void AddAgent(const TickRecord& record, const world::AgentSnapshot& agent) {
    const float heading = std::atan2(agent.forward.x, agent.forward.z) * 180 / std::numbers::pi_v<float>;
    std::vector<Cell> cells = {Of(agent.team),
                               Of(agent.position.x),
                               Of(agent.position.y),
                               Of(agent.position.z),
                               Of(agent.velocity.x),
                               Of(agent.velocity.y),
                               Of(agent.velocity.z),
                               Of(world::Length(agent.velocity)),
                               Of(heading),
                               Of(agent.health),
                               std::int64_t{agent.alive ? 1 : 0},
                               agent.has_score ? Of(agent.score) : Cell(),
                               Of(agent.last_command)};
    const auto mind = minds_.find(agent.name);
    const bool has_mind = mind != minds_.end();
    cells.push_back(has_mind ? Of(mind->second.operator_name()) : Cell());
    cells.push_back(has_mind ? Cell(static_cast<std::int64_t>(mind->second.depth())) : Cell());
    cells.push_back(has_mind ? Cell(static_cast<std::int64_t>(mind->second.decisions())) : Cell());
    Add(kAgents, record, agent.name, std::move(cells));
  }

  struct EventRow {
    std::string_view source, event;
    std::string_view name = {};
    Cell level = {}, value = {};
    std::string text = {};
  };
  void AddEvent(const TickRecord& record, std::string_view agent, const EventRow& event) {
    Add(kEvents, record, agent,
        {Of(event.source), Of(event.event), Of(event.name), event.level, event.value, Of(event.text)});
  }

  void AddWorldEvent(const TickRecord& record, const sim::RunEvent& event) {
    std::string text = event.text;
    if (!event.parameters.empty()) text += " " + event.parameters;
    for (const std::string& remark : sim::Remarks(event)) text += "; " + remark;
    if (!event.diagnostic.message.empty()) text = Format(event.diagnostic);
    while (!text.empty() && text.back() == '\n') text.pop_back();
    AddEvent(record, event.agent, {"world", sim::EventName(event.kind), event.news, {}, {}, std::move(text)});
  }

  void AddPercept(const TickRecord& record, std::string_view agent, std::string path, std::string_view change,
                  const mind::Value& value) {
    Cell number, word;
    std::visit(mind::Cases{[&](std::string_view text) { word = std::string(text); },
                           [&](std::int64_t whole) { number = static_cast<double>(whole); },
                           [&](double real) { number = real; }},
               value);
    if (change == "gone") number = word = Cell();
    Add(kPercepts, record, agent, {std::move(path), Of(change), number, word});
  }

  void AddMindEvents(const TickRecord& record, const MindRecord& mind) {
    const auto add = [&](EventRow row) {
      row.source = "mind";
      AddEvent(record, mind.agent, row);
    };
    const auto level = [](int at) { return Cell(std::int64_t{at}); };
    mind.events.ForEach(mind::Cases{
        [&](const mind::PerceptChanged& e) {
          AddPercept(record, mind.agent, wording::PerceptPath(e.path, e.attribute, e.key), "set", e.value);
        },
        [&](const mind::PerceptGone& e) {
          AddPercept(record, mind.agent, wording::PerceptPath(e.path, e.attribute, e.key), "gone", {});
        },
        [&](const mind::CommandSaid& e) {
          add({{}, "command", e.name, {}, {}, wording::CommandText(e)});
        },
        [&](const mind::CommandEnded& e) {
          add({{},
               "command ended",
               e.name,
               {},
               {},
               std::string(wording::StatusName(e.status)) + (e.fault.empty() ? "" : " " + std::string(e.fault))});
        },
        [&](const mind::OperatorSelected& e) {
          add({{}, "operator", e.name, level(e.level), {}, std::string(e.id)});
        },
        [&](const mind::StateMade& e) {
          add({{},
               e.level > 1 ? "impasse" : "state",
               e.level > 1 ? wording::ReasonName(e.reason) : std::string_view(),
               level(e.level),
               {},
               std::string(e.id)});
        },
        [&](const mind::StateGone& e) {
          add({{}, "state gone", {}, level(e.level), {}, std::string(e.id)});
        },
        [&](const mind::Halted&) {
          add({{}, "halt"});
        },
        [&](const mind::Recalled& e) {
          add({{},
               "recall",
               e.is_episode ? "episode" : "fact",
               level(e.level),
               static_cast<double>(e.number),
               std::string(e.question)});
        },
        [&](const mind::RuleLearned& e) {
          add({{}, "rule learned", e.rule, level(e.level), {}, std::string(e.from)});
        },
        [&](const mind::ValueUpdated& e) {
          add({{}, "value", e.rule, {}, e.value});
        },
        [&](const mind::RewardReceived& e) {
          add({{}, "reward", {}, {}, e.reward});
        },
        [&](const mind::EpisodeEnded&) {
          add({{}, "episode ended"});
        },
        [&](const mind::RuleFired& e) {
          add({{}, e.retracts ? "rule retracted" : "rule fired", e.rule});
        },
        [&](const mind::ElementChanged& e) {
          add({{},
               e.added ? "element added" : "element removed",
               e.attribute,
               {},
               {},
               fmt::format("({} ^{} {}{})", e.id, e.attribute, e.value, e.acceptable ? " +" : "")});
        },
        [](const auto&) {}});
  }

  TableSink& sink_;
  std::map<std::string, MindState, std::less<>> minds_;
  Result<void> result_;
  TidyCounts counts_;
};

}  // namespace

Result<TidyCounts> TidyTables(Reader& recording, TickRange range, TableSink& sink) {
  Rows rows(sink);
  if (const Result<void> begun = rows.Begin(); !begun) return begun.error();
  const Result<void> read = ForEachTick(recording, {recording.first_tick(), range.last}, [&](const TickRecord& record) {
    rows.See(record, record.tick >= range.first);
  });
  if (!read) return read.error();
  if (!rows.result()) return rows.result().error();
  if (const Result<void> finished = sink.Finish(); !finished) return finished.error();
  return rows.counts();
}

Metadata MetadataOf(const Reader& recording) {
  const Header& header = recording.header();
  Metadata entries = {{"recording", recording.file().filename().string()},
                      {"scenario", header.scenario},
                      {"seed", std::to_string(header.seed)},
                      {"level", std::string(NameOf(header.level))},
                      {"step_s", fmt::format("{}", header.step_s)},
                      {"first_tick", std::to_string(recording.first_tick())},
                      {"last_tick", std::to_string(recording.last_tick())},
                      {"build", header.build}};
  if (!header.branched_from.empty()) entries.emplace_back("branched_from", header.branched_from);
  for (auto& entry : EntriesOf(ManifestIn(recording.file()))) {
    const auto is_there = [&](const auto& other) { return other.first == entry.first; };
    if (std::ranges::none_of(entries, is_there)) entries.push_back(std::move(entry));
  }
  return entries;
}

}  // namespace soarbox::record
