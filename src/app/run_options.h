// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/window_wishes.h"

namespace soarbox::app {

/// Options of `soarbox run`.
struct RunOptions : WindowWishes {
  std::string scenario = "thesis";
  std::vector<std::filesystem::path> extra_folders;
  std::vector<std::string> rules;  ///< "NAME=FILE": rules that replace those of an agent.
  bool headless = false;
  std::optional<double> seconds;      ///< Simulated; none: until the window is closed, or 60 s headless.
  std::optional<std::uint64_t> seed;  ///< None: the scenario's own, else 1.
  std::optional<double> speed;        ///< Times real time; none: 1 with a window, as fast as possible without.
  bool json = false;
  bool every_command = false;
  bool profile = false;            ///< Print the number of calls of script functions and their times at the end.
  std::optional<double> report_s;  ///< Print all agents at this interval, in simulated seconds.
  std::string screenshot;          ///< PNG file; empty: none.
  double screenshot_at_s = 5;
  std::vector<std::string> show;           ///< Overlays that are initially on: "trails", "belief".
  std::string select;                      ///< Name of the initially selected agent.
  std::string camera;                      ///< "map", "follow"; empty: shows all agents.
  std::optional<int> port;                 ///< For debuggers; none: 12121 with a window if it is free, closed without.
  std::string follow;                      ///< HOST:PORT of a Soar kernel whose agents are watched; empty: none.
  std::string kernel;                      ///< HOST:PORT of a Soar kernel in another process; empty: our own.
  std::string input;                       ///< File of inputs with ticks; empty: none.
  int threads = 0;                         ///< For the minds; 0: one per core.
  int memory_mb = 2048;                    ///< Maximum memory of the world: scripts, minds and bodies.
  std::filesystem::path record;            ///< File of the recording; empty: none, or in a window the usual one.
  bool no_record = false;                  ///< Do not record, not even in a window.
  std::string record_level = "decisions";  ///< The name of a record::Level.
  std::optional<double> record_limit_mb;   ///< None: no limit, or kUsualLimitMb in the usual file.
  std::string remark;                      ///< For the window: the file of the recording.
  std::string warning;                     ///< For pages: limitations of this run.
  std::filesystem::path lesson;            ///< The folder of the lesson of this world; empty: determined by its name.
  bool watch = false;    ///< Edits of rules and scripts are reloaded during the run; a window always does this.
  std::string dis;       ///< ADDRESS:PORT[,...]: joins an exercise of other simulations; empty: as the scenario says.
  bool may_join = true;  ///< False: the run is never connected, whatever the scenario says.
  bool by_strangers = false;    ///< The user of the run is not the user of this machine: commands are restricted.
  double kernel_limit_s = 2.0;  ///< Time without an answer after which that kernel counts as gone.
};

/// Executes `soarbox run`; returns an ExitCode.
int Run(const RunOptions& options);

}  // namespace soarbox::app
