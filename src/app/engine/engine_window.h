// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "app/window.h"

namespace soarbox::app {

/// Options of `soarbox engine`, which the server starts; users do not.
struct EngineOptions {
  std::string world;           ///< A scenario of the program; the learner gets a copy of it, and keeps it.
  std::filesystem::path from;  ///< Where the world is copied from, if it is none of the program's.
  std::string run;             ///< Or what `soarbox run` takes, as it is.
  std::string follow;          ///< Or the address of a kernel whose agents are watched.
  std::optional<std::uint64_t> seed;
  std::string lesson;               ///< Or a lesson, whose files are put into the learner's folder.
  std::filesystem::path recording;  ///< Or a recording.
  std::filesystem::path match;      ///< Or a scenario that runs to its end, for its scores.
  double match_s = 60;              ///< Maximum duration in simulated seconds.
  std::filesystem::path home;       ///< Files that the learner edits may be written only below this folder.
  bool is_walled = false;           ///< For strangers: the process can access only its place and the program's data.
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
  /// Returns null if it cannot begin; the error was printed on standard error.
  static std::unique_ptr<SteppedEngine> Make(const EngineOptions& options);
  virtual ~SteppedEngine() = default;

  /// Executes the requests of pages and the ticks that are due. Returns the longest time in ms until the next call, or
  /// nothing when the run is over.
  virtual std::optional<int> Step() = 0;
};

}  // namespace soarbox::app
