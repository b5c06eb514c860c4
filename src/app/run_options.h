// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/window_wishes.h"

namespace soarbox::app {

/// What `soarbox run` was asked for.
struct RunOptions : WindowWishes {
  std::string scenario = "thesis";
  std::vector<std::filesystem::path> extra_folders;
  std::vector<std::string> rules;  ///< "NAME=FILE": rules that take the place of those that an agent would have.
  bool headless = false;
  std::optional<double> seconds;      ///< Simulated; none: until the window is closed, or 60 s headless.
  std::optional<std::uint64_t> seed;  ///< None: the scenario's own, else 1.
  std::optional<double> speed;        ///< Times real time; none: 1 with a window, as fast as possible without.
  bool json = false;
  bool every_command = false;
  bool profile = false;            ///< Print at the end how often functions of scripts were called, and their times.
  std::optional<double> report_s;  ///< Print all agents each so many simulated seconds.
  std::string screenshot;          ///< PNG file; empty: none.
  double screenshot_at_s = 5;
  std::vector<std::string> show;           ///< Overlays that are on from the start: "trails", "belief".
  std::string select;                      ///< Name of the agent that is selected from the start.
  std::string camera;                      ///< "map", "follow"; empty: all agents are framed.
  std::optional<int> port;                 ///< For debuggers; none: 12121 with a window if it is free, closed without.
  std::string follow;                      ///< HOST:PORT of a Soar kernel whose agents are watched; empty: none.
  std::string kernel;                      ///< HOST:PORT of a Soar kernel in another process; empty: our own.
  std::string input;                       ///< File of inputs with ticks; empty: none.
  int threads = 0;                         ///< For the minds; 0: one per core.
  int memory_mb = 2048;                    ///< That the world may take: scripts, minds and bodies.
  std::filesystem::path record;            ///< File of the recording; empty: none, or in a window the usual one.
  bool no_record = false;                  ///< Not even in a window.
  std::string record_level = "decisions";  ///< record::LevelNamed.
  std::optional<double> record_limit_mb;   ///< None: no limit, or kUsualLimitMb in the usual file.
  std::string remark;                      ///< For the window's status bar: where the recording goes.
  std::string warning;                     ///< For pages: what this run does not do.
  std::filesystem::path lesson;  ///< The folder of the lesson that this world belongs to; empty: looked up by name.
  bool watch = false;            ///< Edits of rules and scripts reach the running world; a window always watches.
  std::string dis;       ///< ADDRESS:PORT[,...]: joins an exercise of other simulations; empty: as the scenario says.
  bool may_join = true;  ///< Else it is on its own, whatever the scenario says.
  bool by_strangers = false;    ///< Whoever watches is not the user of this machine: what he types is fenced.
  double kernel_limit_s = 2.0;  ///< How long that kernel may be silent before it counts as gone.
};

/// Carries out `soarbox run`; returns an ExitCode.
int Run(const RunOptions& options);

}  // namespace soarbox::app
