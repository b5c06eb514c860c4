// SPDX-License-Identifier: BSD-2-Clause
#include "record/client_recording.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "record/client_ticks.h"
#include "record/header.h"
#include "record/manifest.h"
#include "record/recorder.h"
#include "record/writer.h"
#include "sim/client_world.h"
#include "sim/simulation.h"
#include "world/world.h"

namespace soarbox::record {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view kFirstWord = "soarbox-client\t";
/// Recordings of longer runs omit firings and elements, which use most of their space.
constexpr std::size_t kMostTicksInDetail = 20'000;

sim::DataFolders& TheDataFolders() {
  static sim::DataFolders data;
  return data;
}

using Files = std::map<std::string, std::string>;

/// The deepest folder that contains all files.
fs::path CommonFolder(const Files& files) {
  if (files.empty()) return {};
  fs::path common = fs::path(files.begin()->first).parent_path();
  for (const auto& [file, content] : files) {
    const fs::path folder = fs::path(file).parent_path();
    const auto [at, rest] = std::mismatch(common.begin(), common.end(), folder.begin(), folder.end());
    fs::path shared;
    for (auto part = common.begin(); part != at; ++part) shared /= *part;
    common = shared;
  }
  return common;
}

/// A folder that is removed with this object.
class Scratch {
 public:
  Scratch() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "soarbox-client-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~Scratch() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

Result<void> WriteFiles(const Files& files, const fs::path& common, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to, error);
  for (const auto& [file, content] : files) {
    const fs::path name = fs::path(file).lexically_normal().lexically_relative(common);
    if (name.empty() || *name.begin() == "..") continue;
    fs::create_directories((to / name).parent_path(), error);
    std::ofstream out(to / name, std::ios::binary);
    out << content;
    out.close();
    if (!out) return ProblemIn(to / name, std::string("this file cannot be written: ") + std::strerror(errno));
  }
  return {};
}

Result<sim::Scenario> FindWorld(const Files& files, const fs::path& common, const fs::path& copies) {
  std::vector<fs::path> extra;
  if (!common.empty()) extra.push_back(copies);
  Result<sim::Scenario> scenario = sim::FindScenario(sim::kClientWorld, TheDataFolders(), extra);
  if (!scenario || common.empty()) return scenario;
  scenario->stand_ins.emplace_back(copies, common);
  if (const Result<void> written = WriteFiles(files, common, copies); !written) return written.error();
  return scenario;
}

}  // namespace

void SetDataFolders(sim::DataFolders data) {
  TheDataFolders() = std::move(data);
}

bool IsClientLog(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  std::ifstream in(file, std::ios::binary);
  std::string begin(kFirstWord.size(), '\0');
  return in.read(begin.data(), static_cast<std::streamsize>(begin.size())) && begin == kFirstWord;
}

Result<void> RecordClientLog(const fs::path& log, const fs::path& recording) {
  const std::optional<std::string> text = ReadText(log);
  if (!text || !text->starts_with(kFirstWord)) return ProblemIn(log, "this is not a log of a client of Soar agents");
  Files files;
  ClientTicks ticks([&files](const std::string& path, const std::string& content) { files[path] = content; });
  // A line without an end was being written when the program was killed.
  for (std::size_t begin = text->find('\n') + 1, end = 0; (end = text->find('\n', begin)) != std::string::npos;
       begin = end + 1)
    ticks.Add(std::string_view(*text).substr(begin, end - begin));
  ticks.Flush();
  if (ticks.complete() == 0)
    return ProblemIn(log, "nothing is recorded: the program created no agent",
                     "start the recording before the first agent is created");

  const Scratch scratch;
  const fs::path common = CommonFolder(files);
  Result<sim::Scenario> scenario = FindWorld(files, common, scratch.path() / "files");
  if (!scenario) return scenario.error();
  const Level level = ticks.complete() <= kMostTicksInDetail ? Level::kAll : Level::kDecisions;
  sim::SimulationSettings settings;
  settings.mind_detail = DetailOf(level);
  settings.records_origins = false;
  settings.soar.threads = 1;
  Result<std::unique_ptr<sim::Simulation>> made = sim::Simulation::Create(*scenario, settings);
  if (!made) return made.error();
  sim::Simulation& simulation = **made;
  Header header = HeaderOf(*scenario, settings, static_cast<double>(simulation.world().settings().step_s), level);
  header.scenario = sim::kClientWorld;
  if (!common.empty()) header.extra_folders = {common.string()};
  WriterSettings writing;
  writing.manifest = ManifestOf(*scenario, header);
  Result<std::unique_ptr<Writer>> writer = Writer::Create(recording, header, writing);
  if (!writer) return writer.error();
  Recorder recorder(std::move(*writer), level);
  if (const Result<void> taken = recorder.Take(simulation, simulation.TakeEvents()); !taken) return taken;
  for (std::size_t tick = 0; tick < ticks.complete(); ++tick) {
    simulation.Submit(sim::CommandInput{"", ticks.At(tick)});
    simulation.Tick();
    if (const Result<void> taken = recorder.Take(simulation, simulation.TakeEvents()); !taken) return taken;
  }
  return recorder.Finish();
}

}  // namespace soarbox::record
