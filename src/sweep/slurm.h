// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "diagnostics/result.h"

namespace soarbox::sweep {

/// How a sweep is submitted to Slurm.
struct SlurmSettings {
  std::vector<std::string> task_command;  ///< The command of a task, to which "--task N" is added. It must work on each
                                          ///< node.
  int tasks = 1;                          ///< Number of tasks in the job array.
  std::vector<std::string> sbatch;        ///< Further arguments of sbatch, unchanged.
};

/// Says what is missing if Slurm's commands are not installed here; empty if they are.
std::string WhyNoSlurm();

/// Submits a job array and waits until Slurm no longer lists it. If a job of this folder still runs, waits for that job
/// instead. Calls `goes_on` about once per second, with Slurm's error message if it did not answer, and with the reason
/// if tasks cannot start (a held job, a drained node). If that returns false, returns and leaves the job running.
/// Fails if Slurm is not installed or does not accept the job, or if CancelOnSlurm cancelled the job.
Result<void> RunOnSlurm(const std::filesystem::path& folder, const SlurmSettings& settings,
                        const std::function<bool(const std::string& no_answer, const std::string& held)>& goes_on);
/// Cancels the job of this folder. RunOnSlurm then fails. Fails if the folder has no job, or if Slurm does not cancel
/// it.
Result<void> CancelOnSlurm(const std::filesystem::path& folder);

}  // namespace soarbox::sweep
