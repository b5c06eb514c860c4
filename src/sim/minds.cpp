// SPDX-License-Identifier: BSD-2-Clause
#include "sim/minds.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "diagnostics/problem.h"
#include "explain/reasons.h"
#include "sim/directions.h"
#include "sim/senses.h"
#include "vocabulary/command_check.h"
#include "wording/sentences.h"

namespace soarbox::sim {
namespace {

/// An idle agent is asked for the reason after this time, in s.
constexpr float kIdleUntilTold_s = 1;
/// Maximum number of times that one agent, and all agents of a run, are asked why they are idle.
constexpr int kMostAsked = 10;
constexpr int kMostAskedInAll = 300;

/// The files of rules in a folder, for suggestions.
std::vector<std::string> RulesIn(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".soar") names.push_back(it->path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string NearMiss(const std::string& wanted, const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names;
  for (const std::filesystem::path& folder : folders) {
    const std::vector<std::string> here = RulesIn(folder);
    names.insert(names.end(), here.begin(), here.end());
  }
  const std::vector<std::string_view> candidates(names.begin(), names.end());
  return std::string(Suggest(wanted, candidates));
}

/// Splits "rule NAME: ...".
explain::FailedRule Failed(const Diagnostic& problem) {
  explain::FailedRule failed;
  failed.place = std::filesystem::path(problem.file).filename().string() + ":" + std::to_string(problem.line);
  failed.problem = problem.message;
  constexpr std::string_view kRule = "rule ";
  if (!problem.message.starts_with(kRule)) return failed;
  const std::size_t end = problem.message.find_first_of(" :", kRule.size());
  if (end == std::string::npos) return failed;
  failed.rule = problem.message.substr(kRule.size(), end - kRule.size());
  failed.problem =
      problem.message.substr(std::min(problem.message.find_first_not_of(" :", end), problem.message.size()));
  constexpr std::string_view kNotClosed = "is not closed: ";
  if (failed.problem.starts_with(kNotClosed)) failed.problem.erase(0, kNotClosed.size());
  return failed;
}

void NoteRow(const script::TableField& field, std::set<std::string>& names) {
  names.insert(field.name);
  if (const auto* table = std::get_if<script::Table>(&field.value))
    for (const script::TableField& below : *table) NoteRow(below, names);
}

}  // namespace

vocabulary::PerceptList ToPercepts(const script::Table& table) {
  vocabulary::PerceptList list;
  std::map<std::string, std::uint32_t> keys;
  for (const script::TableField& field : table) {
    vocabulary::Percept& made = list.emplace_back();
    made.attribute = field.name;
    made.key = ++keys[field.name];
    if (const auto* number = std::get_if<double>(&field.value)) {
      // Lua has only one type of number; integral numbers are integers for rules.
      if (*number == std::floor(*number) && std::abs(*number) < 1e15) {
        made.value = static_cast<std::int64_t>(*number);
      } else {
        made.value = *number;
      }
    } else if (const auto* text = std::get_if<std::string>(&field.value)) {
      made.value = *text;
    } else {
      made.value = ToPercepts(std::get<script::Table>(field.value));
    }
  }
  return list;
}

script::Table ToTable(const vocabulary::PerceptList& list) {
  script::Table table;
  for (const vocabulary::Percept& percept : list) {
    script::TableField& made = table.emplace_back();
    made.name = percept.attribute;
    if (const auto number = percept.Number()) {
      made.value = *number;
    } else if (const auto* text = percept.Text()) {
      made.value = *text;
    } else {
      made.value = ToTable(std::get<vocabulary::PerceptList>(percept.value));
    }
  }
  return table;
}

Minds::Minds(world::World& world, const Scenario& scenario, SoarHost& host, Arena& arena, Report report)
    : world_(world),
      scenario_(scenario),
      host_(host),
      arena_(arena),
      report_(std::move(report)),
      body_kinds_(BodyKinds().begin(), BodyKinds().end()),
      decided_(host.threads()),
      pool_(host.threads()) {}

Result<std::filesystem::path> Minds::FindRules(const std::string& agent, const AgentKind& kind,
                                               const std::string& named) {
  if (const std::filesystem::path* other = scenario_.ReplacementFor(agent)) return *other;
  const bool is_own = named.empty();
  const std::string wanted = is_own ? std::string(kind.rules) : named;
  if (wanted.empty()) {
    return NewProblem(agent + " has no rules",
                      "name the file: Sandbox.CreateSoarAgent(sandbox, \"Body.lua\", \"scout.soar\")");
  }
  const std::filesystem::path found = FindInFolders(wanted, scenario_.rule_folders);
  const std::string near = found.empty() ? NearMiss(wanted, scenario_.rule_folders) : std::string();
  if (!found.empty()) return found;
  // The thesis' own rules are used only if no rules were named and no similar file exists.
  if (is_own && near.empty()) {
    if (const auto fallback = FindInFolders(wanted, scenario_.fallback_rule_folders); !fallback.empty())
      return fallback;
  }
  Diagnostic problem;
  problem.file = wanted;
  const std::filesystem::path name(wanted);
  if (name.is_absolute() || std::find(name.begin(), name.end(), "..") != name.end()) {
    problem.message = "the rules of " + agent + ", " + wanted + ", are not below the scenario's folder";
    problem.hint = "name them from that folder on, without '..'; --path adds a folder";
    return problem;
  }
  for (const std::filesystem::path& folder : scenario_.rule_folders) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::symlink_status(folder / wanted, error);
    const bool is_there = !error && std::filesystem::exists(status);
    if (!is_there) continue;
    problem.message = "the rules of " + agent + ", " + wanted + ", are ";
    problem.message += std::filesystem::is_directory(status) ? "a folder"
                       : std::filesystem::is_symlink(status)
                           ? "a link that leads out of the scenario's folder, or nowhere"
                           : "no plain file";
    return problem;
  }
  problem.message = "the rules of " + agent + ", " + wanted + ", are in none of these folders:";
  for (const std::filesystem::path& folder : scenario_.rule_folders) problem.message += " " + folder.string();
  problem.hint = near.empty() ? "check the name, or add the folder with --path" : "did you mean '" + near + "'?";
  return problem;
}

Result<void> Minds::MakeBody(world::Agent& body, const AgentOptions& options) {
  if (!options.team.empty()) body.SetTeam(options.team);
  if (!options.leader.empty()) {
    const world::EntityId leader = arena_.FindAgentNamed(options.leader);
    if (leader == world::kNoEntity) {
      return NewProblem("the leader of " + body.name() + ", '" + options.leader + "', is not there",
                        "create the leader before the agents that follow it");
    }
    if (leader == body.id()) {
      return NewProblem(body.name() + " cannot be its own leader", "name another agent, or none");
    }
    body.SetLeader(leader);
  }
  if (options.position) {
    world::Vec3 place = *options.position;
    place.y = body.Height() / 2;
    body.SetPosition(place);
  }
  if (options.heading_deg) body.SetForward(AlongHeading(*options.heading_deg));
  return {};
}

Result<void> Minds::MakeMind(world::EntityId agent, const script::AgentCreationRequest& request) {
  AwaitAll();
  world::Agent& body = *world_.FindAgent(agent);
  const AgentKind* kind = FindAgentKind(request.kind);
  if (kind == nullptr) {
    return NewProblem("there is no kind of agent '" + request.kind + "'");
  }
  Result<AgentOptions> options = ReadAgentOptions(request.options, body_kinds_);
  if (!options) return options.error();
  const bool by_sandbox = options->by_sandbox;
  if (by_sandbox && !request.script.empty())
    return NewProblem(body.name() + " has a script, and by = \"sandbox\"", "leave one of the two out");
  const bool is_scripted = by_sandbox || !request.script.empty();
  if (!is_scripted || (options->has_senses && !by_sandbox)) arena_.Add(agent, options->body, is_scripted);
  if (const Result<void> made = MakeBody(body, *options); !made) return made;
  if (by_sandbox) body.RemovePhysics();
  if (!is_scripted) body.SetTarget({0, 0, 10});
  const bool is_replaced = scenario_.ReplacementFor(body.name()) != nullptr;
  if ((!is_scripted || by_sandbox) && request.rules.empty() && !is_replaced) return {};

  Result<std::filesystem::path> rules = FindRules(body.name(), *kind, request.rules);
  if (!rules) return rules.error();
  MindSettings settings;
  settings.has_distance = (is_scripted && !by_sandbox) || options->body.senses.only.contains("distance");
  settings.blinks = is_scripted && !by_sandbox && kind->blinks;
  settings.waits = kind->waits && !by_sandbox;
  settings.imagines = options->body.senses.scene;
  settings.detail = detail_;
  settings.origins = records_origins_;
  Result<SoarHost::Loaded> loaded = Load(body.name(), *rules, settings, is_scripted);
  if (!loaded) return loaded.error();
  minds_.push_back({agent, settings, kind->follows_leader, is_scripted, false, by_sandbox, *rules,
                    SoarMind(*loaded->agent, settings), loaded->thread});
  minds_.back().memory_bytes = minds_.back().soar.MemoryBytes();
  memory_bytes_ += minds_.back().memory_bytes;
  // The script of a new agent may create another agent before the new agent has its mind. Then the other agent gets its
  // mind first, although its id is greater.
  if (place_by_id_.size() <= Number(agent)) place_by_id_.resize(Number(agent) + std::size_t{1});
  place_by_id_[Number(agent)] = static_cast<std::uint32_t>(minds_.size());
  return {};
}

Result<SoarHost::Loaded> Minds::Load(const std::string& agent, const std::filesystem::path& rules,
                                     const MindSettings& settings, bool is_scripted) {
  Result<SoarHost::Loaded> loaded =
      host_.CreateAgent(agent, rules, settings.waits ? "soar wait-snc on" : "", is_scripted);
  if (!loaded) return loaded;
  has_new_rules_ = true;
  const bool is_first = !failed_.contains(rules);
  std::set<std::string> failed_rules;
  for (Diagnostic& problem : loaded->problems) {
    // Several errors may be about one rule: "rule NAME: ...".
    if (problem.severity == Severity::kError && is_first &&
        failed_rules.insert(problem.message.substr(0, problem.message.find(':'))).second)
      failed_[rules].push_back(Failed(problem));
    if (!reported_.insert(Format(problem)).second) continue;
    RunEvent event;
    event.kind = EventKind::kDiagnostic;
    event.agent = agent;
    event.diagnostic = std::move(problem);
    report_(std::move(event));
  }
  return loaded;
}

void Minds::Restore() {
  for (Mind& mind : minds_) {
    if (world_.FindAgent(mind.agent)->IsGone()) continue;
    if (mind.by_client) {
      mind.lost = true;  // Agents of another program do not come back.
      continue;
    }
    const std::string& name = world_.FindAgent(mind.agent)->name();
    Result<SoarHost::Loaded> loaded = Load(name, mind.rules, mind.settings, mind.is_scripted);
    mind.lost = !loaded;
    mind.decided = mind.in_gap = mind.told_halt = false;
    if (loaded) {
      mind.soar = SoarMind(*loaded->agent, mind.settings);
      mind.thread = loaded->thread;
      continue;
    }
    if (!host_.IsConnected()) return;  // The connection was lost again: all minds are created in the next kernel.
    RunEvent event;
    event.kind = EventKind::kDiagnostic;
    event.agent = name;
    event.diagnostic = loaded.error();
    report_(std::move(event));
  }
}

Minds::Mind* Minds::Find(world::EntityId agent) {
  const std::uint32_t place = Number(agent) < place_by_id_.size() ? place_by_id_[Number(agent)] : 0;
  return place != 0 ? &minds_[place - 1] : nullptr;
}

Minds::Mind* Minds::FindNamed(std::string_view agent) {
  const auto at =
      std::ranges::find_if(minds_, [&](const Mind& mind) { return world_.FindAgent(mind.agent)->name() == agent; });
  return at != minds_.end() ? &*at : nullptr;
}

void Minds::Decide() {
  if (has_new_rules_) TellSlips();
  for (Mind& mind : minds_) {
    mind.decide_s = 0;
    if (mind.soar.is_logged()) mind.soar.record().Clear();
  }
  PlayClientActs();
  Notice();
  // Scripts may create agents while they sense, so minds are accessed by index.
  ready_.clear();
  for (std::size_t i = 0; i < minds_.size(); ++i) {
    if (Prepare(minds_[i])) ready_.push_back(i);
  }
  LimitMemory();
  // Each mind reads and changes only its own agent, so the result does not depend on the order.
  pool_.Run([this](std::size_t thread) {
    for (const std::size_t i : ready_) {
      if (minds_[i].thread != thread || minds_[i].is_scripted || !host_.IsConnected()) continue;
      PerceiveWorld(minds_[i]);
      DecideNow(minds_[i]);
    }
  });
  for (const std::size_t i : ready_)
    if (!minds_[i].is_scripted) Conclude(minds_[i]);
  BeginBesideScripts();
}

void Minds::LookAhead() {
  pool_.Join();  // Scripted minds were awaited one by one.
  arena_.Foresee(AllThreads());
}

world::Workers Minds::AllThreads() {
  if (host_.threads() == 1) return {};
  return [this](std::size_t count, const std::function<void(std::size_t)>& job) {
    pool_.Run([&](std::size_t thread) {
      for (std::size_t i = thread; i < count; i += host_.threads()) job(i);
    });
  };
}

/// Updates what bodies know about orders and about each other. Each body changes only its own knowledge, draws from its
/// own random stream and reads the present world. The result therefore does not depend on the threads.
void Minds::Notice() {
  constexpr std::size_t kWorthThreads = 16;
  const auto actors = arena_.actors();
  // Bodies search for paths and look at each other. With many more things than bodies, the preparation is not
  // worthwhile.
  constexpr std::size_t kThingsOfEach = 4;
  world_.PrepareForReaders(actors.size() >= kWorthThreads && world_.ObjectIds().size() < kThingsOfEach * actors.size());
  const auto notice = [&](std::size_t thread, std::size_t threads) {
    for (std::size_t i = 0; i < actors.size(); ++i) {
      if (ThreadOf(i, threads) != thread || !actors[i]->IsAlive()) continue;
      HearOrders(*actors[i]);
      if (!IsSenseTick(*actors[i])) continue;
      sim::Notice(*actors[i]);
    }
  };
  if (actors.size() < kWorthThreads) return notice(0, 1);
  pool_.Run([&](std::size_t thread) { notice(thread, host_.threads()); });
}

/// Writes the thesis' percept. Returns false if the mind perceives nothing and should not decide.
bool Minds::PerceiveDistance(Mind& mind, const world::Agent& body) {
  if (mind.settings.has_distance) {
    world::Vec3 goal = body.Target();
    const bool has_leader = body.Leader() != world::kNoEntity;
    if (mind.follows_leader && !has_leader) return false;  // It has no agent to follow: no percept, no command.
    if (const world::Agent* leader = has_leader ? world_.FindAgent(body.Leader()) : nullptr) goal = leader->Position();
    mind.distance_squared_m2 = world::LengthSquared(goal - body.Position());
    mind.soar.SetDistance(mind.distance_squared_m2);
  }
  return true;
}

/// Writes the percepts of its senses, on the thread of its mind.
void Minds::PerceiveWorld(Mind& mind) {
  const Actor* actor = arena_.Find(mind.agent);
  if (actor == nullptr) return;
  mind.soar.Perceive(*actor, IsSenseTick(*actor));
}

bool Minds::PerceiveGraph(Mind& mind) {
  const world::EntityId agent = mind.agent;
  const std::size_t count = minds_.size();
  const std::optional<script::PerceptGraph> graph = sense_sandbox_ ? sense_sandbox_(agent) : std::nullopt;
  if (!graph || minds_.size() != count) return false;  // It created agents: this mind decides when it is asked again.
  for (const script::PerceptGraph::Node& node : graph->nodes) {
    for (const auto& constant : node.constants) script_rows_.insert(constant.attribute);
    for (const auto& link : node.links) script_rows_.insert(link.attribute);
  }
  mind.soar.ShowGraph(*graph);
  return true;
}

bool Minds::Prepare(Mind& mind) {
  const world::Agent& body = *world_.FindAgent(mind.agent);
  const bool is_actor_dead = !mind.is_scripted && body.Health() <= 0;
  mind.decided = false;
  if (mind.by_client || body.Failed() || mind.lost || is_actor_dead || !host_.IsConnected()) return false;
  if (mind.by_sandbox) return !mind.soar.Halted() && PerceiveGraph(mind);
  if (!PerceiveDistance(mind, body)) return false;
  if (mind.is_scripted) PerceiveWorld(mind);
  if (mind.is_scripted && sense_script_) {
    const world::EntityId agent = mind.agent;
    const std::size_t count = minds_.size();
    if (const auto rows = sense_script_(agent)) {
      for (const script::TableField& field : *rows) NoteRow(field, script_rows_);
      Mind& again = *Find(agent);
      again.soar.ShowRows(ToPercepts(*rows));
    }
    if (minds_.size() != count) return false;  // It created agents: this mind decides in the next tick.
    if (body.Failed()) return false;
  }
  return true;
}

void Minds::Conclude(Mind& mind) {
  const world::Agent& body = *world_.FindAgent(mind.agent);
  if (!host_.IsConnected()) return;  // The connection to its kernel was lost; that is not a gap in the rules.
  mind.decided = true;
  TellWritten(mind, body);
  TellFailures(mind, body);
  if (TellBreakdown(mind, body)) return;
  if (!mind.soar.commands().empty()) {
    mind.last_said = mind.soar.commands().back();
    mind.last_said_s = world_.time_s();
    mind.last_answer.clear();
    mind.failed_command.clear();
  }
  if (!mind.is_scripted) {
    TellIdle(mind, body);
  } else if (mind.soar.commands().empty() && mind.under_way.empty()) {
    TellGap(mind, body);
  } else {
    mind.in_gap = false;
  }
}

world::Workers Minds::Answer() {
  AwaitAll();
  KeepWithinMemory();
  for (Mind& mind : minds_) {
    Actor* actor = mind.is_scripted ? nullptr : arena_.Find(mind.agent);
    if (actor == nullptr) continue;
    for (const Outcome& outcome : actor->TakeOutcomes()) {
      if (!mind.lost && host_.IsConnected()) mind.soar.Answer(outcome);
      if (outcome.status == Outcome::Status::kProgress || outcome.status == Outcome::Status::kInterrupted) continue;
      const vocabulary::CommandRow* row = vocabulary::FindCommand(outcome.command);
      TellOutcome(mind, outcome, row != nullptr && row->lasting);
    }
  }
  if (std::ranges::none_of(minds_, [](const Mind& mind) { return !mind.answers.empty(); })) return AllThreads();
  pool_.Begin(tell_scripts_);
  TellScripts(0);
  return {};
}

void Minds::NoteAnswer(Mind& mind, Outcome outcome, bool is_news) {
  if (mind.by_sandbox || is_news) TellOutcome(mind, outcome, is_news || !outcome.text.empty());
  mind.answers.push_back(std::move(outcome));
}

/// Reports the end of a command: failures always, and successes if `is_news`.
void Minds::TellOutcome(Mind& mind, const Outcome& outcome, bool is_news) {
  const bool is_error = outcome.status == Outcome::Status::kError;
  const std::string text = outcome.text.empty() ? "" : ": " + outcome.text;
  mind.failed_command = is_error ? outcome.command : "";
  mind.last_answer = outcome.command + (is_error ? " failed: " + outcome.reason : " complete") + text;
  if (!is_error && !is_news) return;
  // The same failure of the same command is reported once; its number is reported at the end of the run.
  std::string fault = is_error ? "error of " + outcome.command + " " + outcome.reason + " " + outcome.parameter
                               : outcome.command + " complete";
  if (mind.by_sandbox) fault += text;
  if ((is_error || mind.by_sandbox) && ++mind.told[fault] > 1) return;
  RunEvent event;
  event.kind = EventKind::kOutcome;
  event.agent = world_.FindAgent(mind.agent)->name();
  event.news = outcome.command;
  event.text = (is_error ? "error " + outcome.reason : "complete") + text;
  // Worlds with commands of their own name the parameter: no-such-direction.
  const bool is_fault_of_form =
      vocabulary::IsFaultOfForm(outcome.reason) || (mind.by_sandbox && outcome.reason.starts_with("no-such-"));
  if (is_error && is_fault_of_form && !outcome.text.empty())
    event.reasons.push_back({outcome.brief.empty() ? outcome.text : outcome.brief, explain::Reason::Kind::kRefused});
  event.position = world_.FindAgent(mind.agent)->Position();
  report_(std::move(event));
}

void Minds::Tell(EventKind kind, const world::Agent& body, std::string text) {
  RunEvent event;
  event.kind = kind;
  event.agent = body.name();
  event.text = std::move(text);
  report_(std::move(event));
}

void Minds::TellWritten(Mind& mind, const world::Agent& body) {
  constexpr std::size_t kMostLines = 100;
  std::size_t count = 0;
  for (std::string& line : mind.soar.TakeWritten()) {
    // These messages of the kernel are reported as a gap instead.
    if (line.starts_with("Goal stack depth exceeded") || line.ends_with("halted.")) continue;
    if (++count > kMostLines) return Tell(EventKind::kLog, body, "(more was written in this tick)");
    Tell(EventKind::kLog, body, std::move(line));
  }
}

void Minds::TellHalt(Mind& mind, const world::Agent& body) {
  if (std::exchange(mind.told_halt, true)) return;
  const std::string why = explain::MindReasons(mind.soar.agent()).WhyHalted();
  Tell(EventKind::kGap, body, wording::Say(wording::Situation::kHalted) + (why.empty() ? "" : ": " + why));
}

/// Reports why the mind of a scripted agent has no command.
void Minds::TellGap(Mind& mind, const world::Agent& body) {
  AwaitAll();  // Other minds of its kernel may be deciding, and it will be queried.
  if (mind.soar.Halted()) {
    // During a gap, the goal stack grows until the kernel halts the program. The program is restarted, because it did
    // not request the halt.
    if (mind.in_gap) {
      mind.soar.Restart();
    } else {
      TellHalt(mind, body);
    }
    return;
  }
  if (std::exchange(mind.in_gap, true)) return;
  TellCause(mind, body, "it gave no command within its decision budget");
}

/// An agent that is controlled by commands need not get a command in each tick. It is idle only if its mind gives none
/// and no command is running, for some time.
void Minds::TellIdle(Mind& mind, const world::Agent& body) {
  if (mind.soar.Halted()) return TellHalt(mind, body);
  const Actor& actor = *arena_.Find(mind.agent);
  if (!mind.soar.commands().empty() || !actor.running().empty()) {
    mind.idle_ticks = 0;
    mind.in_gap = false;
    return;
  }
  const auto limit = static_cast<std::uint64_t>(kIdleUntilTold_s / world_.settings().step_s);
  if (++mind.idle_ticks != limit || std::exchange(mind.in_gap, true)) return;
  TellCause(mind, body, "it has done nothing for " + std::to_string(static_cast<int>(kIdleUntilTold_s)) + " s");
}

/// Asks a mind why it is idle, and reports each cause once.
void Minds::TellCause(Mind& mind, const world::Agent& body, std::string text) {
  // Queries are expensive. For many idle agents, or an agent that is often idle, a limited number is sufficient.
  if (++mind.gaps > kMostAsked || ++asked_ > kMostAskedInAll) {
    if (++mind.causes[text] == 1 && mind.gaps == 1) Tell(EventKind::kGap, body, std::move(text));
    return;
  }
  RunEvent event;
  event.kind = EventKind::kGap;
  event.agent = body.name();
  event.text = std::move(text);
  event.reasons = explain::MindReasons(mind.soar.agent(), FailedIn(mind.rules)).WhyIdle(KnownAttributes());
  if (!mind.failed_command.empty())
    event.reasons.insert(event.reasons.begin(),
                         {"its last command " + mind.last_answer, explain::Reason::Kind::kRefused});
  const std::string cause = event.reasons.empty() ? std::string() : event.reasons.front().text;
  if (++mind.causes[cause] > 1) return;
  std::string percepts;
  if (mind.settings.has_distance) {
    vocabulary::Percept distance;
    distance.attribute = "distance";
    distance.value = static_cast<double>(mind.distance_squared_m2);
    percepts = vocabulary::Describe({distance});
  }
  if (const Actor* actor = arena_.Find(mind.agent))
    percepts += (percepts.empty() ? "" : " ") + vocabulary::Describe(AllPercepts(*actor));
  if (!percepts.empty()) {
    constexpr std::size_t kShown = 600;
    event.reasons.push_back(
        {"it perceives " + (percepts.size() > kShown ? percepts.substr(0, kShown) + " ..." : percepts),
         explain::Reason::Kind::kPercepts});
  }
  report_(std::move(event));
}

std::vector<explain::FailedRule> Minds::FailedIn(const std::filesystem::path& rules) const {
  const auto failed = failed_.find(rules);
  return failed == failed_.end() ? std::vector<explain::FailedRule>() : failed->second;
}

std::set<std::string> Minds::KnownAttributes() {
  std::set<std::string> known = script_rows_;
  for (Mind& mind : minds_) {
    if (mind.gone) continue;
    const auto [at, is_new] = made_by_rules_.try_emplace(mind.rules);
    if (is_new) {
      explain::MindReasons reasons(mind.soar.agent());
      for (const explain::RuleText& rule : reasons.rules())
        for (const explain::RuleAttribute& action : rule.actions) at->second.insert(action.attribute);
    }
    known.insert(at->second.begin(), at->second.end());
  }
  return known;
}

void Minds::TellCounts() {
  for (Mind& mind : minds_) {
    const world::Agent& body = *world_.FindAgent(mind.agent);
    for (const auto& [cause, count] : mind.causes)
      if (count > 1) Tell(EventKind::kGap, body, std::to_string(count) + " times in all: " + cause);
    for (const auto& [fault, count] : mind.told)
      if (count > 1) Tell(EventKind::kGap, body, std::to_string(count) + " times in all: " + fault);
  }
}

}  // namespace soarbox::sim
