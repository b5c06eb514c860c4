// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soarbox::app {

/// What `soarbox check` was asked for.
struct CheckOptions {
  std::vector<std::filesystem::path> files;
  bool json = false;
};
/// Returns an ExitCode: kProblems if there is an error or a warning.
int Check(const CheckOptions& options);

/// What `soarbox why` was asked for.
struct WhyOptions {
  std::string scenario;  ///< Or a recording.
  std::string agent;     ///< Empty: the first one with a mind.
  std::string topic;     ///< A command, an operator or a rule; empty: what it does, or why it does nothing.
  double at_s = 5;
  bool json = false;
  std::optional<std::uint64_t> seed;
  std::vector<std::filesystem::path> extra_folders;
};
/// Runs the scenario headless up to a time, or a recorded run again, and prints why an agent does what it does then.
/// Returns an ExitCode.
int Why(const WhyOptions& options);

}  // namespace soarbox::app
