// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "record/file_format.h"
#include "record/kept_files.h"
#include "record/tick_record.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::record {

/// The data that are sufficient to run a recorded run again.
struct Header {
  std::string build;     ///< The program that made it (BuildId()).
  std::string scenario;  ///< As the user named it, relative to `folder`.
  std::string folder;    ///< The working directory of the run, absolute.
  std::vector<std::string> extra_folders;
  std::uint64_t scenario_digest = 0;  ///< Digest of the scenario's files (ReadScenarioFiles).
  std::uint64_t seed = 1;
  std::uint32_t screen_width_px = 1280;
  std::uint32_t screen_height_px = 720;
  double step_s = 1.0 / 30;  ///< Simulated seconds per tick.
  Level level = Level::kDecisions;
  bool own_kernel = true;         ///< False: minds ran in another kernel, which reports less.
  bool has_origins = false;       ///< The kernels noted origins for *Why*, which keep identifiers in memory.
  std::vector<KeptFile> files;    ///< The files of the run as they were at its beginning; empty if they were not kept.
  std::string branched_from;      ///< The recording of the run from which this one branched; empty if it did not.
  std::uint64_t branch_tick = 0;  ///< The last tick that both have in common.
  /// Rules that replaced those of agents: agent's name, file.
  std::vector<std::pair<std::string, std::string>> replaced_rules;
  std::uint64_t memory_mb = sim::SimulationSettings{}.limits.memory_bytes >> 20;  ///< Memory limit of the world.
};

/// The header for a run of this scenario, created with these settings from the current folder. `scenario` is set to the
/// scenario's name, and `extra_folders` stays empty; a caller that has the user's input sets both.
Header HeaderOf(const sim::Scenario& scenario, const sim::SimulationSettings& settings, double step_s, Level level);

/// The payload of the header's block (file_format.h).
std::string EncodeHeader(const Header& header);
Result<Header> DecodeHeader(std::string_view bytes);

/// Identifies this program: its version and the linker's hash of it. Two builds with the same id behave alike.
std::string BuildId();
/// Replaces the id by that of another program that was built together with this one. Call it before BuildId.
void SetBuildId(std::string id);

/// "world", "decisions", "all".
std::string_view NameOf(Level level);
Result<Level> LevelNamed(std::string_view name);

}  // namespace soarbox::record
