// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/sweep_manifest.h"

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "diagnostics/problem.h"
#include "diagnostics/read_text.h"
#include "record/header.h"
#include "record/manifest.h"
#include "record/sha256.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

constexpr const char* kName = "manifest.json";

/// The SHA-256 of each file below the folder, by its relative path.
OrderedJson FilesBelow(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->is_regular_file(error) && !it->is_symlink(error)) files.push_back(it->path());
  std::ranges::sort(files);
  OrderedJson made = OrderedJson::object();
  for (const fs::path& file : files) made[fs::relative(file, folder, error).string()] = record::Sha256OfFile(file);
  return made;
}

OrderedJson VariantOf(const ReadyVariant& ready, const fs::path& folder) {
  const Variant& variant = ready.variant;
  OrderedJson made{{"name", variant.name}, {"digest", ready.digest}, {"seconds", ready.loaded.seconds}};
  if (!variant.kernel.empty()) made["kernel"] = variant.kernel;
  if (!variant.setup.empty()) made["setup"] = variant.setup;
  OrderedJson parameters = OrderedJson::object(), rules = OrderedJson::object();
  for (const auto& [name, value] : variant.parameters) parameters[name] = value;
  for (const auto& [agent, file] : variant.rules) rules[agent] = fs::path(file).filename().string();
  if (!parameters.empty()) made["parameters"] = std::move(parameters);
  if (!rules.empty()) made["rules"] = std::move(rules);
  made["sha256"] = FilesBelow(folder / "variants" / variant.name);
  return made;
}

}  // namespace

std::string ManifestOf(const Spec& spec, const Plan& plan, const std::vector<Row>& rows, const fs::path& folder) {
  std::error_code error;
  std::set<std::string> hosts, builds;
  for (const Row& row : rows) {
    hosts.insert(row.host);
    builds.insert(row.build);
  }
  const std::string build = record::BuildId(), &commit = record::TheOrigin().commit;
  OrderedJson made{{"program", "soarbox " + build.substr(0, build.find(' '))}, {"build", build}};
  if (!commit.empty()) made["commit"] = commit;
  made["command"] = record::TheOrigin().command;
  made["working_folder"] = fs::current_path(error).string();
  made["host"] = record::HostName();
  made["system"] = record::SystemText();
  made["written"] = record::NowText();
  made["sweep"] = spec.file.string();
  made["sweep_sha256"] = record::Sha256OfFile(spec.file);
  made["runs"] = rows.size();
  made["seeds"] = spec.mission.seeds;
  made["hosts_of_runs"] = hosts;
  made["builds_of_runs"] = builds;
  OrderedJson& variants = made["variants"] = OrderedJson::array();
  for (const ReadyVariant& variant : plan.variants) variants.push_back(VariantOf(variant, folder));
  return made.dump(1, ' ', false, OrderedJson::error_handler_t::replace) + "\n";
}

std::string ReadManifest(const fs::path& folder) {
  return ReadText(folder / kName).value_or("");
}

Result<void> WriteManifest(const fs::path& folder, const std::string& manifest) {
  const fs::path file = folder / kName, making = folder / (std::string(".") + kName);
  std::error_code error;
  const bool is_written = static_cast<bool>((std::ofstream(making, std::ios::binary) << manifest).flush());
  if (is_written) fs::rename(making, file, error);
  if (is_written && !error) return {};
  return ProblemIn(file.string(), "this file cannot be written: " + (error ? error.message() : "is the disk full?"),
                   "the rows are safe in the folder parts: run the same command again when there is room");
}

}  // namespace soarbox::sweep
