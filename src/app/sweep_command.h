// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::app {

/// What `soarbox sweep` was asked for.
struct SweepOptions {
  std::filesystem::path spec;    ///< A file, a folder with a sweep.toml, or such a name below the program's scenarios.
  std::filesystem::path folder;  ///< Empty: beside the spec; below the current folder for one of the program's.
  std::vector<std::string> rules;  ///< "NAME=FILE", as for `soarbox run`; in each variant.
  int jobs = 0;
  std::string on = "here";  ///< Or "slurm".
  int tasks = 1;            ///< Of a job array.
  int task = -1;            ///< Only this part of the runs: a task of many; -1: all, and tables at the end.
  std::string partition, account, time, qos, memory;
  int processors = 0;
  std::vector<std::string> sbatch;  ///< Further arguments of sbatch.
  bool cancel = false;
  bool mix = false;    ///< Rows of other builds count too.
  bool retry = false;  ///< Crashed and hung runs are made again.
  bool json = false;   ///< Lines of JSON instead of text.
  /// `spec` is the folder of a sweep, of which so many runs are made again and compared.
  bool verify = false;
  std::size_t sample = 20;  ///< 0: all.
};

int Sweep(const SweepOptions& options);

}  // namespace soarbox::app
