// SPDX-License-Identifier: BSD-2-Clause
#include "app/record_run.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/refuse.h"
#include "mission/testing.h"
#include "record/recorder.h"
#include "world/world.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

constexpr double kUsualLimitMb = 256;

/// Number of automatic recordings that are kept, including the new one.
constexpr std::size_t kUsualFilesKept = 5;

/// $XDG_STATE_HOME/soarbox/recordings, by default below ~/.local/state; empty without a home.
fs::path UsualFolder() {
  const fs::path folder = mission::StateFolder("recordings");
  if (folder.empty()) return {};
  std::error_code error;
  fs::create_directories(folder, error);
  return error ? fs::path{} : folder;
}

/// The number in "run-0012.soarrec", and in "run-0012-2.soarrec", which continues that run from an earlier tick; else
/// 0.
unsigned NumberOf(const fs::path& file) {
  const std::string name = file.filename().string();
  constexpr std::string_view kBefore = "run-", kAfter = ".soarrec";
  if (!name.starts_with(kBefore) || !name.ends_with(kAfter) || name.size() <= kBefore.size() + kAfter.size()) return 0;
  unsigned number = 0;
  const char* const end = name.data() + name.size() - kAfter.size();
  const auto [at, error] = std::from_chars(name.data() + kBefore.size(), end, number);
  const bool is_ours =
      at == end || (*at == '-' && std::all_of(at, end, [](char c) { return c == '-' || (c >= '0' && c <= '9'); }));
  return error == std::errc{} && is_ours ? number : 0;
}

/// Returns a new file for a run without a given file, with the next number. Removes the oldest files, with their
/// continuations. Empty if there can be no file.
fs::path UsualFile() {
  const fs::path folder = UsualFolder();
  if (folder.empty()) return {};
  std::map<unsigned, std::vector<fs::path>> there;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (const unsigned number = NumberOf(it->path()); number != 0) there[number].push_back(it->path());
  for (; there.size() >= kUsualFilesKept; there.erase(there.begin()))
    for (const fs::path& file : there.begin()->second) fs::remove(file, error);
  unsigned number = there.empty() ? 1 : there.rbegin()->first + 1;
  // Creates the file, because another program may use the same number at the same time.
  for (const unsigned last = number + 100; number < last; ++number) {
    char name[32];
    std::snprintf(name, sizeof name, "run-%04u.soarrec", number);
    const int file = open((folder / name).c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0 && errno == EEXIST) continue;
    if (file >= 0) close(file);
    return folder / name;  // If it cannot be written, opening it reports why.
  }
  return {};
}

}  // namespace

bool WantsRecording(const RunOptions& options) {
  if (!options.record.empty()) return true;
  return !options.no_record && !options.headless && options.screenshot.empty();
}

fs::path NextRecording(const fs::path& file) {
  for (unsigned number = 2;; ++number) {
    fs::path next = file;
    next.replace_filename(file.stem().string() + "-" + std::to_string(number) + file.extension().string());
    std::error_code error;
    if (!fs::exists(next, error)) return next;
  }
}

record::Header HeaderOfRun(const RunOptions& options, const sim::Scenario& scenario,
                           const sim::SimulationSettings& settings, const sim::Simulation& simulation,
                           record::Level level) {
  record::Header header =
      record::HeaderOf(scenario, settings, static_cast<double>(simulation.world().settings().step_s), level);
  header.scenario = options.scenario;
  for (const fs::path& folder : options.extra_folders) header.extra_folders.push_back(folder.string());
  // --rules adds folders, too.
  for (std::size_t i = options.extra_folders.size() + 1; i < scenario.rule_folders.size(); ++i)
    header.extra_folders.push_back(scenario.rule_folders[i].string());
  return header;
}

std::string RunRecordings::Begin(RunSession& session, const record::Header& header) {
  const bool is_first = file_.empty();
  fs::path file = options_.record.empty() ? UsualFile() : options_.record;
  if (!is_first && !options_.record.empty()) file = NextRecording(file);
  return Write(session, file, header, nullptr, {});
}

std::string RunRecordings::GoOn(RunSession& session, const record::Header& header, record::TickRecord at,
                                std::vector<record::TickInputs> inputs) {
  if (file_.empty()) return {};
  record::Header branch = header;
  std::error_code error;
  branch.branched_from = fs::absolute(file_, error).string();
  branch.branch_tick = at.tick;
  record::KeepLevel(at, header.level);
  std::erase_if(inputs, [&](const record::TickInputs& entry) { return entry.tick >= at.tick; });
  return Write(session, NextRecording(file_), branch, &at, inputs);
}

std::string RunRecordings::Write(RunSession& session, const fs::path& file, const record::Header& header,
                                 const record::TickRecord* at, const std::vector<record::TickInputs>& inputs) {
  if (file.empty()) return {};
  const bool is_usual = options_.record.empty();
  record::WriterSettings writing;
  const double limit_mb = options_.record_limit_mb.value_or(is_usual ? kUsualLimitMb : 0);
  writing.limit_bytes = static_cast<std::uint64_t>(limit_mb * 1e6);
  writing.manifest = manifest_;
  const auto fail = [&](Diagnostic problem) -> std::string {
    if (is_usual || at != nullptr) {
      Remark(Severity::kWarning, std::move(problem));
    } else {
      problem.severity = Severity::kError;
      Refuse(problem);
    }
    return {};
  };
  Result<std::unique_ptr<record::Writer>> writer = record::Writer::Create(file, header, writing);
  if (!writer) return fail(writer.error());
  if (const Result<void> added = (*writer)->AddEarlierInputs(inputs); !added) return fail(added.error());
  auto recorder = std::make_unique<record::Recorder>(std::move(*writer), header.level);
  if (at != nullptr) {
    if (const Result<void> taken = recorder->Take(*at); !taken) return fail(taken.error());
  }
  session.Record(std::move(recorder), at == nullptr);
  file_ = file;
  return "recording to " + file.string();
}

}  // namespace soarbox::app
