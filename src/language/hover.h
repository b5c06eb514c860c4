// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "language/names.h"

namespace soarbox::language {

/// The data of an earlier run: how often each rule fired, summed over all agents.
struct LastRun {
  std::filesystem::path file;
  struct Firings {
    std::uint64_t count = 0;
    double first_s = 0, last_s = 0;  ///< In simulated time.
  };
  std::map<std::string, Firings> rules;
  bool has_firings = false;  ///< The recording contains firings (Level::kAll).
};

/// "fired 12 times in run-0003.soarrec", "never fired in ..."; empty if the recording contains no firings.
std::string TellFirings(const LastRun& run, const std::string& rule);

/// Explains the name at a position, as Markdown: what a rule does, the meaning and unit of a percept or a command,
/// where an attribute is made and tested, which rules propose and apply an operator. Empty if there is nothing to
/// report. `run` may be null.
std::string Hover(const Program& program, const Document& document, const Name& name, const LastRun* run);

}  // namespace soarbox::language
