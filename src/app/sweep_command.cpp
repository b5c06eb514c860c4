// SPDX-License-Identifier: BSD-2-Clause
#include "app/sweep_command.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <fstream>
#include <iostream>
#include <set>

#include "app/data_folders.h"
#include "app/diagnostic_json.h"
#include "app/exit_codes.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "mission/check_sentences.h"
#include "record/header.h"
#include "sweep/run_sweep.h"
#include "sweep/slurm.h"
#include "sweep/sweep_manifest.h"
#include "sweep/verify_sweep.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

constexpr int kMostRounds = 5;
constexpr int kLockWaits = 20;
constexpr useconds_t kLockWait_us = 100'000;

void Show(const sweep::Progress& progress, bool is_terminal, std::chrono::steady_clock::time_point begin) {
  if (!is_terminal) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  const std::size_t all = progress.there_before + progress.done;
  std::cerr << "\r" << all << " of " << progress.planned << " runs";
  if (progress.done > 0 && seconds > 1) {
    const double rate = static_cast<double>(progress.done) / seconds;
    std::cerr << ", " << mission::NumberText(rate) << " per second, "
              << static_cast<int>(static_cast<double>(progress.planned - all) / rate) << " s to go";
  }
  if (progress.failed > 0) std::cerr << ", " << progress.failed << sweep::kCrashedOrHung;
  std::cerr << "   " << std::flush;
}

/// Locks the folder against other sweeps on this machine while this process exists, because two sweeps would execute
/// each run twice. Also true if the file system has no locks.
bool LockFolder(const fs::path& folder) {
  const int file = open((folder / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0666);
  if (file < 0) return true;
  // Waits for a while: if a sweep was killed, its runs hold the lock until they end, too.
  for (int wait = 0; wait < kLockWaits; ++wait) {
    if (flock(file, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return true;
    usleep(kLockWait_us);
  }
  close(file);
  return false;
}

/// The sweep at this place: the file itself, or the sweep.toml in the folder.
fs::path SweepAt(const fs::path& place) {
  std::error_code error;
  if (fs::is_regular_file(place, error)) return place;
  if (fs::is_regular_file(place / "sweep.toml", error)) return place / "sweep.toml";
  return {};
}

/// Replaces the name of a sweep that comes with the program by its file. Its results go below the current folder,
/// because the program's own folders may be read-only. Unknown names are unchanged.
SweepOptions WithFile(SweepOptions options, const sim::DataFolders& data) {
  const fs::path named = options.spec;
  if (const fs::path own = SweepAt(named); !own.empty()) {
    options.spec = own;
  } else if (const fs::path shipped = SweepAt(data.scenarios / named); !shipped.empty()) {
    options.spec = shipped;
    if (options.folder.empty()) options.folder = named.stem().string() + ".sweep";
  }
  return options;
}

/// Repeats runs of a sweep's folder.
int Verify(const SweepOptions& options, const sim::DataFolders& data) {
  CatchInterrupts();
  const Result<sweep::Verification> found =
      sweep::VerifySweep(options.spec, data, options.sample, options.jobs, [] { return !WasInterrupted(); });
  if (!found) return Refuse(found.error());
  if (!found->other_build.empty())
    std::cerr << "runs of this folder were made by another build: " << found->other_build << '\n';
  for (const std::string& line : found->differing) std::cout << line << '\n';
  if (found->unmatched > 0)
    std::cout << found->unmatched << " rows belong to no variant that the folder holds: its files have changed\n";
  std::cout << found->made << " of " << found->all << " runs made again, " << found->differing.size() << " differ\n";
  if (WasInterrupted()) return 130;
  return found->differing.empty() && found->unmatched == 0 ? static_cast<int>(kOk) : static_cast<int>(kProblems);
}

}  // namespace

int Sweep(const SweepOptions& asked) {
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  if (asked.verify) return Verify(asked, *data);
  const SweepOptions options = WithFile(asked, *data);
  std::vector<Diagnostic> problems;
  const sweep::Spec spec = sweep::ReadSpec(options.spec, problems);
  for (const Diagnostic& problem : problems) std::cerr << Format(problem);
  if (!problems.empty()) return kCannotStart;
  fs::path folder = options.folder;
  if (folder.empty()) folder = fs::path(options.spec).replace_extension(".sweep");
  if (options.cancel) {
    const Result<void> ended = sweep::CancelOnSlurm(folder);
    return ended ? static_cast<int>(kOk) : Refuse(ended.error());
  }
  if (options.on == "slurm") {
    if (const std::string missing = sweep::WhyNoSlurm(); !missing.empty())
      return Refuse(ProblemIn(
          {}, missing, "run this on a login node of the cluster, or without --on slurm to use this machine's cores"));
  }
  std::error_code error;
  fs::create_directories(folder / "parts", error);
  if (error)
    return Refuse(ProblemIn(folder, "this folder cannot be made: " + error.message(), "name another with --folder"));
  // A task of a job array finds the folder as created by the sweep that submitted it.
  const Result<sweep::Plan> plan = sweep::MakePlan(
      spec, folder, *data, options.task >= 0 ? sweep::Sources::kTrust : sweep::Sources::kCompare, options.rules);
  if (!plan) return Refuse(plan.error());
  if (const Result<void> claimed = sweep::ClaimFolder(spec, *plan, folder, options.mix); !claimed)
    return Refuse(claimed.error());
  if (options.on != "slurm" && options.task < 0 && !LockFolder(folder))
    return Refuse(
        ProblemIn(folder, "another sweep is making runs here", "wait for it, or name another folder with --folder"));
  if (options.task < 0) {
    if (const Result<void> tried = sweep::TryVariants(spec, *plan, folder, options.jobs); !tried)
      return Refuse(tried.error());
  }
  CatchInterrupts();
  const bool is_terminal = isatty(STDERR_FILENO) != 0;
  const auto begin = std::chrono::steady_clock::now();
  const std::size_t planned = spec.mission.seeds.size() * plan->variants.size();
  if (options.on == "slurm") {
    std::error_code ignored;
    sweep::SlurmSettings settings;
    settings.task_command = {fs::read_symlink("/proc/self/exe", ignored).string(), "sweep",
                             fs::absolute(options.spec, ignored).string(), "--folder",
                             fs::absolute(folder, ignored).string()};
    for (const std::string& rules : options.rules) {
      const std::size_t sign = rules.find('=');
      settings.task_command.emplace_back("--rules");
      settings.task_command.push_back(rules.substr(0, sign + 1) +
                                      fs::absolute(rules.substr(sign + 1), ignored).string());
    }
    if (options.mix) settings.task_command.emplace_back("--mix");
    if (options.retry) settings.task_command.emplace_back("--retry");
    settings.tasks = options.tasks;
    settings.sbatch = options.sbatch;
    // If nodes fail, some runs are missing at the end. These are submitted again.
    const auto made = [&] {
      std::vector<Diagnostic> found;
      return sweep::RowsOf(spec, *plan, folder, found).size();
    };
    sweep::Progress progress;
    progress.planned = planned;
    progress.there_before = made();
    auto next_look = begin;
    bool answers = true;
    std::string told_held;
    for (int round = 0; round < kMostRounds && !WasInterrupted(); ++round) {
      if (made() == planned && (round > 0 || !options.retry)) break;
      if (round > 0) std::cerr << "some runs are missing: submitted to Slurm again\n";
      const Result<void> done =
          sweep::RunOnSlurm(folder, settings, [&](const std::string& no_answer, const std::string& held) {
            if (held != told_held && !held.empty())
              std::cerr << (is_terminal ? "\n" : "") << "Slurm holds the jobs back: " << held
                        << "; squeue and sinfo --list-reasons say more\n";
            if (no_answer.empty()) told_held = held;
            if (answers != no_answer.empty()) {
              answers = no_answer.empty();
              std::cerr << (is_terminal ? "\n" : "")
                        << (answers ? "Slurm answers again" : "Slurm does not answer: " + no_answer + "; still waiting")
                        << '\n';
            }
            // Reading all rows takes long if there are many.
            if (const auto now = std::chrono::steady_clock::now(); is_terminal && now >= next_look) {
              progress.done = made() - progress.there_before;
              Show(progress, is_terminal, begin);
              next_look = now + 20 * (std::chrono::steady_clock::now() - now);
            }
            return !WasInterrupted();
          });
      if (is_terminal) std::cerr << '\n';
      if (!done) return Refuse(done.error());
    }
    if (WasInterrupted()) {
      std::cerr << "the jobs keep running; the same command waits for them again, --cancel ends them\n";
      return 130;
    }
  } else {
    sweep::SweepSettings settings;
    settings.jobs = options.jobs;
    settings.retry = options.retry;
    if (options.task >= 0) {
      settings.task = static_cast<std::size_t>(options.task);
      settings.tasks = static_cast<std::size_t>(options.tasks);
    }
    auto shown = begin;
    const Result<sweep::Progress> progress =
        sweep::RunSweep(spec, *plan, folder, settings, [&](const sweep::Progress& now) {
          if (std::chrono::steady_clock::now() - shown > std::chrono::milliseconds(300)) {
            shown = std::chrono::steady_clock::now();
            Show(now, is_terminal, begin);
          }
          return !WasInterrupted();
        });
    if (is_terminal) std::cerr << '\n';
    if (!progress) return Refuse(progress.error());
    for (const std::string& problem : progress->problems)
      std::cerr << Format(
          ProblemIn(options.spec, problem,
                    std::to_string(progress->left_out) + " runs were left out; the same command makes them later"));
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::cerr << progress->done << " runs made, " << progress->there_before << " were there, in "
              << mission::SecondsText(seconds) << '\n';
    if (options.task >= 0) return kOk;
  }
  std::vector<Diagnostic> differing;
  const std::vector<sweep::Row> rows = sweep::RowsOf(spec, *plan, folder, differing);
  for (const Diagnostic& problem : differing) std::cerr << Format(problem);
  const std::string manifest = sweep::ManifestOf(spec, *plan, rows, folder);
  if (const Result<void> written = sweep::WriteTables(folder, spec, *plan, rows, manifest); !written)
    return Refuse(written.error());
  const bool has_errors = std::ranges::any_of(rows, [](const sweep::Row& row) { return row.result.has_errors; });
  if (options.json) {
    std::cout << sweep::JsonLines(spec, *plan, rows)
              << JsonText(Json{{"event", "sweep"},
                               {"folder", folder.string()},
                               {"runs", rows.size()},
                               {"missing", planned - rows.size()},
                               {"has_errors", has_errors}})
              << '\n';
  } else {
    std::cout << sweep::Summary(spec, *plan, rows) << "tables: " << (folder / "results.csv").string() << ", "
              << (folder / "results.sqlite").string() << '\n';
  }
  if (WasInterrupted()) {
    std::cerr << planned - rows.size() << " runs are missing; run the same command again to continue\n";
    return 130;
  }
  if (rows.size() < planned) {
    std::cerr << planned - rows.size() << " of " << planned << " runs are missing\n";
    return kProblems;
  }
  return differing.empty() && !has_errors ? kOk : kProblems;
}

}  // namespace soarbox::app
