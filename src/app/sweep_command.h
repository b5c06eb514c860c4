// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soarbox::app {

/// Options of `soarbox sweep`.
struct SweepOptions {
  std::filesystem::path spec;    ///< A file, a folder with a sweep.toml, or the name of one of the program's scenarios.
  std::filesystem::path folder;  ///< Empty: next to the spec; below the current folder for one of the program's.
  std::vector<std::string> rules;  ///< "NAME=FILE", as for `soarbox run`; in each variant.
  int jobs = 0;
  std::string on = "here";  ///< Or "slurm".
  int tasks = 1;            ///< Of a job array.
  int task = -1;  ///< Executes only this part of the runs, as a task of many; -1: all, with tables at the end.
  std::vector<std::string> sbatch;  ///< Arguments of sbatch.
  bool cancel = false;
  bool mix = false;    ///< Rows of other builds are used, too.
  bool retry = false;  ///< Crashed and hung runs are repeated.
  bool json = false;   ///< Lines of JSON instead of text.
  /// `spec` is the folder of a sweep; `sample` of its runs are repeated and compared.
  bool verify = false;
  std::size_t sample = 20;  ///< 0: all.
};

int Sweep(const SweepOptions& options);

}  // namespace soarbox::app
