// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace soarbox::app {

/// Options of `soarbox inspect`.
struct InspectOptions {
  std::string source;           ///< A scenario as for `soarbox run`, or a recording.
  std::string agent;            ///< Empty: the first one with a Soar mind.
  std::string view = "agents";  ///< With its argument: "rule propose*move".
  double at_s = 5;
  double from_s = 0;   ///< For views over ticks.
  std::string until;   ///< A breakpoint that ends the run sooner: "fire RULE"; scenarios only.
  std::string kernel;  ///< HOST:PORT of a Soar kernel elsewhere; empty: our own.
  bool json = false;
  bool recorded = false;  ///< Of a recording: show the recorded data, without simulating again.
  std::optional<std::uint64_t> seed;
  std::vector<std::filesystem::path> extra_folders;
};
/// Prints the contents of a debugger view at a moment of a run. Returns an ExitCode.
int Inspect(const InspectOptions& options);

}  // namespace soarbox::app
