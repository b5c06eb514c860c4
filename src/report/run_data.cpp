// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "diagnostics/read_text.h"
#include "mission/check_sentences.h"
#include "mission/gather_facts.h"
#include "mission/testing.h"
#include "record/manifest.h"
#include "record/reader.h"
#include "record/rerun.h"
#include "report/page.h"
#include "report/thin_events.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::report {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kWay_Hz = 5;
constexpr std::size_t kMostMoments = 12;
constexpr std::size_t kMostSamples = 18'000;  ///< An hour at 5 Hz.
/// Maximum number of items kept during the run; above it, every second one is removed.
constexpr std::size_t kMostKept = 400'000;
constexpr std::size_t kMostGaps = 1'000;  ///< Maximum number of moments to choose from.
constexpr std::size_t kLargestText = 240, kLargestName = 80, kMostReasonLines = 60;

/// Limits for the data of a run. They are halved until the data fit into the page.
struct Budget {
  std::size_t samples = 181'000;  ///< Total of all agents: an hour of ten agents.
  std::size_t event_bytes = 2'500'000;
  std::size_t spans = 20'000;    ///< If there are more, spans that are too narrow to be visible are merged.
  std::size_t columns = 30'000;  ///< Total of the timelines of all agents.
  std::size_t rules = 12'000;
  std::size_t file_bytes = 1'500'000;

  Budget Half() const { return {samples / 2, event_bytes / 2, spans / 2, columns / 2, rules / 2, file_bytes / 2}; }
};

double Rounded(double value, double to) {
  return std::round(value / to) * to;
}

/// Numbers with few digits halve the size of a page.
Json Short(double value) {
  const double rounded = Rounded(value, 0.01);
  if (rounded == std::floor(rounded)) return static_cast<std::int64_t>(rounded);
  return std::round(value * 100) / 100;
}

std::string TimeText(double seconds) {
  return mission::SecondsText(seconds);
}

/// Collects the data of the page while the run is simulated again.
class RunStory {
 public:
  RunStory(sim::Simulation& simulation, const mission::Mission& mission)
      : simulation_(simulation), mission_(mission), gatherer_(simulation, WantsOf(mission)), evaluator_(mission) {}

  void See(std::uint64_t last_tick) {
    const sim::EventList events = simulation_.TakeEvents();
    const mission::TickFacts& facts = gatherer_.Gather(events);
    evaluator_.Feed(facts);
    if (every_ == 0) {
      const double step_s = static_cast<double>(simulation_.world().settings().step_s);
      every_ = std::max<std::uint64_t>(1, static_cast<std::uint64_t>(std::llround(1 / kWay_Hz / step_s)));
      while (last_tick / every_ > kMostSamples) ++every_;
    }
    if (facts.tick % every_ == 0 || facts.tick == last_tick) Sample(facts);
    for (const sim::RunEvent& event : events) Tell(event);
    for (std::size_t i = 0; i < facts.agents.size(); ++i) Follow(facts, i);
    Ask(facts);
  }

  void Finish() {
    const bool was_decided = evaluator_.IsDecided();
    if (!was_decided) evaluator_.Finish();
    const mission::TickFacts& facts = gatherer_.facts();
    if (!was_decided) Ask(facts);
    for (std::size_t i = 0; i < facts.agents.size(); ++i) {
      Close(i, facts.time_s);
      rules_.push_back(Rules(facts.agents[i].name));
    }
    std::stable_sort(moments_.begin(), moments_.end(),
                     [](const Json& a, const Json& b) { return a["rank"] < b["rank"]; });
    if (moments_.size() > kMostMoments) moments_.resize(kMostMoments);
    std::stable_sort(moments_.begin(), moments_.end(),
                     [](const Json& a, const Json& b) { return a["time"] < b["time"]; });
  }

  /// The data of the page within a budget; `thinned` lists what was left out.
  Json Compose(bool has_mission, const Budget& budget) const {
    const mission::TickFacts& facts = gatherer_.facts();
    Json data, thinned = Json::array();
    const std::size_t count = std::max<std::size_t>(1, facts.agents.size());
    const std::size_t most = std::max<std::size_t>(2, budget.samples / count);
    const std::vector<std::size_t> kept = KeptMoments(times_.size(), (times_.size() + most - 1) / most);
    const double step_s = static_cast<double>(simulation_.world().settings().step_s);
    if (kept.size() < times_.size() || every_ * step_s > 1.01 / kWay_Hz)
      thinned.push_back("Paths, speed and health are drawn from " + std::to_string(kept.size()) + " moments.");
    Json times = Json::array();
    for (const std::size_t at : kept) times.push_back(Short(times_[at]));
    Json agents = Json::array();
    std::size_t rules_left = 0;
    for (std::size_t i = 0; i < facts.agents.size(); ++i) {
      const mission::AgentFacts& agent = facts.agents[i];
      Json& made = agents.emplace_back(Json{{"name", agent.name},
                                            {"team", agent.team},
                                            {"distance", Short(agent.distance)},
                                            {"health", Short(agent.health)},
                                            {"alive", agent.alive},
                                            {"rounds", Short(agent.rounds)},
                                            {"damage", Short(agent.damage)}});
      if (i < ways_.size()) {
        StoryWay way = ThinWay(ways_[i], kept);
        made["from"] = way.from;
        made["x"] = Differences(std::move(way.x_cm));
        made["z"] = Differences(std::move(way.z_cm));
        made["hp"] = Differences(std::move(way.health));
        made["v"] = Differences(std::move(way.speed_dmps));
      }
      const std::size_t shown = std::min(rules_[i].size(), budget.rules / count);
      rules_left += rules_[i].size() - shown;
      Json& rules = made["rules"] = Json::array();
      for (std::size_t rule = 0; rule < shown; ++rule) rules.push_back(rules_[i][rule]);
    }
    if (rules_left > 0) thinned.push_back(std::to_string(rules_left) + " rules are left out.");
    data["times"] = std::move(times);
    data["agents"] = std::move(agents);
    data["spans"] = Spans(budget, facts.time_s, count, thinned);
    data["events"] = Events(budget, thinned);
    data["thinned"] = std::move(thinned);
    data["checks"] = Checks();
    data["moments"] = moments_;
    std::size_t failed = 0, all = 0;
    for (std::size_t i = 0; i < mission_.checks.size(); ++i) {
      // A check for a number of seeds is not decided by one run.
      if (mission_.checks[i].marker || mission_.checks[i].pass) continue;
      ++all;
      failed += evaluator_.verdicts()[i].state == mission::State::kTrue ? 0 : 1;
    }
    data["verdict"] = !has_mission  ? std::string("no checks")
                      : failed == 0 ? "passed: all of " + std::to_string(all) + " checks"
                                    : "failed: " + std::to_string(failed) + " of " + std::to_string(all) + " checks";
    data["passed"] = has_mission ? Json(failed == 0) : Json(nullptr);
    data["waypoints"] = Places(facts.waypoints);
    data["regions"] = Places(facts.regions);
    return data;
  }

 private:
  Json Spans(const Budget& budget, double seconds, std::size_t agents, Json& thinned) const {
    std::vector<StorySpan> spans = spans_;
    if (spans.size() > budget.spans) {
      const std::size_t columns = std::clamp<std::size_t>(budget.columns / agents, 10, 2400);
      spans = MergeSpans(spans, seconds, columns);
      thinned.push_back("Operators of less than " + mission::SecondsText(seconds / static_cast<double>(columns)) +
                        " that follow each other are drawn as one: " + std::to_string(spans.size()) + " bars for " +
                        std::to_string(spans_.size() + spans_lost_) + " operators.");
    }
    Json list = Json::array();
    for (const StorySpan& span : spans)
      list.push_back(Json::array({span.agent, Short(span.from_s), Short(span.to_s), span.name}));
    return list;
  }

  Json Events(const Budget& budget, Json& thinned) const {
    std::vector<StoryEvent> events = events_;
    ThinEvents(events, budget.event_bytes);
    if (const std::size_t all = events_.size() + events_lost_; events.size() < all)
      thinned.push_back("Of " + std::to_string(all) + " events, commands and prints " + std::to_string(events.size()) +
                        " are shown, spread over the run. All events of rare kinds are shown.");
    Json list = Json::array();
    for (const StoryEvent& event : events)
      list.push_back(Json{{"t", Short(event.time_s)}, {"a", event.agent}, {"k", event.kind}, {"text", event.text}});
    return list;
  }

  static Json Places(const std::vector<mission::PlaceFacts>& places) {
    Json list = Json::array();
    for (const mission::PlaceFacts& place : places)
      list.push_back(Json{{"name", place.name},
                          {"x", Short(static_cast<double>(place.center.x))},
                          {"z", Short(static_cast<double>(place.center.z))},
                          {"r", Short(static_cast<double>(place.radius_m))},
                          {"hx", Short(static_cast<double>(place.half_x_m))},
                          {"hz", Short(static_cast<double>(place.half_z_m))}});
    return list;
  }

  void Sample(const mission::TickFacts& facts) {
    times_.push_back(facts.time_s);
    for (std::size_t i = 0; i < facts.agents.size(); ++i) {
      if (ways_.size() <= i) ways_.emplace_back().from = times_.size() - 1;
      const mission::AgentFacts& agent = facts.agents[i];
      const auto whole = [](double value) {
        return static_cast<std::int32_t>(std::lround(std::clamp(value, -2e9, 2e9)));
      };
      ways_[i].x_cm.push_back(whole(100 * static_cast<double>(agent.position.x)));
      ways_[i].z_cm.push_back(whole(100 * static_cast<double>(agent.position.z)));
      ways_[i].health.push_back(whole(agent.health));
      ways_[i].speed_dmps.push_back(whole(10 * agent.speed));
    }
  }

  void Add(double time_s, const std::string& agent, const char* kind, std::string text) {
    if (events_.size() >= kMostKept) {
      std::size_t bytes = 0;
      for (const StoryEvent& event : events_) bytes += event.text.size();
      ThinEvents(events_, bytes / 2);
      events_lost_ += kMostKept - events_.size();
    }
    events_.push_back({time_s, agent, kind, CutText(std::move(text), kLargestText)});
  }

  static std::vector<std::string> TextsOf(const std::vector<explain::Reason>& reasons) {
    std::vector<std::string> texts;
    for (const explain::Reason& reason : reasons) texts.push_back(reason.text);
    return texts;
  }

  void Moment(double time_s, int rank, const std::string& agent, std::string text,
              std::vector<std::string> reasons = {}) {
    Shorten(reasons);
    moments_.push_back(Json{{"time", Short(time_s)},
                            {"time_text", TimeText(time_s)},
                            {"rank", rank},
                            {"agent", agent},
                            {"text", CutText(std::move(text), 2 * kLargestText)},
                            {"reasons", reasons}});
  }

  static void Shorten(std::vector<std::string>& reasons) {
    if (reasons.size() > kMostReasonLines) reasons.resize(kMostReasonLines);
    for (std::string& reason : reasons) reason = CutText(std::move(reason), 2 * kLargestText);
  }

  void Tell(const sim::RunEvent& event) {
    switch (event.kind) {
      case sim::EventKind::kCommand:
        Add(event.time_s, event.agent, "command",
            event.parameters.empty() ? event.text : event.text + " " + event.parameters);
        break;
      case sim::EventKind::kOutcome:
        Add(event.time_s, event.agent, "outcome", event.news + ": " + event.text);
        break;
      case sim::EventKind::kNews:
        Add(event.time_s, event.agent, std::holds_alternative<sim::Speech>(event.values) ? "message" : "news",
            event.news + " " + event.text);
        if (event.news == "dies")
          Moment(event.time_s, 1, event.agent, event.agent + " dies, " + event.text,
                 explain::AccountLines(simulation_.Why(event.agent)));
        if (event.news == "shoots" && !has_shot_)
          Moment(event.time_s, 4, event.agent, event.agent + " fires the first shot",
                 explain::AccountLines(simulation_.Why(event.agent)));
        has_shot_ |= event.news == "shoots";
        break;
      case sim::EventKind::kLog:
        Add(event.time_s, event.agent, "print", event.text);
        break;
      case sim::EventKind::kEnded:
        Add(event.time_s, {}, "end", event.text);
        Moment(event.time_s, 0, {}, event.text + " is reached");
        break;
      case sim::EventKind::kGap:
        Add(event.time_s, event.agent, "gap", event.text);
        if (++gaps_ <= kMostGaps)
          Moment(event.time_s, 3, event.agent, event.agent + ": " + event.text, TextsOf(event.reasons));
        break;
      case sim::EventKind::kDiagnostic:
      case sim::EventKind::kAgentFailed:
      case sim::EventKind::kMindFailed:
        Add(event.time_s, event.agent, "problem", event.diagnostic.message);
        break;
      default:
        break;
    }
  }

  /// Adds operators as spans, and impasses as moments.
  void Follow(const mission::TickFacts& facts, std::size_t index) {
    const mission::AgentFacts& agent = facts.agents[index];
    if (open_.size() <= index) open_.resize(index + 1);
    const std::string now = agent.operators.empty() ? std::string() : agent.operators.back().name;
    if (now != open_[index].first) {
      Close(index, facts.time_s);
      open_[index] = {now, facts.time_s};
    }
    for (const mission::EventFact& event : agent.events) {
      if (event.key != mission::Key::kImpasse) continue;
      Add(facts.time_s, agent.name, "impasse", event.word);
      if (told_.insert(agent.name + "/" + event.word).second)
        Moment(facts.time_s, event.word == "tie" || event.word == "conflict" ? 2 : 5, agent.name,
               agent.name + " meets its first " + event.word + " impasse",
               explain::AccountLines(simulation_.Why(agent.name)));
    }
  }

  void Close(std::size_t index, double time_s) {
    if (index >= open_.size() || open_[index].first.empty()) return;
    if (spans_.size() >= kMostKept) {
      const std::size_t before = spans_.size();
      spans_ = MergeSpans(spans_, time_s, kMostKept / 4);
      if (spans_.size() > kMostKept / 2) spans_.resize(kMostKept / 2);
      spans_lost_ += before - spans_.size();
    }
    spans_.push_back({index, open_[index].second, time_s, CutText(open_[index].first, kLargestName)});
    open_[index].first.clear();
  }

  /// Asks minds for reasons when checks fail.
  void Ask(const mission::TickFacts& facts) {
    if (reasons_.size() < mission_.checks.size()) reasons_.resize(mission_.checks.size());
    for (std::size_t i = 0; i < mission_.checks.size(); ++i) {
      const mission::Verdict& verdict = evaluator_.verdicts()[i];
      if (mission_.checks[i].marker || verdict.tick != facts.tick || verdict.state == mission::State::kTrue ||
          verdict.state == mission::State::kOpen || !reasons_[i].empty() || mission_.checks[i].pass)
        continue;
      std::string agent = verdict.agent;
      if (agent.empty() && mission_.checks[i].agents.size() == 1) agent = mission_.checks[i].agents.front();
      reasons_[i] = mission::ReasonsFor(mission_.checks[i], agent, simulation_);
      Shorten(reasons_[i]);
      Moment(verdict.time_s, 0, agent, mission::Expectation(mission_.checks[i], agent, mission_) + "; " + verdict.was,
             reasons_[i]);
    }
  }

  Json Checks() const {
    Json list = Json::array();
    for (std::size_t i = 0; i < mission_.checks.size(); ++i) {
      const mission::Verdict& verdict = evaluator_.verdicts()[i];
      const bool is_good = verdict.state == mission::State::kTrue;
      std::string text = mission_.checks[i].name;
      const std::optional<int>& pass = mission_.checks[i].pass;
      if (!is_good && pass)
        text += ": " + mission::OverSeeds(*pass);
      else if (!is_good)
        text += ": " + mission::Expectation(mission_.checks[i], verdict.agent, mission_) + "; " + verdict.was;
      list.push_back(Json{{"name", mission_.checks[i].name},
                          {"state", std::string(mission::NameOf(verdict.state))},
                          {"mark", mission_.checks[i].marker ? "moment"
                                   : is_good                 ? "passed"
                                   : pass                    ? "over seeds"
                                                             : "failed"},
                          {"time", Short(verdict.time_s)},
                          {"time_text", TimeText(verdict.time_s)},
                          {"text", text},
                          {"reasons", i < reasons_.size() ? reasons_[i] : std::vector<std::string>{}}});
    }
    return list;
  }

  std::vector<Json> Rules(const std::string& agent) {
    std::vector<Json> list;
    const std::unique_ptr<explain::Inspector> inspector = simulation_.Inspect(agent);
    if (inspector == nullptr) return list;
    for (const explain::RuleFact& rule : inspector->Rules()) {
      Json& made = list.emplace_back(Json{{"name", rule.name}, {"firings", rule.firings}, {"type", rule.type}});
      if (!rule.file.empty()) made["file"] = fs::path(rule.file).filename().string() + ":" + std::to_string(rule.line);
      if (rule.firings > 0) continue;
      const std::optional<explain::MatchFacts> match = inspector->Match(rule.name);
      if (match && match->failing && *match->failing < match->conditions.size())
        made["stops"] =
            CutText("condition " + std::to_string(*match->failing + 1) + " of " +
                        std::to_string(match->conditions.size()) + ": " + match->conditions[*match->failing].text,
                    kLargestText);
    }
    return list;
  }

  static mission::Wants WantsOf(const mission::Mission& mission) {
    mission::Wants wants = mission::WantsOf(mission);
    wants.notes = true;
    return wants;
  }

  sim::Simulation& simulation_;
  const mission::Mission& mission_;
  mission::FactGatherer gatherer_;
  mission::Evaluator evaluator_;
  std::uint64_t every_ = 0;
  std::vector<double> times_;
  std::vector<StorySpan> spans_;
  std::vector<StoryEvent> events_;
  std::size_t spans_lost_ = 0, events_lost_ = 0, gaps_ = 0;  ///< Number of items that were removed during the run.
  std::vector<StoryWay> ways_;
  std::vector<std::vector<Json>> rules_;  ///< By agent.
  std::vector<Json> moments_;
  std::vector<std::pair<std::string, double>> open_;
  std::vector<std::vector<std::string>> reasons_;
  std::set<std::string> told_;
  bool has_shot_ = false;
};

/// Objects on the ground, for the map.
Json Things(const sim::Simulation& simulation) {
  Json list = Json::array();
  const world::SceneSnapshot scene = simulation.Snapshot();
  for (const world::DrawableSnapshot& drawn : scene.drawables) {
    if (drawn.belongs_to_agent || !drawn.visible || list.size() > 2000) continue;
    const bool is_box = drawn.shape == world::ShapeKind::kBox;
    if (!is_box && drawn.shape != world::ShapeKind::kCapsule && drawn.shape != world::ShapeKind::kCylinder) continue;
    const double w = static_cast<double>(is_box ? drawn.size.x : 2 * drawn.size.x),
                 d = static_cast<double>(is_box ? drawn.size.z : 2 * drawn.size.x);
    if (w > 200 || d > 200) continue;
    const double turn = 2 *
                        std::atan2(static_cast<double>(drawn.orientation.y), static_cast<double>(drawn.orientation.w)) *
                        180 / 3.14159265358979;
    list.push_back(Json{{"x", Short(static_cast<double>(drawn.position.x))},
                        {"z", Short(static_cast<double>(drawn.position.z))},
                        {"w", Short(w)},
                        {"d", Short(d)},
                        {"turn", Short(turn)},
                        {"round", !is_box}});
  }
  return list;
}

/// The present checks of the scenario.
mission::Mission MissionOf(const record::Header& header, const sim::DataFolders& data) {
  std::error_code error;
  const fs::path scenario = fs::path(header.folder) / header.scenario;
  const fs::path named = fs::exists(scenario, error) ? scenario : data.scenarios / header.scenario;
  const fs::path folder = fs::is_directory(named, error) ? named : named.parent_path();
  std::vector<fs::path> candidates = {folder / "mission.toml"};
  candidates.push_back(fs::is_directory(named, error) ? folder / "scenario.toml" : named);
  for (const fs::path& file : candidates) {
    if (file.extension() != ".toml" || mission::FindMissionFiles(file, data).empty()) continue;
    std::vector<Diagnostic> problems;
    mission::LoadedMission loaded = mission::LoadMission(file, data, problems);
    if (problems.empty()) return std::move(loaded.mission);
  }
  return {};
}

}  // namespace

Result<std::string> RunData(const fs::path& recording, const sim::DataFolders& data, std::size_t most_bytes) {
  Result<std::unique_ptr<record::Reader>> reader = record::Reader::Open(recording);
  if (!reader) return reader.error();
  const record::Header& header = (*reader)->header();
  record::RerunSettings settings;
  settings.threads = 1;
  Result<record::Rerun> rerun = record::Restart(**reader, data, settings);
  if (!rerun) return rerun.error();
  sim::Simulation& simulation = *rerun->simulation;
  const mission::Mission mission = MissionOf(header, data);
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i)
    simulation.NoteMind(simulation.AgentOfMind(i),
                        mission::WantsOf(mission).firings ? sim::MindDetail::kAll : sim::MindDetail::kDecisions);
  const std::uint64_t last = (*reader)->last_tick();
  RunStory story(simulation, mission);
  story.See(last);
  Json things = Things(simulation);
  while (simulation.tick() < last) {
    simulation.Tick();
    story.See(last);
  }
  Json made{{"kind", "run"}};
  const Result<const record::TickRecord*> end = (*reader)->At(last);
  made["same"] = end.ok() && (*end)->state_hash == simulation.StateHash();
  const std::string name = fs::path(header.scenario).filename() == "scenario.toml"
                               ? fs::path(header.scenario).parent_path().filename().string()
                               : fs::path(header.scenario).filename().string();
  made["title"] = name + ", seed " + std::to_string(header.seed);
  made["scenario"] = header.scenario;
  made["seed"] = header.seed;
  made["build"] = header.build;
  if (Json manifest = Json::parse(record::ManifestIn(recording), nullptr, false); manifest.is_object())
    made["manifest"] = std::move(manifest);
  made["seconds"] = Short(simulation.time_s());
  made["command"] = "soarbox replay " + recording.string();
  made["things"] = std::move(things);
  Json warnings = Json::array();
  for (const Diagnostic& warning : rerun->warnings) warnings.push_back(warning.message);
  made["warnings"] = std::move(warnings);
  std::vector<std::pair<std::string, std::string>> texts;
  std::set<std::string> seen;
  for (const sim::WatchedFile& file : simulation.Files()) {
    if (!seen.insert(file.file.string()).second) continue;
    std::string text = ReadText(file.file).value_or("");
    if (!text.empty()) texts.emplace_back(file.file.filename().string(), std::move(text));
  }
  story.Finish();
  // Reduces the budget until the page is small enough.
  Budget budget;
  while (true) {
    Json whole = made;
    whole.update(story.Compose(!mission.checks.empty(), budget));
    Json files = Json::array();
    std::size_t room = budget.file_bytes;
    for (const auto& [file, text] : texts) {
      if (text.size() > room) {
        whole["thinned"].push_back("The text of " + file + " is left out.");
        continue;
      }
      room -= text.size();
      files.push_back(Json{{"name", file}, {"text", text}});
    }
    whole["files"] = std::move(files);
    std::string json = whole.dump(-1, ' ', false, Json::error_handler_t::replace);
    if (ForScriptElement(json).size() <= most_bytes || budget.samples < 1000) return json;
    budget = budget.Half();
  }
}

}  // namespace soarbox::report
