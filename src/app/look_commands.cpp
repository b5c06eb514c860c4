// SPDX-License-Identifier: BSD-2-Clause
#include "app/look_commands.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/data_folders.h"
#include "app/diagnostic_json.h"
#include "app/editor_commands.h"
#include "app/exit_codes.h"
#include "app/lesson.h"
#include "app/refuse.h"
#include "app/rules_of_project.h"
#include "app/run_session.h"
#include "debugger/json.h"
#include "debugger/learned_rule.h"
#include "debugger/why.h"
#include "diagnostics/nearest_hint.h"
#include "diagnostics/read_text.h"
#include "explain/learning_facts.h"
#include "mission/scenario_names.h"
#include "record/reader.h"
#include "record/rerun.h"
#include "sim/check.h"
#include "sim/findings.h"
#include "sim/scenario_file.h"
#include "sim/simulation.h"
#include "sweep/plan.h"

namespace soarbox::app {

int Check(const CheckOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  const sim::DataFolders* shipped = data ? &*data : nullptr;
  // A scenario that comes with the program may be given by name, as for `soarbox run`.
  std::vector<std::filesystem::path> files = options.files;
  for (std::filesystem::path& file : files) {
    std::error_code error;
    if (shipped == nullptr || std::filesystem::exists(file, error) || file.has_parent_path()) continue;
    if (std::ranges::count(sim::ListScenarios(*shipped), file.string()) > 0) file = shipped->scenarios / file;
  }
  // For a VisualSoar project, checks the file that loads its rules, and each of its files against its datamap.
  std::vector<Diagnostic> of_projects;
  std::erase_if(files, [&](std::filesystem::path& file) {
    Result<std::filesystem::path> rules = RulesOfProject(file);
    if (rules) {
      for (Diagnostic& problem : DatamapProblems(file)) of_projects.push_back(std::move(problem));
      file = std::move(*rules);
    } else {
      of_projects.push_back(rules.error());
    }
    return !rules;
  });
  std::vector<Diagnostic> problems = sim::CheckFiles(
      files,
      [shipped](const std::filesystem::path& file, std::vector<Diagnostic>& found) {
        // The files for grading a lesson are next to its scenario.
        if (shipped != nullptr && file.filename() == "lesson.toml") {
          ReadLesson(file.has_parent_path() ? file.parent_path() : ".", *shipped, found);
          return false;
        }
        if (file.extension() == ".toml" && mission::IsSweepText(ReadText(file).value_or(""))) {
          // A results folder contains a copy of its sweep, which names files next to the original.
          std::error_code error;
          sweep::ReadSpec(file, found, std::filesystem::is_directory(file.parent_path() / "parts", error));
          return false;
        }
        return mission::CheckMissionFile(file, shipped, found);
      },
      shipped == nullptr ? std::filesystem::path() : shipped->media / "scripts");
  problems.insert(problems.end(), of_projects.begin(), of_projects.end());
  int errors = 0;
  for (const Diagnostic& problem : problems) {
    errors += problem.severity == Severity::kError ? 1 : 0;
    if (options.json) {
      std::cout << JsonText(ToJson(problem)) << '\n';
    } else {
      std::cout << Format(problem);
    }
  }
  if (!options.json) {
    const std::size_t warnings = problems.size() - static_cast<std::size_t>(errors);
    std::cout << errors << (errors == 1 ? " error, " : " errors, ") << warnings
              << (warnings == 1 ? " warning\n" : " warnings\n");
  }
  return problems.empty() ? kOk : kProblems;
}

namespace {

constexpr double kUsualMoment_s = 5;

/// Runs the scenario from its beginning to the requested moment. Prints the errors of rules and scripts until then.
Result<std::unique_ptr<sim::Simulation>> RunToMoment(const WhyOptions& options, const sim::DataFolders& data) {
  const Result<sim::Scenario> scenario = sim::FindScenario(options.scenario, data, options.extra_folders);
  if (!scenario) return scenario.error();
  sim::SimulationSettings settings;
  settings.mind_detail = sim::MindDetail::kDecisions;  // The learning of rules is recorded from the beginning.
  settings.seed = sim::SeedOf(*scenario, options.seed);
  Result<std::unique_ptr<sim::Simulation>> simulation = sim::Simulation::Create(scenario.value(), settings);
  if (!simulation) return simulation;
  sim::EventFindings findings;
  findings.See((*simulation)->TakeEvents());
  const double at_s = options.at_s.value_or(kUsualMoment_s);
  while (!WasInterrupted() && (*simulation)->time_s() < at_s) {
    (*simulation)->Tick();
    findings.See((*simulation)->TakeEvents());
  }
  // Prints errors so far: a script that failed may be the reason for what the agent does.
  for (const sim::EventFindings::Reported& reported : findings.reported())
    if (reported.diagnostic.severity == Severity::kError) std::cerr << Format(reported.diagnostic);
  return simulation;
}

/// Simulates a recorded run again to the requested moment, and verifies that moment.
Result<std::unique_ptr<sim::Simulation>> RunRecording(const WhyOptions& options, const sim::DataFolders& data) {
  const Result<std::unique_ptr<record::Reader>> reader = record::Reader::Open(options.scenario);
  if (!reader) return reader.error();
  const double at_s = options.at_s.value_or(kUsualMoment_s);
  auto tick = static_cast<std::uint64_t>(std::llround(at_s / (*reader)->header().step_s));
  if (!options.at_s) tick = std::clamp(tick, (*reader)->first_tick(), (*reader)->last_tick());
  Result<record::Rerun> rerun = record::GoTo(**reader, tick, data, [](std::uint64_t) { return !WasInterrupted(); });
  if (!rerun) return rerun.error();
  for (const Diagnostic& warning : rerun->warnings) std::cerr << Format(warning);
  return std::move(rerun->simulation);
}

bool Names(const explain::WhyNode& account, const std::string& rule) {
  return account.link == rule ||
         std::ranges::any_of(account.below, [&](const explain::WhyNode& below) { return Names(below, rule); });
}

/// Prints how the learned rules in the answer were learned.
void PrintOrigins(const sim::Simulation& world, const std::string& agent, const explain::WhyNode& account) {
  const std::unique_ptr<explain::Inspector> mind = world.Inspect(agent);
  auto* const source = dynamic_cast<explain::LearningSource*>(mind.get());
  if (source == nullptr) return;
  for (const explain::LearnedRuleFact& lesson : source->LearnedRules()) {
    if (!Names(account, lesson.rule)) continue;
    const std::optional<debugger::WhyNode> origin = debugger::OriginOf(*mind, lesson.rule);
    if (origin) std::cout << "  " << lesson.rule << " was\n" << debugger::ToText(*origin, 2);
  }
}

}  // namespace

int Why(const WhyOptions& options) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  CatchInterrupts();
  const Result<std::unique_ptr<sim::Simulation>> simulation =
      record::IsRecording(options.scenario) ? RunRecording(options, *data) : RunToMoment(options, *data);
  if (!simulation) return Refuse(simulation.error());
  sim::Simulation& world = **simulation;

  std::string agent = options.agent;
  std::vector<std::string> names;
  for (const auto& seen : world.Snapshot().agents) names.push_back(seen.name);
  for (std::size_t i = 0; agent.empty() && i < names.size(); ++i)
    if (world.Why(names[i])) agent = names[i];
  const std::optional<explain::WhyNode> account = world.Why(agent);
  if (!account) {
    if (agent.empty())
      return Refuse("no agent of this scenario has a Soar mind",
                    "scripts alone move these agents: soarbox run shows what they print");
    std::string all = "there are:";
    for (const std::string& name : names) all += " " + name;
    return Refuse("there is no agent '" + agent + "' with a mind",
                  NearestHint(agent, {names.begin(), names.end()}, std::move(all)));
  }
  if (options.topic.empty()) {
    if (options.json) {
      std::cout << debugger::Print(debugger::ToJson(debugger::WhyAgent(world, agent)));
      return kOk;
    }
    std::cout << account->text << '\n';
    for (const explain::WhyNode& reason : account->below) std::cout << debugger::ToText(reason);
    PrintOrigins(world, agent, *account);
    return kOk;
  }
  const Result<debugger::WhyNode> why = debugger::WhyName(world, agent, options.topic);
  if (!why) return Refuse(why.error());
  if (options.json) {
    std::cout << debugger::Print(debugger::ToJson(*why));
    return kOk;
  }
  std::cout << account->text << ", " << options.topic << '\n';
  if (why->kind == debugger::WhyKind::kTopic) {
    for (const debugger::WhyNode& reason : why->below) std::cout << debugger::ToText(reason, 1);
  } else {
    std::cout << debugger::ToText(*why, 1);
  }
  return kOk;
}

}  // namespace soarbox::app
