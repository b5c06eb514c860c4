// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
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
  std::uint64_t scenario_digest = 0;  ///< Of the scenario's own files (DigestOf).
  std::uint64_t seed = 1;
  std::uint32_t screen_width_px = 1280;
  std::uint32_t screen_height_px = 720;
  double step_s = 1.0 / 30;  ///< Simulated seconds per tick.
  Level level = Level::kDecisions;
  bool own_kernel = true;  ///< False: minds lived in a kernel that is not ours, which tells less.
};

/// The header for a run of this scenario, made with these settings from the present folder. `scenario` and
/// `extra_folders` are left as the scenario's name says: whoever knows what the user typed puts that in.
Header HeaderOf(const sim::Scenario& scenario, const sim::SimulationSettings& settings, double step_s, Level level);

/// The header's block, without the block's own frame (format.h).
std::string EncodeHeader(const Header& header);
Result<Header> DecodeHeader(std::string_view bytes);

/// Names this program: its version and the linker's hash of it. Two builds with one id behave alike.
std::string BuildId();

/// A digest of the scenario's own files: those below its script's folder that a run may read (.lua, .soar, .toml and
/// the like; the first 2,000 by name), its scenario file and its rules.
std::uint64_t DigestOf(const sim::Scenario& scenario);

/// "world", "decisions", "all".
std::string_view NameOf(Level level);
Result<Level> LevelNamed(std::string_view name);

}  // namespace soarbox::record
