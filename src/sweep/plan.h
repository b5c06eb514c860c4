// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "mission/testing.h"

namespace soarbox::sweep {

/// One variant of the scenario. A list of values in the file is expanded to one variant for each value.
struct Variant {
  std::string name;
  std::string scenario;                                         ///< The variant's own scenario; empty: that of the
                                                                ///< sweep.
  std::vector<std::pair<std::string, std::string>> rules;       ///< Agent or file of rules, and its replacement.
  std::vector<std::pair<std::string, std::string>> parameters;  ///< "agent.scout.senses.sight" and a value, as TOML.
  std::vector<std::string> setup;                               ///< Lines of the Soar command language that are
                                                                ///< executed before the rules are loaded.
  std::string kernel;                                           ///< HOST:PORT of a remote kernel; empty: our own.
  int line = 0;
};

/// A number to measure in a run, in addition to those of every run.
struct Metric {
  std::string name;
  enum class Of : std::uint8_t { kTimeOf, kAtEnd, kMax, kMean } of = Of::kAtEnd;
  std::size_t check = 0;  ///< For kTimeOf: index of the check.
  mission::Check asked;   ///< For the other kinds: one gauge or counter of these agents.
};

/// The agents in a game of a tournament: their indices, in the order of the seats.
using Seating = std::vector<std::size_t>;

/// The content of a sweep file.
struct Spec {
  std::filesystem::path file;
  std::string scenario;
  std::string record = "none";  ///< "failed", "all".
  mission::Mission mission;     ///< Contains the checks, seeds and seconds.
  std::vector<Variant> variants;
  std::vector<Metric> metrics;
  /// For a tournament: its agents, and the agents in each variant. The last metrics are the points of the seats.
  std::vector<std::string> players;
  std::vector<Seating> seatings;
  std::vector<std::string> parameters;  ///< Names of all parameters, for the columns of tables.
  std::string whole;      ///< The spec as TOML without references to other files: it includes the checks of its
                          ///< mission.
  std::string judgement;  ///< The checks and metrics in it, on which every row depends.
};

/// Reads a sweep file and adds all errors to `problems`. `is_copy`: the file is the copy in a sweep's folder. Its rule
/// files need not exist any more.
Spec ReadSpec(const std::filesystem::path& file, std::vector<Diagnostic>& problems, bool is_copy = false);

/// A variant that is ready to run. Its files were copied to the sweep's folder when the sweep began.
struct ReadyVariant {
  Variant variant;
  mission::LoadedMission loaded;
  std::string argument;  ///< The argument for `soarbox run` to watch it.
  std::string digest;    ///< Digest of everything that its rows depend on: files, checks, metrics, seconds.
};

struct Plan {
  std::vector<ReadyVariant> variants;
};

/// Whether the source files of variants must be unchanged since the sweep began.
enum class Sources : std::uint8_t {
  kCompare,
  kTrust,  ///< Use the copies in the folder: for tasks of a running sweep, and for reports.
};
/// Writes the files of each variant to the folder, unless they exist, and finds their scenarios. `rules`: "NAME=FILE",
/// replacements for agents' rules in all variants (sim::ReplaceRules).
Result<Plan> MakePlan(const Spec& spec, const std::filesystem::path& folder, const sim::DataFolders& data,
                      Sources sources, const std::vector<std::string>& rules = {});

/// Reserves a folder for one sweep and one build, or fails and says how they differ from the folder's contents.
/// Variants can be added later. `mix`: accept rows of another build.
Result<void> ClaimFolder(const Spec& spec, const Plan& plan, const std::filesystem::path& folder, bool mix);
/// Quotes a word for a shell if necessary.
std::string ShellWord(const std::string& word);
/// The file in which ClaimFolder stores the spec.
std::filesystem::path KeptSpec(const std::filesystem::path& folder);

}  // namespace soarbox::sweep
