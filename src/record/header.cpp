// SPDX-License-Identifier: BSD-2-Clause
#include "record/header.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "bytes/byte_stream.h"
#include "diagnostics/problem.h"
#include "record/linkers_id.h"

namespace soarbox::record {
namespace fs = std::filesystem;
namespace {

/// Bits of the byte about the minds' kernels.
constexpr std::uint8_t kOwnKernel = 1, kHasOrigins = 2;

constexpr std::array<std::string_view, 3> kLevels = {"world", "decisions", "all"};

std::string& TheBuildId() {
  static std::string id = std::string(SOARBOX_VERSION) + " " + LinkersId();
  return id;
}

}  // namespace

Header HeaderOf(const sim::Scenario& scenario, const sim::SimulationSettings& settings, double step_s, Level level) {
  std::error_code error;
  Header header;
  header.build = BuildId();
  header.scenario = scenario.name;
  header.folder = fs::current_path(error).string();
  ScenarioFiles files = ReadScenarioFiles(scenario);
  header.scenario_digest = files.digest;
  header.files = std::move(files.files);
  header.seed = settings.seed;
  header.screen_width_px = static_cast<std::uint32_t>(settings.screen_width_px);
  header.screen_height_px = static_cast<std::uint32_t>(settings.screen_height_px);
  header.step_s = step_s;
  header.level = level;
  header.own_kernel = settings.soar.remote_host.empty();
  header.has_origins = settings.records_origins;
  for (const auto& [name, file] : scenario.replaced_rules)
    header.replaced_rules.emplace_back(name, scenario.Original(file).string());
  header.memory_mb = settings.limits.memory_bytes >> 20;
  return header;
}

std::string EncodeHeader(const Header& header) {
  std::string bytes;
  ByteWriter out(bytes);
  for (const std::string* text : {&header.build, &header.scenario, &header.folder}) out.Text(*text);
  out.Number(header.extra_folders.size());
  for (const std::string& folder : header.extra_folders) out.Text(folder);
  out.Fixed64(header.scenario_digest);
  out.Number(header.seed);
  out.Number(header.screen_width_px);
  out.Number(header.screen_height_px);
  out.Double(header.step_s);
  out.Byte(static_cast<std::uint8_t>(header.level));
  out.Byte(static_cast<std::uint8_t>((header.own_kernel ? kOwnKernel : 0) | (header.has_origins ? kHasOrigins : 0)));
  out.Text(header.branched_from);
  out.Number(header.branch_tick);
  out.Number(header.files.size());
  for (const KeptFile& file : header.files) {
    out.Number(file.folder);
    out.Text(file.name);
    out.Text(file.content);
  }
  out.Number(header.memory_mb);
  out.Number(header.replaced_rules.size());
  for (const auto& [name, file] : header.replaced_rules) {
    out.Text(name);
    out.Text(file);
  }
  return bytes;
}

Result<Header> DecodeHeader(std::string_view bytes) {
  Header header;
  ByteReader in(bytes);
  for (std::string* text : {&header.build, &header.scenario, &header.folder}) *text = in.Text();
  constexpr std::size_t kMostFolders = 1'000;  // Far more than users specify.
  const std::size_t folders = in.Count();
  if (folders > kMostFolders) in.Fail();
  header.extra_folders.resize(in.failed() ? 0 : folders);
  for (std::string& folder : header.extra_folders) folder = in.Text();
  header.scenario_digest = in.Fixed64();
  header.seed = in.Number();
  const std::uint64_t width = in.Number();
  const std::uint64_t height = in.Number();
  header.step_s = in.Double();
  const std::uint8_t level = in.Byte();
  const std::uint8_t minds = in.Byte();
  header.own_kernel = (minds & kOwnKernel) != 0;
  header.has_origins = (minds & kHasOrigins) != 0;
  header.branched_from = in.Text();
  header.branch_tick = in.Number();
  constexpr std::size_t kMostFiles = 100'000;  // Far more than are ever kept.
  const std::size_t files = in.Count(3);
  if (files > kMostFiles) in.Fail();
  header.files.resize(in.failed() ? 0 : files);
  for (KeptFile& file : header.files) {
    file.folder = static_cast<std::uint32_t>(std::min<std::uint64_t>(in.Number(), 0xffffffff));
    file.name = in.Text();
    file.content = in.Text();
  }
  header.memory_mb = in.Number();
  constexpr std::size_t kMostReplaced = 10'000;  // One per agent.
  const std::size_t replaced = in.Count(2);
  if (replaced > kMostReplaced) in.Fail();
  header.replaced_rules.resize(in.failed() ? 0 : replaced);
  for (auto& [name, file] : header.replaced_rules) {
    name = in.Text();
    file = in.Text();
  }
  const bool sensible = width > 0 && width <= 65535 && height > 0 && height <= 65535 && header.step_s > 0 &&
                        header.step_s <= 10 && level < kLevels.size();
  if (in.failed() || !sensible) {
    return NewProblem("the recording's header is damaged");
  }
  header.screen_width_px = static_cast<std::uint32_t>(width);
  header.screen_height_px = static_cast<std::uint32_t>(height);
  header.level = static_cast<Level>(level);
  return header;
}

std::string BuildId() {
  return TheBuildId();
}

void SetBuildId(std::string id) {
  TheBuildId() = std::move(id);
}

std::string_view NameOf(Level level) {
  return kLevels[static_cast<std::size_t>(level)];
}

Result<Level> LevelNamed(std::string_view name) {
  const auto at = std::find(kLevels.begin(), kLevels.end(), name);
  if (at != kLevels.end()) return static_cast<Level>(at - kLevels.begin());
  return NewProblem("'" + std::string(name) + "' is not a level of recording",
                    "the levels are world, decisions and all");
}

}  // namespace soarbox::record
