// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::sweep {

/// How a sweep is given to Slurm.
struct SlurmSettings {
  std::vector<std::string> task_command;  ///< What a task runs; "--task N" is added. The same command on each node.
  int tasks = 1;                          ///< Of the job array.
  std::string partition, account, time;   ///< As sbatch takes them; empty: the cluster's.
  std::string qos, memory;                ///< Likewise: --qos, --mem.
  int processors = 0;                     ///< Of a task; 0: the cluster's.
  std::vector<std::string> more;          ///< Further arguments of sbatch, as they are.
};

/// A sentence that says what is missing if Slurm's commands are not installed here; empty if they are.
std::string WhyNoSlurm();

/// Submits a job array and waits until Slurm no longer knows it. If a job of this folder still runs, waits for that one
/// instead. It asks `goes_on` every few seconds, with what Slurm said if it gave no answer, and with the reason why
/// tasks cannot begin (a held job, a drained node); false leaves the job alone and returns.
Result<void> RunOnSlurm(const std::filesystem::path& folder, const SlurmSettings& settings,
                        const std::function<bool(const std::string& no_answer, const std::string& held)>& goes_on);
/// Ends the job of this folder, if there is one. Whoever waits for it hears of it.
Result<void> CancelOnSlurm(const std::filesystem::path& folder);

}  // namespace soarbox::sweep
