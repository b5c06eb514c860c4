// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/slurm.h"

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <optional>
#include <sstream>
#include <thread>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "sweep/plan.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;

constexpr auto kLook = std::chrono::milliseconds(1000);

std::string Quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

struct Answer {
  int code = -1;
  std::string text;  ///< Its output, including errors.
};

Answer Ask(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) line += Quoted(word) + " ";
  Answer answer;
  std::FILE* pipe = popen((line + "2>&1").c_str(), "re");
  if (pipe == nullptr) return answer;
  std::array<char, 4096> bytes;
  for (std::size_t got = 0; (got = fread(bytes.data(), 1, bytes.size(), pipe)) > 0;)
    answer.text.append(bytes.data(), got);
  const int status = pclose(pipe);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return answer;
}

bool IsJob(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// The last job of this folder's sweep; empty if there is none. Only a job number is accepted: the file may come from
/// an untrusted author, and Slurm's commands would also accept options.
std::string JobOf(const fs::path& folder) {
  std::string job = ReadText(folder / "slurm" / "job").value_or("");
  while (!job.empty() && (job.back() == '\n' || job.back() == ' ')) job.pop_back();
  return IsJob(job) ? job : std::string();
}

enum class Known : std::uint8_t { kYes, kNo, kNoAnswer };

/// Why waiting tasks cannot start, according to Slurm; empty if they only wait for others.
std::string HeldBy(const std::string& listing) {
  std::istringstream lines(listing);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("PENDING ")) continue;
    const std::string reason = line.substr(8);
    if (reason != "None" && reason != "Priority" && reason != "Resources" && reason != "BeginTime") return reason;
  }
  return {};
}

/// Whether Slurm still has tasks of the job. Without an answer (the controller is busy or down), it is not known. Sets
/// `held` to the reason why waiting tasks cannot start.
Known IsKnown(const std::string& job, std::string& why, std::string& held) {
  const Answer answer = Ask({"squeue", "--noheader", "--jobs", job, "--format", "%T %r"});
  held = answer.code == 0 ? HeldBy(answer.text) : std::string();
  if (answer.code == 0) return answer.text.find_first_not_of(" \n") != std::string::npos ? Known::kYes : Known::kNo;
  if (answer.text.find("Invalid job id") != std::string::npos) return Known::kNo;
  why = answer.text.substr(0, answer.text.find('\n'));
  return Known::kNoAnswer;
}

/// Maximum number of tasks in an array; nothing if the cluster does not report it.
std::optional<int> MostTasks() {
  const Answer answer = Ask({"scontrol", "show", "config"});
  const std::size_t at = answer.text.find("MaxArraySize");
  const std::size_t sign = answer.text.find('=', at);
  if (answer.code != 0 || at == std::string::npos || sign == std::string::npos) return std::nullopt;
  const std::size_t digits = answer.text.find_first_not_of(' ', sign + 1);
  int most = 0;
  if (digits == std::string::npos) return std::nullopt;
  const char* const end = answer.text.data() + answer.text.size();
  if (std::from_chars(answer.text.data() + digits, end, most).ec != std::errc() || most < 1) return std::nullopt;
  return most;
}

}  // namespace

std::string ShellWord(const std::string& word) {
  const bool is_plain = !word.empty() && std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) != 0 || std::string_view("/._-+~=:,@").find(static_cast<char>(c)) != std::string_view::npos;
  });
  return is_plain ? word : Quoted(word);
}

std::string WhyNoSlurm() {
  for (const char* program : {"sbatch", "squeue", "scancel"}) {
    if (Ask({"sh", "-c", std::string("command -v ") + program}).code != 0)
      return std::string("Slurm's command '") + program + "' is not installed on this machine";
  }
  return {};
}

Result<void> RunOnSlurm(const fs::path& folder, const SlurmSettings& settings,
                        const std::function<bool(const std::string& no_answer, const std::string& held)>& goes_on) {
  if (const std::string missing = WhyNoSlurm(); !missing.empty())
    return NewProblem(missing,
                      "run this on a login node of the cluster, or without --on slurm to use this machine's cores");
  std::string job = JobOf(folder);
  std::string why, held;
  if (job.empty() || IsKnown(job, why, held) == Known::kNo) {
    // The index of a task must be below MaxArraySize. With fewer tasks, each does more runs.
    int tasks = settings.tasks;
    if (const std::optional<int> most = MostTasks(); most && tasks > *most) {
      std::cerr << "Slurm takes at most " << *most << " tasks in an array here (MaxArraySize): " << tasks << " become "
                << *most << ", each with a larger share of the runs\n";
      tasks = *most;
    }
    std::error_code error;
    fs::create_directories(folder / "slurm", error);
    const fs::path script = fs::absolute(folder / "slurm" / "task.sh", error);
    std::ostringstream text;
    text << "#!/bin/sh\n# One task of a sweep; Soarbox wrote this.\nexec";
    for (const std::string& word : settings.task_command) text << ' ' << Quoted(word);
    text << " --tasks " << tasks
         << " --task \"$SLURM_ARRAY_TASK_ID\" --jobs \"${SLURM_CPUS_PER_TASK:-${SLURM_CPUS_ON_NODE:-0}}\"\n";
    if (!(std::ofstream(script) << text.str()).flush())
      return NewProblem("'" + script.string() + "' cannot be written");
    std::vector<std::string> words = {"sbatch",
                                      "--parsable",
                                      "--requeue",
                                      "--job-name=soarbox-sweep",
                                      "--array=0-" + std::to_string(tasks - 1),
                                      "--output=" + fs::absolute(folder / "slurm", error).string() + "/%A_%a.log"};
    words.insert(words.end(), settings.sbatch.begin(), settings.sbatch.end());
    words.push_back(script.string());
    const Answer submitted = Ask(words);
    job = submitted.text.substr(0, submitted.text.find_first_of(";\n"));
    if (submitted.code != 0 || !IsJob(job))
      return NewProblem(
          "Slurm did not accept the job: " + submitted.text,
          "sinfo shows the partitions and their nodes; scontrol show config the limits, such as MaxArraySize");
    if (!(std::ofstream(folder / "slurm" / "job") << job << '\n').flush())
      return NewProblem("the job's number cannot be written below '" + folder.string() + "'");
  }
  for (Known known; (known = IsKnown(job, why, held)) != Known::kNo;) {
    if (!goes_on(known == Known::kNoAnswer ? why : std::string(), held)) return {};
    std::this_thread::sleep_for(kLook);
  }
  // Another command has cancelled the job and removed its number.
  if (JobOf(folder) != job)
    return NewProblem("job " + job + " was cancelled", "the same command continues with what is missing");
  return {};
}

Result<void> CancelOnSlurm(const fs::path& folder) {
  if (const std::string missing = WhyNoSlurm(); !missing.empty()) return NewProblem(missing);
  const std::string job = JobOf(folder);
  if (job.empty()) return NewProblem("this sweep was not given to Slurm");
  if (const Answer answer = Ask({"scancel", job}); answer.code != 0)
    return NewProblem("Slurm did not end job " + job + ": " + answer.text);
  std::error_code error;
  if (!fs::remove(folder / "slurm" / "job", error))
    return NewProblem("'" + (folder / "slurm" / "job").string() + "' cannot be removed: " + error.message());
  return {};
}

}  // namespace soarbox::sweep
