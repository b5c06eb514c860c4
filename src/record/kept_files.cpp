// SPDX-License-Identifier: BSD-2-Clause
#include "record/kept_files.h"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "record/header.h"
#include "world/asset_store.h"
#include "world/state_hash.h"

namespace soarbox::record {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t kMostFiles = 2000;
constexpr std::size_t kMostLookedAt = 20'000;  // The folder may be a home directory.
constexpr int kDeepest = 8;

bool IsScriptName(std::string_view name) {
  return name.ends_with(".lua") || name.ends_with(".soar") || name.ends_with(".toml");
}

/// The files below a folder that `is_wanted` accepts, in the order of their names. Does not follow links that lead out
/// of all folders of the run, because recordings are given to other people.
std::vector<fs::path> FilesBelow(const fs::path& folder, const std::vector<fs::path>& all_folders,
                                 bool (*is_wanted)(std::string_view name)) {
  std::vector<fs::path> files;
  std::error_code error;
  std::size_t looked_at = 0;
  for (fs::recursive_directory_iterator it(folder, fs::directory_options::skip_permission_denied, error), end;
       !error && it != end && ++looked_at <= kMostLookedAt; it.increment(error)) {
    if (it.depth() >= kDeepest) it.disable_recursion_pending();
    if (is_wanted(it->path().filename().string()) && IsPlainFileBelow(it->path(), all_folders))
      files.push_back(it->path());
  }
  std::sort(files.begin(), files.end());
  files.resize(std::min(files.size(), kMostFiles));
  return files;
}

Diagnostic CannotRestore(const std::string& why) {
  return NewProblem("the files that this run was made from cannot be restored: " + why);
}

/// A folder that is removed with its contents.
class PassingFolder {
 public:
  explicit PassingFolder(fs::path path) : path_(std::move(path)) {}
  ~PassingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  PassingFolder(const PassingFolder&) = delete;
  PassingFolder& operator=(const PassingFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Whether a relative path stays below its folder.
bool IsInside(const fs::path& name) {
  return !name.empty() && name.is_relative() && name.has_filename() &&
         std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".." || part == "."; });
}

Result<void> Restore(const KeptFile& kept, const fs::path& folder) {
  const fs::path name(kept.name);
  if (!IsInside(name)) return CannotRestore("it names a file outside of its folder, '" + kept.name + "'");
  std::error_code error;
  fs::create_directories((folder / name).parent_path(), error);
  std::ofstream out(folder / name, std::ios::binary);
  out << kept.content;
  out.close();
  if (!out) return CannotRestore((folder / name).string() + ": " + std::strerror(errno));
  return {};
}

/// The path relative to `from`, below `to`; unchanged if it is not below `from`.
fs::path Moved(const fs::path& path, const fs::path& from, const fs::path& to) {
  if (path.empty()) return path;
  const fs::path inside = path.lexically_normal().lexically_relative(from.lexically_normal());
  std::error_code error;
  return !inside.empty() && *inside.begin() != ".." && fs::exists(to / inside, error) ? to / inside : path;
}

}  // namespace

namespace {

void AddTo(world::StateHash& hash, std::uint32_t folder, std::string_view name, std::string_view content) {
  hash.Add(std::uint64_t{folder});
  hash.Add(name);
  hash.Add(content);
}

/// Files that the scenario names, in any folder.
void AddNamedFiles(const sim::Scenario& scenario, world::StateHash& hash) {
  for (const fs::path& file : {scenario.script, scenario.definition, scenario.rules})
    if (!file.empty()) hash.Add(std::string_view(ReadText(file).value_or("")));
}

}  // namespace

bool HaveChanged(const sim::Scenario& scenario, std::uint64_t digest_then, const std::vector<KeptFile>& then) {
  if (then.empty()) return ReadScenarioFiles(scenario).digest != digest_then;
  world::StateHash hash;
  for (const KeptFile& file : then) {
    if (file.folder >= scenario.rule_folders.size() || !IsInside(file.name)) return true;
    const std::optional<std::string> now = ReadText(scenario.rule_folders[file.folder] / file.name);
    if (!now) return true;
    AddTo(hash, file.folder, file.name, *now);
  }
  AddNamedFiles(scenario, hash);
  return hash.value() != digest_then;
}

ScenarioFiles ReadScenarioFiles(const sim::Scenario& scenario) {
  ScenarioFiles all;
  world::StateHash hash;
  std::uintmax_t bytes = 0;
  std::vector<fs::path> all_folders = scenario.script_folders;
  for (const auto* more : {&scenario.rule_folders, &scenario.fallback_rule_folders})
    all_folders.insert(all_folders.end(), more->begin(), more->end());
  for (std::uint32_t folder = 0; folder < scenario.rule_folders.size(); ++folder) {
    const fs::path& root = scenario.rule_folders[folder];
    for (const fs::path& file : FilesBelow(root, all_folders, IsScriptName)) {
      KeptFile kept{folder, file.lexically_relative(root).generic_string(), {}};
      std::error_code error;
      const std::uintmax_t size = fs::file_size(file, error);
      bytes += error ? 0 : size;
      // Files that are too large to keep are not read.
      kept.content = bytes <= kMostKeptBytes ? ReadText(file).value_or("") : std::to_string(size);
      AddTo(hash, folder, kept.name, kept.content);
      if (bytes <= kMostKeptBytes) all.files.push_back(std::move(kept));
    }
  }
  if (bytes > kMostKeptBytes) all.files.clear();
  // Images, models and sounds as far as there is room: without them a recording can be run again, but shows less.
  for (std::uint32_t folder = 0; folder < scenario.rule_folders.size() && bytes <= kMostKeptBytes; ++folder) {
    const fs::path& root = scenario.rule_folders[folder];
    for (const fs::path& file : FilesBelow(root, all_folders, world::IsAssetName)) {
      std::error_code error;
      const std::uintmax_t size = fs::file_size(file, error);
      if (error || size > world::kLargestAsset || bytes + size > kMostKeptBytes || all.files.size() >= kMostFiles)
        continue;
      KeptFile kept{folder, file.lexically_relative(root).generic_string(), ReadText(file).value_or("")};
      bytes += size;
      AddTo(hash, folder, kept.name, kept.content);
      all.files.push_back(std::move(kept));
    }
  }
  AddNamedFiles(scenario, hash);
  all.digest = hash.value();
  return all;
}

namespace {

/// Writes the files of each folder to a folder named by its number.
Result<std::shared_ptr<const PassingFolder>> RestoreAll(const std::vector<KeptFile>& files, std::size_t folders) {
  if (files.empty()) return CannotRestore("they were not kept");
  std::error_code error;
  std::string name = (fs::temp_directory_path(error) / "soarbox-run-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) return CannotRestore(name + ": " + std::strerror(errno));
  auto passing = std::make_shared<const PassingFolder>(name);
  for (std::size_t i = 0; i < folders; ++i) {
    const fs::path to = passing->path() / std::to_string(i);
    fs::create_directories(to, error);
    for (const KeptFile& file : files) {
      if (file.folder != i) continue;
      if (const Result<void> restored = Restore(file, to); !restored) return restored.error();
    }
  }
  return passing;
}

}  // namespace

std::vector<std::string> ReplaceRulesAsRecorded(sim::Scenario& scenario, const Header& header) {
  std::vector<std::string> missing;
  for (const auto& [name, file] : header.replaced_rules) {
    fs::path found = file;
    for (const auto& [copy, original] : scenario.stand_ins) found = Moved(found, original, copy);
    if (IsPlainFileBelow(found, scenario.rule_folders)) {
      scenario.replaced_rules.emplace_back(name, found);
    } else {
      missing.push_back(name);
    }
  }
  return missing;
}

Result<RestoredFolders> RestoreExtraFolders(const Header& header) {
  const Result<std::shared_ptr<const PassingFolder>> restored =
      RestoreAll(header.files, header.extra_folders.size() + 1);
  if (!restored) return restored.error();
  RestoredFolders made;
  made.keeps = *restored;
  for (std::size_t i = 0; i < header.extra_folders.size(); ++i)
    made.folders.emplace_back((*restored)->path() / std::to_string(i + 1), header.extra_folders[i]);
  return made;
}

Result<sim::Scenario> ScenarioFromKeptFiles(const Header& header, const sim::DataFolders& data) {
  const Result<std::shared_ptr<const PassingFolder>> restored =
      RestoreAll(header.files, header.extra_folders.size() + 1);
  if (!restored) return restored.error();
  const fs::path& folder = (*restored)->path();
  const fs::path own = folder / "0", then = fs::path(header.folder) / header.scenario;
  std::vector<fs::path> extra;
  for (std::size_t i = 1; i <= header.extra_folders.size(); ++i) extra.push_back(folder / std::to_string(i));
  // The name was that of a file, possibly without its extension, or of a folder. The digest identifies it, unless files
  // that come with the program have changed.
  const std::string last = (then.has_filename() ? then : then.parent_path()).filename().string();
  Result<sim::Scenario> best = CannotRestore("no scenario is among them");
  for (const bool is_file : {true, false}) {
    Result<sim::Scenario> found = sim::FindScenario((is_file ? own / last : own).string(), data, extra);
    if (!found) continue;
    const fs::path original = is_file ? then.parent_path() : then;
    found->name = original.filename().string() + (is_file ? "/" + fs::path(last).stem().string() : "");
    found->keeps = *restored;
    found->stand_ins.emplace_back(own, original);
    for (std::size_t i = 0; i < extra.size(); ++i) found->stand_ins.emplace_back(extra[i], header.extra_folders[i]);
    ReplaceRulesAsRecorded(*found, header);
    if (!HaveChanged(*found, header.scenario_digest, header.files)) return found;
    if (!best) best = std::move(found);
  }
  return best;
}

Result<sim::Scenario> WithKeptFiles(const sim::Scenario& scenario, const std::vector<KeptFile>& files) {
  const Result<std::shared_ptr<const PassingFolder>> restored = RestoreAll(files, scenario.rule_folders.size());
  if (!restored) return restored.error();
  const fs::path& folder = (*restored)->path();
  sim::Scenario kept = scenario;
  kept.keeps = *restored;
  for (std::size_t i = 0; i < scenario.rule_folders.size(); ++i) {
    const fs::path from = scenario.rule_folders[i], to = folder / std::to_string(i);
    for (auto* folders : {&kept.script_folders, &kept.rule_folders})
      std::replace(folders->begin(), folders->end(), from, to);
    for (fs::path* file : {&kept.script, &kept.definition, &kept.rules}) *file = Moved(*file, from, to);
    for (auto& [agent, file] : kept.replaced_rules) file = Moved(file, from, to);
    kept.stand_ins.emplace_back(to, scenario.Original(from));
  }
  return kept;
}

}  // namespace soarbox::record
