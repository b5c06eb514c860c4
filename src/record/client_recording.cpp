// SPDX-License-Identifier: BSD-2-Clause
#include "record/client_recording.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "diagnostics/number_from_chars.h"
#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
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
/// Recordings of longer runs leave out firings and elements, which take most of their room.
constexpr std::size_t kMostTicksInDetail = 20'000;

sim::DataFolders& TheDataFolders() {
  static sim::DataFolders data;
  return data;
}

/// Phases as the log numbers them. A decision is made when the apply phase comes next.
constexpr std::uint64_t kApply = 3;

/// How often an agent has decided when it is there.
std::uint64_t DecisionsAt(std::uint64_t cycles, std::uint64_t phase) {
  return cycles + (phase >= kApply ? 1 : 0);
}

std::uint64_t CountIn(const std::string& text) {
  std::uint64_t number = 0;
  (void)NumberFromChars(text, number);
  return number;
}

/// Deals the lines of a log out to ticks, so that no agent decides twice in one. A tick begins with what the client did
/// since the decisions of the previous one.
class TickPlan {
 public:
  void Add(std::string_view line) {
    const std::vector<std::string> parts = sim::PartsOfClientLine(line);
    const std::string& kind = parts.front();
    if (parts.size() < 2) return;
    if (kind == "file") {
      if (parts.size() > 2) files_[parts[1]] = parts[2];
    } else if (kind == "function") {
      functions_.push_back(parts[1]);
      for (const auto& [agent, decisions] : decided_) TellFunction(agent, parts[1]);
    } else if (kind == "go") {
      if (parts.size() > 5) Go(line, parts);
    } else {
      Put(line);
      if (kind == "gone") decided_.erase(parts[1]);
      if (kind != "agent") return;
      decided_[parts[1]] = 0;
      for (const std::string& function : functions_) TellFunction(parts[1], function);
    }
  }
  /// After the last line.
  void End() {
    if (!before_next_.empty()) ticks_.push_back(std::move(before_next_));
  }

  const std::vector<std::string>& ticks() const { return ticks_; }
  const std::map<std::string, std::string>& files() const { return files_; }

 private:
  /// What follows a decision belongs to the next one.
  void Put(std::string_view line) { (in_this_tick_.empty() ? ticks_.back() : before_next_).append(line).append("\n"); }
  void PutDecision(const std::string& agent, std::string_view line) {
    const bool is_next = !in_this_tick_.insert(agent).second;
    if (is_next) {
      ticks_.emplace_back();
      in_this_tick_ = {agent};
    }
    ticks_.back().append(std::exchange(before_next_, {})).append(line).append("\n");
  }

  /// Agents may be in kernels of their own.
  void TellFunction(const std::string& agent, const std::string& function) {
    Put(sim::ClientLine({"function", agent, function}));
  }

  void Go(std::string_view line, const std::vector<std::string>& parts) {
    const std::string& agent = parts[1];
    const std::uint64_t goal = DecisionsAt(CountIn(parts[2]), CountIn(parts[3]));
    std::uint64_t& decided = decided_[agent];
    if (goal < decided) decided = goal;  // init-soar.
    // Each decision but the last ends a tick.
    for (; decided + 1 < goal; ++decided)
      PutDecision(agent,
                  sim::ClientLine({"go", agent, std::to_string(decided), std::to_string(kApply), "0", "-", "0"}));
    if (decided == goal) return Put(line);
    ++decided;
    PutDecision(agent, line);
  }

  std::vector<std::string> ticks_ = {{}};
  std::set<std::string> in_this_tick_;  ///< Agents that have decided.
  std::string before_next_;             ///< Lines for the tick of the next decision.
  std::map<std::string, std::uint64_t> decided_;
  std::map<std::string, std::string> files_;
  std::vector<std::string> functions_;
};

/// The folder that all files lie below.
fs::path CommonFolder(const std::map<std::string, std::string>& files) {
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

/// A folder that goes with this object.
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

Result<void> WriteFiles(const std::map<std::string, std::string>& files, const fs::path& common, const fs::path& to) {
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

Result<sim::Scenario> FindWorld(const TickPlan& plan, const fs::path& common, const fs::path& copies) {
  std::vector<fs::path> extra;
  if (!common.empty()) extra.push_back(copies);
  Result<sim::Scenario> scenario = sim::FindScenario(sim::kClientWorld, TheDataFolders(), extra);
  if (!scenario || common.empty()) return scenario;
  scenario->stand_ins.emplace_back(copies, common);
  if (const Result<void> written = WriteFiles(plan.files(), common, copies); !written) return written.error();
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
  if (!text || !text->starts_with(kFirstWord)) return ProblemIn(log, "this is no log of a client of Soar agents");
  TickPlan plan;
  // A line without an end was being written when the program was killed.
  for (std::size_t begin = text->find('\n') + 1, end = 0; (end = text->find('\n', begin)) != std::string::npos;
       begin = end + 1)
    plan.Add(std::string_view(*text).substr(begin, end - begin));
  plan.End();
  if (plan.ticks().front().empty())
    return ProblemIn(log, "nothing is recorded: the program created no agent",
                     "start the recording before the first agent is created");

  const Scratch scratch;
  const fs::path common = CommonFolder(plan.files());
  Result<sim::Scenario> scenario = FindWorld(plan, common, scratch.path() / "files");
  if (!scenario) return scenario.error();
  const Level level = plan.ticks().size() <= kMostTicksInDetail ? Level::kAll : Level::kDecisions;
  sim::SimulationSettings settings;
  settings.mind_detail = DetailOf(level);
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
  for (const std::string& acts : plan.ticks()) {
    simulation.Submit(sim::CommandInput{"", acts});
    simulation.Tick();
    if (const Result<void> taken = recorder.Take(simulation, simulation.TakeEvents()); !taken) return taken;
  }
  return recorder.Finish();
}

}  // namespace soarbox::record
