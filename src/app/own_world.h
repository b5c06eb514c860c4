// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "sim/scenario.h"

namespace soarbox::app {

/// The requirements for a world that the learner creates: [own] in its lesson.toml. The lesson's own checks are then
/// ignored. The learner's checks are run, and graded by the errors that they detect.
struct OwnWorldRules {
  std::size_t agents = 2, obstacles = 1, checks = 1;  ///< Minimum number of tables of each kind.
  double noticed = 0.5;  ///< Fraction of the rules of each file whose absence the learner's checks must detect.
};

/// A requirement for the world, and whether it is met.
struct OwnWorldPoint {
  std::string name;  ///< "agents", "obstacles", "checks", "checks hold", "checks fail", "dog.soar".
  bool is_met = false;
  std::string text;                  ///< "2 agents"
  std::string advice;                ///< Advice if it is not met.
  std::vector<std::string> details;  ///< "without dog*apply*follow: noticed by ..."
};

/// The grade of a world.
struct OwnWorldGrade {
  std::vector<Diagnostic> problems;  ///< Errors in the files, so nothing was run.
  std::vector<Diagnostic> warnings;  ///< Slips.
  std::vector<OwnWorldPoint> points;
  bool cancelled = false;
  /// The first requirement that is not met; null if all are.
  const OwnWorldPoint* Missing() const;
  bool passed() const { return problems.empty() && !cancelled && !points.empty() && Missing() == nullptr; }
};

/// Grades the world in this folder: it meets the requirements; its checks pass with two seeds; a check fails if no
/// agent has rules; and the checks detect when a rule is missing, for each rule in turn. Writes copies of the world
/// into the folder for temporary files. `on_run` is called before each set of runs with the number of finished ones.
/// Ctrl-C cancels it.
OwnWorldGrade GradeOwnWorld(const OwnWorldRules& rules, const std::filesystem::path& world,
                            const sim::DataFolders& data,
                            const std::function<void(std::size_t done, std::size_t of)>& on_run = {});

/// The names of the rules in a text, in their order.
std::vector<std::string> RuleNamesIn(const std::string& text);
/// Returns the text without the rule of this name; all other text keeps its place.
std::string WithoutRule(const std::string& text, const std::string& name);

}  // namespace soarbox::app
