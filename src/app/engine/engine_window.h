// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/window.h"

namespace soarbox::app {

/// Options of `soarbox engine`, which only the server starts. One of `world`, `run`, `follow`, `lesson`, `recording`
/// and `match` says what to run or show.
struct EngineOptions {
  std::string world;           ///< A scenario, of which the user gets a copy in `home`. An existing copy is used.
  std::filesystem::path from;  ///< The folder from which `world` is copied; empty: the program's scenario of that name.
  std::string run;             ///< A scenario as for `soarbox run`, which is run without a copy.
  std::string follow;          ///< The address of a kernel whose agents are watched.
  std::optional<std::uint64_t> seed;
  std::string lesson;               ///< A lesson, whose files are copied to the learner's folder.
  std::filesystem::path recording;  ///< A recording.
  std::filesystem::path match;      ///< A scenario that is run to its end without pages, for its scores.
  double match_s = 60;              ///< Maximum duration of a match in simulated seconds.
  std::filesystem::path home;       ///< Files that the learner edits may be written only below this folder.
  bool is_walled = false;           ///< The process can access only its place and the program's data (RaiseWall).
  int memory_mb = 256;
  bool may_join = false;  ///< It may join an exercise of other simulations, as the scenario says, or `dis`.
  std::string dis;        ///< As for `soarbox run`.
  int socket = 3;         ///< Descriptor of the connection to the server.
};

/// Runs a scenario or shows a recording for pages in browsers, until the server closes the connection. Returns an
/// ExitCode; errors are printed on standard error.
int Engine(const EngineOptions& options);

/// The same for a program that must not block, such as a worker of a page: its own loop calls Step(). Only one may
/// exist at a time.
class SteppedEngine {
 public:
  /// Returns null if it cannot begin; the page was sent the error.
  static std::unique_ptr<SteppedEngine> Make(const EngineOptions& options);
  virtual ~SteppedEngine() = default;

  /// Executes the requests of pages and the ticks that are due. Returns the longest time in ms until the next call, or
  /// nothing when the run is over.
  virtual std::optional<int> Step() = 0;
};

}  // namespace soarbox::app
