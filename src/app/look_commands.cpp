// SPDX-License-Identifier: BSD-2-Clause
#include "app/look_commands.h"

#include <algorithm>
#include <iostream>

#include "app/data_folders.h"
#include "app/diagnostic_json.h"
#include "app/exit_codes.h"
#include "sim/check.h"
#include "sim/scenario_file.h"
#include "sim/simulation.h"

namespace soarbox::app {

int Check(const CheckOptions& options) {
  const std::vector<Diagnostic> problems = sim::CheckFiles(options.files);
  int errors = 0;
  for (const Diagnostic& problem : problems) {
    errors += problem.severity == Severity::kError ? 1 : 0;
    if (options.json) {
      std::cout << ToLine(ToJson(problem)) << '\n';
    } else {
      std::cout << Format(problem);
    }
  }
  if (!options.json) {
    std::cout << errors << (errors == 1 ? " error, " : " errors, ")
              << problems.size() - static_cast<std::size_t>(errors) << " warnings\n";
  }
  return problems.empty() ? kOk : kProblems;
}

int Why(const WhyOptions& options) {
  const auto refuse = [](const Diagnostic& problem) {
    std::cerr << Format(problem);
    return kCannotStart;
  };
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return refuse(data.error());
  const Result<sim::Scenario> scenario = sim::FindScenario(options.scenario, data.value(), options.extra_folders);
  if (!scenario) return refuse(scenario.error());
  sim::SimulationSettings settings;
  if (options.seed) {
    settings.seed = *options.seed;
  } else if (!scenario.value().definition.empty()) {
    Result<sim::ScenarioFile> file = sim::ReadScenarioFile(scenario.value().definition);
    if (file) settings.seed = file->seed.value_or(1);
  }
  Result<std::unique_ptr<sim::Simulation>> simulation = sim::Simulation::Create(scenario.value(), settings);
  if (!simulation) return refuse(simulation.error());
  sim::Simulation& world = **simulation;
  while (world.time_s() < options.at_s) world.Tick();

  std::string agent = options.agent;
  std::vector<std::string> names;
  for (const auto& seen : world.Snapshot().agents) names.push_back(seen.name);
  for (std::size_t i = 0; agent.empty() && i < names.size(); ++i)
    if (!world.Why(names[i]).empty()) agent = names[i];
  const std::vector<std::string> lines = world.Why(agent);
  if (lines.empty()) {
    Diagnostic problem;
    problem.message = "there is no agent '" + agent + "' with a mind";
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    if (const std::string_view near = Suggest(agent, candidates); !near.empty()) {
      problem.hint = "did you mean '" + std::string(near) + "'?";
    } else {
      problem.hint = "there are:";
      for (const std::string& name : names) problem.hint += " " + name;
    }
    return refuse(problem);
  }
  if (options.topic.empty()) {
    for (const std::string& line : lines) std::cout << line << '\n';
    return kOk;
  }
  const Result<std::vector<std::string>> tree = world.WhyTopic(agent, options.topic);
  if (!tree) return refuse(tree.error());
  std::cout << lines.front() << ", " << options.topic << '\n';
  for (const std::string& line : *tree) std::cout << line << '\n';
  return kOk;
}

}  // namespace soarbox::app
