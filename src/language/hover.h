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

/// What is known of an earlier run: how often each rule fired, in all agents together.
struct LastRun {
  std::filesystem::path file;
  struct Firings {
    std::uint64_t count = 0;
    double first_s = 0, last_s = 0;  ///< Simulated time.
  };
  std::map<std::string, Firings> rules;
  bool has_firings = false;  ///< The recording holds firings at all (level all).
};

/// "fired 12 times in run-0003.soarrec", "never fired in ..."; empty if the run does not say.
std::string TellFirings(const LastRun& run, const std::string& rule);

/// What you want to know about the name at a place, as Markdown: what a rule does, what a percept or a command means
/// and its unit, where an attribute is made and tested, which rules propose and apply an operator. Empty if nothing is
/// known.
std::string Hover(const Program& program, const Document& document, const Name& name, const LastRun* run);

}  // namespace soarbox::language
