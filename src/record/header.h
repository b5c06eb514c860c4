// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "diagnostics/result.h"
#include "record/format.h"
#include "record/kept_files.h"
#include "record/tick_record.h"
#include "sim/scenario.h"
#include "sim/simulation.h"

namespace soarbox::record {

/// What a recording is a recording of: enough to run it again.
struct Header {
  std::string build;     ///< The program that made it (BuildId()).
  std::string scenario;  ///< As the user named it, from `folder`.
  std::string folder;    ///< The working directory of the run, absolute.
  std::vector<std::string> extra_folders;
  std::uint64_t scenario_digest = 0;  ///< Of the scenario's files (ReadScenarioFiles).
  std::uint64_t seed = 1;
  std::uint32_t screen_width_px = 1280;
  std::uint32_t screen_height_px = 720;
  double step_s = 1.0 / 30;  ///< Simulated seconds per tick.
  Level level = Level::kDecisions;
  bool own_kernel = true;         ///< False: minds lived in a kernel that is not ours, which tells less.
  std::vector<KeptFile> files;    ///< What it was made from, as it was then; empty if that was not kept.
  std::string branched_from;      ///< The recording of the run that this one went back in and left; empty: of none.
  std::uint64_t branch_tick = 0;  ///< The last tick that both have.
  /// Rules that took the place of those that agents would have had: agent's name, file. Since version 7.
  std::vector<std::pair<std::string, std::string>> replaced_rules;
  std::uint64_t memory_mb = sim::SimulationSettings{}.limits.memory_bytes >> 20;  ///< That the world might take.
};

/// The header for a run of this scenario, made with these settings from the present folder. `scenario` and
/// `extra_folders` are left as the scenario's name says: whoever knows what the user typed puts that in.
Header HeaderOf(const sim::Scenario& scenario, const sim::SimulationSettings& settings, double step_s, Level level);

/// The header's block, without the block's own frame (format.h).
std::string EncodeHeader(const Header& header);
/// `version`: that of the format, which says how far a header goes.
Result<Header> DecodeHeader(std::string_view bytes, std::uint16_t version = kVersion);

/// Names this program: its version and the linker's hash of it. Two builds with one id behave alike.
std::string BuildId();

/// "world", "decisions", "all".
std::string_view NameOf(Level level);
Result<Level> LevelNamed(std::string_view name);

}  // namespace soarbox::record
