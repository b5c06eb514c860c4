// SPDX-License-Identifier: BSD-2-Clause
#include "mission/run_mission.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "mission/check_news.h"
#include "mission/check_sentences.h"
#include "mission/endless_rules.h"
#include "mission/gather_facts.h"
#include "record/header.h"
#include "record/manifest.h"
#include "record/recorder.h"
#include "record/writer.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::mission {
namespace {

/// Time for which a failed run continues after all checks are decided, so that a recording shows what follows, in s.
constexpr double kAfterFailure_s = 1;
constexpr std::size_t kMostReasons = 8;
constexpr std::size_t kMostAsked = 5;
constexpr std::size_t kMostProblems = 10;

Wants WantsWithNumbers(const RunSpec& spec) {
  Wants wants = WantsOf(*spec.mission);
  AddWants(spec.measured, wants);
  wants.notes |= spec.to_the_end;
  return wants;
}

/// Adds the texts of a run's first errors and warnings to the result, each text once. Notes whether there was an error.
class ProblemList {
 public:
  void See(const sim::RunEvent& event, RunResult& result) {
    if (!IsProblem(event)) return;
    has_errors_ |= event.diagnostic.severity == Severity::kError;
    const std::string text = ProblemText(event.diagnostic);
    if (result.problems.size() < kMostProblems && std::ranges::find(result.problems, text) == result.problems.end())
      result.problems.push_back(text);
  }
  bool has_errors() const { return has_errors_; }

 private:
  bool has_errors_ = false;
};

sim::SimulationSettings SettingsOf(const RunSpec& spec, const Wants& wants) {
  sim::SimulationSettings settings;
  settings.seed = spec.seed;
  settings.soar.threads = 1;
  if (wants.notes || wants.insight) settings.mind_detail = sim::MindDetail::kDecisions;
  if (wants.firings) settings.mind_detail = sim::MindDetail::kAll;
  if (const std::size_t colon = spec.kernel.rfind(':'); colon != std::string::npos) {
    settings.soar.remote_host = spec.kernel.substr(0, colon);
    std::from_chars(spec.kernel.data() + colon + 1, spec.kernel.data() + spec.kernel.size(), settings.soar.remote_port);
  }
  return settings;
}

Result<std::unique_ptr<sim::Simulation>> Make(const RunSpec& spec, const sim::SimulationSettings& settings) {
  Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(spec.scenario, settings);
  if (!made || !spec.empty_minds) return made;
  for (std::size_t i = 0; i < (*made)->soar_agents(); ++i) {
    const Result<std::string> emptied = (*made)->Command((*made)->AgentOfMind(i), "excise --all");
    if (!emptied) return emptied.error();
  }
  return made;
}

bool TellsAll(sim::Simulation& simulation) {
  for (std::size_t i = 0; i < simulation.soar_agents(); ++i) {
    const auto inspector = simulation.Inspect(simulation.AgentOfMind(i));
    if (inspector != nullptr && !inspector->TellsAll()) return false;
  }
  return true;
}

/// Returns an error message if a check names an agent, a team, an item, a waypoint or a region that the world does not
/// have; else an empty text. Without this message, a check with `never` would pass.
std::string UnknownName(const Mission& mission, const TickFacts& facts) {
  for (const Check& check : mission.checks) {
    const auto is_one = [&](const AgentFacts& agent) {
      return agent.team == check.team ||
             std::any_of(check.agents.begin(), check.agents.end(), [&](const std::string& name) {
               return name == agent.name || name.find('*') != std::string::npos;
             });
    };
    const bool of_agents = !check.team.empty() || !check.agents.empty();
    if (of_agents && std::none_of(facts.agents.begin(), facts.agents.end(), is_one))
      return "there is no " + (check.team.empty() ? "agent '" + check.agents.front() : "team '" + check.team) +
             "' in this scenario (line " + std::to_string(check.line) + ")";
    if (!check.item.empty() && std::none_of(facts.items.begin(), facts.items.end(),
                                            [&](const ItemFacts& item) { return item.name == check.item; }))
      return "there is no item '" + check.item + "' in this scenario (line " + std::to_string(check.line) + ")";
    for (const Condition& condition : check.conditions) {
      const bool is_waypoint = condition.row->names == Names::kWaypoint;
      if (!is_waypoint && condition.row->names != Names::kRegion) continue;
      const std::vector<PlaceFacts>& places = is_waypoint ? facts.waypoints : facts.regions;
      for (const std::string& word : condition.words)
        if (std::none_of(places.begin(), places.end(), [&](const PlaceFacts& place) { return place.name == word; }))
          return std::string("there is no ") + (is_waypoint ? "waypoint '" : "region '") + word +
                 "' in this scenario (line " + std::to_string(condition.line) + ")";
    }
  }
  return {};
}

/// The name of an operator, a command or a rule that a mind is asked about if the check did not become true; empty if
/// the check has none.
std::string TopicOf(const Check& check) {
  for (const Condition& condition : check.conditions) {
    if (condition.words.empty() || condition.words.front().find('*') != std::string::npos) continue;
    if (condition.row->key == Key::kOperator || condition.row->key == Key::kCommand || condition.row->key == Key::kRule)
      return condition.words.front();
  }
  return {};
}

/// Records a run in the file of the RunSpec. If the file cannot be created, `error` gets the reason, IsOpen is false
/// and nothing is recorded.
class Keeper {
 public:
  Keeper(const RunSpec& spec, const sim::SimulationSettings& settings, const sim::Simulation& simulation,
         std::string& error) {
    record::Header header = record::HeaderOf(
        spec.scenario, settings, static_cast<double>(simulation.world().settings().step_s), record::Level::kAll);
    std::error_code failure;
    const std::filesystem::path named =
        spec.scenario.definition.empty() ? spec.scenario.script : spec.scenario.definition;
    header.scenario = std::filesystem::absolute(named, failure).string();
    if (!spec.scenario.rules.empty())
      header.scenario = std::filesystem::absolute(spec.scenario.rules, failure).string();
    for (std::size_t i = 1; i < spec.scenario.rule_folders.size(); ++i)
      header.extra_folders.push_back(std::filesystem::absolute(spec.scenario.rule_folders[i], failure).string());
    std::filesystem::create_directories(spec.recording.parent_path(), failure);
    Result<std::unique_ptr<record::Writer>> writer =
        record::Writer::Create(spec.recording, header, {.manifest = record::ManifestOf(spec.scenario, header)});
    if (!writer) {
      error = writer.error().message;
      return;
    }
    recorder_ = std::make_unique<record::Recorder>(std::move(*writer), record::Level::kAll);
  }
  bool IsOpen() const { return recorder_ != nullptr; }
  void Take(const sim::Simulation& simulation, sim::EventList events) {
    if (recorder_ == nullptr) return;
    if (const Result<void> taken = recorder_->Take(simulation, std::move(events)); !taken) is_good_ = false;
  }
  bool Finish() {
    if (recorder_ == nullptr) return false;
    return recorder_->Finish().ok() && is_good_;
  }

 private:
  std::unique_ptr<record::Recorder> recorder_;
  bool is_good_ = true;
};

/// The time at which the first check failed; infinity if none failed at a certain time. Checks with `never`, `always`
/// or `whenever` fail at a certain time; checks that must become true fail at the time of their `by`, if they have one.
double FirstFailure(const Mission& mission, const RunResult& result) {
  double first_s = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < mission.checks.size() && i < result.checks.size(); ++i) {
    const Check& check = mission.checks[i];
    const Verdict& verdict = result.checks[i].verdict;
    if (check.marker || verdict.state != State::kFalse) continue;
    if (check.mode == Mode::kNever || check.mode == Mode::kAlways || check.mode == Mode::kWhenever)
      first_s = std::min(first_s, verdict.time_s);
    else if (check.mode == Mode::kComesTrue && check.by_s)
      first_s = std::min(first_s, *check.by_s);
  }
  return first_s;
}

/// Runs the mission again with all details recorded. Queries the minds at the moments when checks were decided,
/// explains what went wrong if that is requested, and records the run if the RunSpec has a file for it.
void TellWhy(const RunSpec& spec, RunResult& result) {
  Wants wants = WantsOf(*spec.mission);
  wants.firings = true;
  const sim::SimulationSettings settings = SettingsOf(spec, wants);
  Result<std::unique_ptr<sim::Simulation>> made = Make(spec, settings);
  if (!made) return;
  sim::Simulation& simulation = **made;
  std::string error;
  std::optional<Keeper> keeper;
  if (!spec.recording.empty()) keeper.emplace(spec, settings, simulation, error);
  if (keeper && !keeper->IsOpen()) result.error = "the recording was not kept: " + error;
  Account account(simulation, spec.account);
  // The recording also contains the checks, like that of a run in a window.
  const auto keep = [&] {
    sim::EventList events = simulation.TakeEvents();
    if (spec.account.IsAsked()) account.See(events);
    if (!keeper) return;
    const std::uint64_t tick = simulation.tick();
    for (std::size_t i = 0; i < spec.mission->checks.size() && i < result.checks.size(); ++i) {
      const Verdict& verdict = result.checks[i].verdict;
      const bool is_decided = verdict.state != State::kOpen && verdict.tick == tick;
      if (tick == 0) events.push_back(CheckNews(*spec.mission, i, {}, tick, simulation.time_s()));
      if (is_decided) events.push_back(CheckNews(*spec.mission, i, verdict, tick, simulation.time_s()));
    }
    keeper->Take(simulation, std::move(events));
  };
  keep();
  std::size_t asked = 0;
  const auto ask = [&] {
    for (std::size_t i = 0; i < spec.mission->checks.size() && i < result.checks.size(); ++i) {
      CheckResult& check = result.checks[i];
      if (check.verdict.state == State::kTrue || check.verdict.state == State::kOpen ||
          check.verdict.tick != simulation.tick())
        continue;
      if (spec.mission->checks[i].marker || asked++ >= kMostAsked) continue;
      std::string agent = check.verdict.agent;
      if (agent.empty() && spec.mission->checks[i].agents.size() == 1) agent = spec.mission->checks[i].agents.front();
      check.reasons = ReasonsFor(spec.mission->checks[i], agent, simulation);
    }
  };
  while (simulation.tick() < result.ticks) {
    simulation.Tick();
    keep();
    ask();
  }
  if (simulation.StateHash() != result.state_hash)
    result.error = "the same run reached another state when it was repeated: this is a bug in Soarbox";
  if (keeper && keeper->Finish()) result.recording = spec.recording.string();
  if (spec.account.IsAsked()) result.account = account.Finish(FirstFailure(*spec.mission, result));
}

}  // namespace

bool AsksForProblems(const Mission& mission) {
  return std::ranges::any_of(mission.checks, [](const Check& check) {
    return std::ranges::any_of(check.conditions,
                               [](const Condition& condition) { return condition.row->key == Key::kProblem; });
  });
}

std::vector<std::string> ReasonsFor(const Check& check, const std::string& agent, sim::Simulation& simulation) {
  std::vector<std::string> lines;
  if (agent.empty()) return lines;
  const std::string topic = TopicOf(check);
  if (!topic.empty()) {
    if (const Result<std::vector<explain::WhyNode>> why = simulation.WhyTopic(agent, topic)) {
      for (const explain::WhyNode& node : *why) {
        const std::vector<std::string> more = explain::Lines(node, 1);
        lines.insert(lines.end(), more.begin(), more.end());
      }
    }
  }
  if (lines.empty()) lines = explain::AccountLines(simulation.Why(agent));
  if (lines.size() > kMostReasons) {
    lines.resize(kMostReasons);
    lines.emplace_back("...");
  }
  return lines;
}

bool RunResult::IsUndecided() const {
  return std::any_of(checks.begin(), checks.end(),
                     [](const CheckResult& check) { return check.verdict.state == State::kUndecided; });
}

bool RunResult::IsJudged() const {
  return passed || std::any_of(checks.begin(), checks.end(), [](const CheckResult& check) {
           return check.verdict.state != State::kTrue && check.verdict.state != State::kUndecided;
         });
}

std::optional<double> RunResult::NumberOf(const std::string& name) const {
  if (const auto at = numbers.find(name); at != numbers.end()) return at->second;
  const bool is_told = numbers.contains("firings");
  if (!is_told && (name == "firings" || name == "learned" || name.starts_with("impasses_"))) return std::nullopt;
  return 0;
}

RunResult RunOnce(const RunSpec& spec, const OnFacts& on_facts) {
  RunResult result;
  result.seed = spec.seed;
  const Mission& mission = *spec.mission;
  const Wants wants = WantsWithNumbers(spec);
  const sim::SimulationSettings settings = SettingsOf(spec, wants);
  Result<std::unique_ptr<sim::Simulation>> made = Make(spec, settings);
  if (!made) {
    result.outcome = "refused";
    result.error = Format(made.error());
    return result;
  }
  sim::Simulation& simulation = **made;
  FactGatherer gatherer(simulation, wants);
  const bool tells_all = TellsAll(simulation);
  Evaluator evaluator(mission, tells_all);
  std::map<std::string, double>& numbers = result.numbers;
  ProblemList problems;
  const auto count = [&](const sim::EventList& events, const TickFacts& facts) {
    for (const sim::RunEvent& event : events) {
      problems.See(event, result);
      // From now on the minds do nothing, so the rest of the run would not show their behaviour.
      if (event.kind == sim::EventKind::kMindLost && result.outcome == "ok") {
        result.outcome = "crashed";
        result.error = "the kernel at " + spec.kernel + " was lost: " + event.text;
      }
      numbers["commands"] += event.kind == sim::EventKind::kCommand ? 1 : 0;
      numbers["failed_commands"] += event.kind == sim::EventKind::kOutcome && event.text.starts_with("error") ? 1 : 0;
      numbers["gaps"] += event.kind == sim::EventKind::kGap ? 1 : 0;
      numbers["problems"] += IsProblem(event) && event.diagnostic.severity == Severity::kError ? 1 : 0;
    }
    for (const AgentFacts& agent : facts.agents) {
      for (const EventFact& event : agent.events) {
        if (event.key == Key::kImpasse) numbers["impasses_" + event.word] += 1;
        if (event.key == Key::kCollides) numbers["collisions"] += 1;
        if (event.key == Key::kHits) numbers["hits"] += 1;
        if (event.key == Key::kMessage) numbers["messages"] += 1;
      }
    }
  };
  EndlessRules endless;
  const auto feed = [&] {
    const sim::EventList events = simulation.TakeEvents();
    if (spec.ends_endless && endless.See(events, simulation)) {
      result.outcome = "endless";
      result.error = endless.text();
    }
    const TickFacts& facts = gatherer.Gather(events);
    evaluator.Feed(facts);
    count(events, facts);
    if (on_facts) on_facts(facts);
  };
  feed();
  const bool errors_count = spec.errors_fail && !AsksForProblems(mission);
  result.is_faulty = errors_count && problems.has_errors();
  if (const std::string unknown = UnknownName(mission, gatherer.facts()); !unknown.empty()) {
    result.outcome = "refused";
    result.error = unknown;
    return result;
  }
  double decided_at_s = -1;
  while (simulation.time_s() < spec.seconds - 1e-6 && !simulation.HasEnded() && result.outcome == "ok") {
    simulation.Tick();
    feed();
    if (spec.to_the_end || !evaluator.IsDecided()) continue;
    if (decided_at_s < 0) decided_at_s = simulation.time_s();
    if (!evaluator.HasFailed() || simulation.time_s() >= decided_at_s + kAfterFailure_s) break;
  }
  evaluator.Finish();
  if (spec.to_the_end) gatherer.GatherInsight();
  result.has_errors = errors_count && problems.has_errors();
  result.passed = evaluator.HasPassed() && result.outcome == "ok" && !result.has_errors;
  result.seconds = simulation.time_s();
  result.ticks = simulation.tick();
  result.state_hash = simulation.StateHash();
  result.idle_checks = evaluator.idle_checks();
  double alive = 0;
  for (const AgentFacts& agent : gatherer.facts().agents) {
    alive += agent.alive ? 1 : 0;
    numbers["distance"] += agent.distance;
    numbers["rounds"] += agent.rounds;
    numbers["damage"] += agent.damage;
    numbers["health"] += agent.health;
    if (agent.score) numbers["score"] += *agent.score;
    numbers["idle"] += agent.idle;
    numbers["decisions"] += agent.decisions;
    numbers["firings"] += agent.firings;
    numbers["learned"] += agent.learned;
  }
  numbers["alive"] = alive;
  // A kernel other than ours does not report these numbers. A value of 0 would mean that nothing happened.
  if (!tells_all)
    std::erase_if(numbers, [](const auto& number) {
      return number.first == "firings" || number.first == "learned" || number.first.starts_with("impasses_");
    });
  const std::span<const Verdict> verdicts = evaluator.verdicts();
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    CheckResult& check = result.checks.emplace_back();
    check.verdict = verdicts[i];
    const Check& asked = i < mission.checks.size() ? mission.checks[i] : mission.mistakes[i - mission.checks.size()];
    if (verdicts[i].state != State::kTrue)
      check.expected = Expectation(asked, asked.who == Who::kAny ? std::string() : verdicts[i].agent, mission);
  }
  simulation.Finish();
  const bool all_true =
      std::all_of(verdicts.begin(), verdicts.begin() + static_cast<std::ptrdiff_t>(mission.checks.size()),
                  [](const Verdict& verdict) { return verdict.state == State::kTrue; });
  const bool is_asked = !spec.recording.empty() || spec.account.IsAsked();
  if (is_asked && (spec.record_always || !result.passed || !all_true)) {
    made->reset();
    TellWhy(spec, result);
  }
  return result;
}

}  // namespace soarbox::mission
