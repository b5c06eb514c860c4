// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "mission/test_missions.h"

namespace soarbox::sweep {

/// One variant of the scenario, expanded: a list of values has become one variant for each.
struct Variant {
  std::string name;
  std::string scenario;                                         ///< Its own; empty: the sweep's.
  std::vector<std::pair<std::string, std::string>> rules;       ///< Agent or file of rules, and the file instead.
  std::vector<std::pair<std::string, std::string>> parameters;  ///< "agent.scout.senses.sight" and a value, as TOML.
  std::vector<std::string> setup;                               ///< Lines of the Soar command language, before rules.
  std::string kernel;                                           ///< HOST:PORT of a kernel elsewhere.
  int line = 0;
};

/// A number that a run is asked for besides those that each has.
struct Metric {
  std::string name;
  enum class Of : std::uint8_t { kTimeOf, kAtEnd, kMax, kMean } of = Of::kAtEnd;
  std::size_t check = 0;  ///< kTimeOf.
  mission::Check asked;   ///< The others: one gauge or counter of these agents.
};

/// A sweep as its file has it.
struct Spec {
  std::filesystem::path file;
  std::string scenario;
  std::string record = "none";  ///< "failed", "all".
  mission::Mission mission;     ///< Checks, seeds and seconds.
  std::vector<Variant> variants;
  std::vector<Metric> metrics;
  std::vector<std::string> parameters;  ///< Names of all parameters, for columns.
};

/// Reads it; everything that is wrong is added to the problems.
Spec ReadSpec(const std::filesystem::path& file, std::vector<Diagnostic>& problems);

/// A variant that is ready to run: its files lie below the sweep's folder, as they were when it began.
struct ReadyVariant {
  Variant variant;
  mission::LoadedMission loaded;
  std::string argument;  ///< What `soarbox run` takes to see it.
};

/// Writes the files of each variant below the folder, unless they are there, and finds their scenarios. The digest says
/// which sweep it is: files, checks, seconds.
struct Plan {
  std::vector<ReadyVariant> variants;
  std::string digest;
};
Result<Plan> MakePlan(const Spec& spec, const std::filesystem::path& folder, const sim::DataFolders& data);

}  // namespace soarbox::sweep
