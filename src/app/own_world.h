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

/// What a lesson asks of a world that the learner makes: [own] of its lesson.toml. The lesson's own checks do not
/// matter then; the learner's are run, and graded by what they notice.
struct OwnWorldRules {
  std::size_t agents = 2, obstacles = 1, checks = 1;  ///< At least this many tables of each kind.
  double noticed = 0.5;  ///< Share of the rules of each file whose absence the learner's checks must notice.
};

/// One thing that is asked of the world, and whether it is met.
struct OwnWorldPoint {
  std::string name;  ///< "agents", "obstacles", "checks", "checks hold", "checks fail", "dog.soar".
  bool is_met = false;
  std::string text;                  ///< "2 agents"
  std::string advice;                ///< What to do if it is not met.
  std::vector<std::string> details;  ///< "dog.soar without dog*apply*follow: noticed by ..."
};

/// The grade of a world.
struct OwnWorldGrade {
  std::vector<Diagnostic> problems;  ///< Errors in the files: nothing was run.
  std::vector<Diagnostic> warnings;  ///< Slips.
  std::vector<OwnWorldPoint> points;
  bool cancelled = false;
  /// The first point that is not met; null if all are.
  const OwnWorldPoint* Missing() const;
  bool passed() const { return problems.empty() && !cancelled && !points.empty() && Missing() == nullptr; }
};

/// Grades the world in this folder: it has what is asked for; its checks hold with two seeds; one of them fails if no
/// agent has rules; and they notice when a rule is left out, each one in turn. Writes copies of the world into the
/// folder for temporary files. `on_run` is called before each set of runs with how many are done. Ctrl-C cancels it.
OwnWorldGrade GradeOwnWorld(const OwnWorldRules& rules, const std::filesystem::path& world,
                            const sim::DataFolders& data,
                            const std::function<void(std::size_t done, std::size_t of)>& on_run = {});

/// The names of the rules in a text, in their order.
std::vector<std::string> RuleNamesIn(const std::string& text);
/// The text without the rule of this name; all other text stays where it is.
std::string WithoutRule(const std::string& text, const std::string& name);

}  // namespace soarbox::app
