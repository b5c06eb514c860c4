// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soarbox::app {

/// Options of `soarbox check`.
struct CheckOptions {
  std::vector<std::filesystem::path> files;
  bool json = false;
};
/// Returns an ExitCode: kProblems if there is an error or a warning.
int Check(const CheckOptions& options);

/// Options of `soarbox why`.
struct WhyOptions {
  std::string scenario;  ///< Or a recording.
  std::string agent;     ///< Empty: the first one with a mind.
  std::string
      topic;  ///< A command, an operator or a rule; empty: explains what the agent does, or why it does nothing.
  std::optional<double> at_s;  ///< Simulated; none: 5, or the nearest recorded tick of a recording.
  bool json = false;
  std::optional<std::uint64_t> seed;
  std::vector<std::filesystem::path> extra_folders;
};
/// Runs the scenario headless up to a time, or a recorded run again, and prints why an agent does what it does at that
/// time. Returns an ExitCode.
int Why(const WhyOptions& options);

}  // namespace soarbox::app
