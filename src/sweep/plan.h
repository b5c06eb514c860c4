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
  std::vector<std::pair<std::string, std::string>> rules;       ///< Agent or file of rules, and its replacement.
  std::vector<std::pair<std::string, std::string>> parameters;  ///< "agent.scout.senses.sight" and a value, as TOML.
  std::vector<std::string> setup;                               ///< Lines of the Soar command language, before rules.
  std::string kernel;                                           ///< HOST:PORT of a kernel elsewhere.
  int line = 0;
};

/// A number to measure in a run besides those that each run has.
struct Metric {
  std::string name;
  enum class Of : std::uint8_t { kTimeOf, kAtEnd, kMax, kMean } of = Of::kAtEnd;
  std::size_t check = 0;  ///< kTimeOf.
  mission::Check asked;   ///< The others: one gauge or counter of these agents.
};

/// Who plays in a game of a tournament: agents by their number, in the order of the seats.
using Seating = std::vector<std::size_t>;

/// A sweep as its file has it.
struct Spec {
  std::filesystem::path file;
  std::string scenario;
  std::string record = "none";  ///< "failed", "all".
  mission::Mission mission;     ///< Checks, seeds and seconds.
  std::vector<Variant> variants;
  std::vector<Metric> metrics;
  /// A tournament: its agents, and who plays in each variant. Its last metrics are the points of the seats.
  std::vector<std::string> players;
  std::vector<Seating> seatings;
  std::vector<std::string> parameters;  ///< Names of all parameters, for columns.
  std::string whole;      ///< The spec as TOML that needs no other file: the checks of its mission are part of it.
  std::string judgement;  ///< The part of it that every row rests on: checks and metrics.
};

/// Reads it; adds everything that is wrong to the problems. `is_copy`: it is the copy that a sweep keeps in its folder,
/// whose files of rules need not be there any more.
Spec ReadSpec(const std::filesystem::path& file, std::vector<Diagnostic>& problems, bool is_copy = false);

/// A variant that is ready to run: its files lie below the sweep's folder, as they were when it began.
struct ReadyVariant {
  Variant variant;
  mission::LoadedMission loaded;
  std::string argument;  ///< What `soarbox run` takes to see it.
  std::string digest;    ///< What its rows rest on: files, checks, metrics, seconds.
};

struct Plan {
  std::vector<ReadyVariant> variants;
};

/// Whether the files that variants are made from must still be as they were when the sweep began.
enum class Sources : std::uint8_t {
  kCompare,
  kTrust,  ///< What is in the folder counts: for tasks of a sweep that has begun, and for reports.
};
/// Writes the files of each variant below the folder, unless they are there, and finds their scenarios. `rules`:
/// "NAME=FILE", rules that replace agents' own in all variants (sim::ReplaceRules).
Result<Plan> MakePlan(const Spec& spec, const std::filesystem::path& folder, const sim::DataFolders& data,
                      Sources sources, const std::vector<std::string>& rules = {});

/// A folder belongs to one sweep and one build: notes them there, or says how they differ from what it holds. Variants
/// may be added. `mix`: rows of another build count, too.
Result<void> ClaimFolder(const Spec& spec, const Plan& plan, const std::filesystem::path& folder, bool mix);
/// A word of a command line, in quotes where a shell wants them.
std::string ShellWord(const std::string& word);
/// The spec as ClaimFolder keeps it.
std::filesystem::path KeptSpec(const std::filesystem::path& folder);

}  // namespace soarbox::sweep
