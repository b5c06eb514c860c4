// SPDX-License-Identifier: BSD-2-Clause
#include "sim/replaced_rules.h"

#include <algorithm>
#include <system_error>

#include "diagnostics/problem.h"
#include "world/world.h"

namespace soarbox::sim {
namespace fs = std::filesystem;

Result<void> ReplaceRules(Scenario& scenario, const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == std::string::npos || sign == 0 || sign + 1 == word.size())
      return NewProblem("--rules takes NAME=FILE, and this is '" + word + "'",
                        "name an agent and the file of its rules: --rules eater=mine.soar");
    const std::string name = word.substr(0, sign);
    std::error_code error;
    const fs::path file = fs::canonical(word.substr(sign + 1), error);
    if (error || !fs::is_regular_file(file, error))
      return ProblemIn(word.substr(sign + 1), "there is no such file of rules", "--rules NAME=FILE names a .soar file");
    for (const auto& [other, its_file] : scenario.replaced_rules)
      if (other == name) return NewProblem("--rules names the rules of " + name + " twice", "leave one of them out");
    scenario.replaced_rules.emplace_back(name, file);
    const bool is_there = std::ranges::any_of(scenario.rule_folders, [&](const fs::path& folder) {
      std::error_code ignored;
      return fs::equivalent(folder, file.parent_path(), ignored);
    });
    if (!is_there) scenario.rule_folders.push_back(file.parent_path());
  }
  return {};
}

Result<void> CheckReplacements(const Scenario& scenario, const world::World& world) {
  std::vector<std::string> names;
  for (const world::EntityId id : world.AgentIds()) names.push_back(world.FindAgent(id)->name());
  for (const auto& [name, file] : scenario.replaced_rules) {
    const auto is_meant = [&meant = name](const std::string& agent) { return agent == meant || agent == meant + "-1"; };
    if (std::ranges::any_of(names, is_meant)) continue;
    std::string hint = "there are:";
    for (const std::string& agent : names) hint += " " + agent;
    if (const std::string_view near = Suggest(name, {names.begin(), names.end()}); !near.empty())
      hint = "did you mean '" + std::string(near) + "'?";
    if (names.empty()) hint = "this world has no agents";
    return NewProblem("--rules: there is no agent '" + name + "'", hint);
  }
  return {};
}

}  // namespace soarbox::sim
