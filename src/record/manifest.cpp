// SPDX-License-Identifier: BSD-2-Clause
#include "record/manifest.h"

#include <sys/utsname.h>
#include <unistd.h>

#include <algorithm>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "record/sha256.h"

namespace soarbox::record {
namespace {

namespace fs = std::filesystem;
using OrderedJson = nlohmann::ordered_json;

Origin& OriginOfProgram() {
  static Origin origin;
  return origin;
}

/// Which program made the recording, when and where.
void AddProgram(const std::string& build, const std::string& folder, OrderedJson& made) {
  const Origin& origin = TheOrigin();
  made["program"] = "soarbox " + build.substr(0, build.find(' '));
  made["build"] = build;
  if (!origin.commit.empty()) made["commit"] = origin.commit;
  if (!origin.command.empty()) {
    made["command"] = origin.command;
    made["working_folder"] = folder;
    made["host"] = HostName();
    made["system"] = SystemText();
  }
  made["began"] = NowText();
}

/// The files in the recording: folder, name, and digest of the content.
void AddKeptFiles(const sim::Scenario& scenario, const Header& header, OrderedJson& digests) {
  for (const KeptFile& file : header.files) {
    const fs::path folder = file.folder == 0 ? fs::path() : scenario.Original(scenario.rule_folders[file.folder]);
    digests[(folder / file.name).generic_string()] = Sha256(file.content);
  }
}

/// The folders of scripts and rules that come with the program.
std::vector<fs::path> LibraryFolders(const sim::Scenario& scenario) {
  std::vector<fs::path> folders = scenario.script_folders;
  folders.insert(folders.end(), scenario.fallback_rule_folders.begin(), scenario.fallback_rule_folders.end());
  std::erase_if(folders, [&](const fs::path& folder) {
    return std::ranges::find(scenario.rule_folders, folder) != scenario.rule_folders.end();
  });
  return folders;
}

bool IsBelow(const fs::path& file, const fs::path& folder) {
  const fs::path inside = file.lexically_normal().lexically_relative(folder.lexically_normal());
  return !inside.empty() && *inside.begin() != "..";
}

/// Files that the scenario names and that are in other folders, or are too large to keep.
void AddFilesNamedIn(const sim::Scenario& scenario, OrderedJson& digests) {
  std::vector<fs::path> named = {scenario.script, scenario.definition, scenario.rules};
  for (const auto& [agent, file] : scenario.replaced_rules) named.push_back(file);
  const std::vector<fs::path> library = LibraryFolders(scenario);
  for (const fs::path& file : named) {
    if (std::ranges::any_of(library, [&](const fs::path& folder) { return IsBelow(file, folder); })) continue;
    const std::string name = scenario.Original(file).generic_string();
    const auto is_listed = [&](const auto& entry) { return name == entry.key() || name.ends_with("/" + entry.key()); };
    const auto entries = digests.items();
    if (!file.empty() && std::none_of(entries.begin(), entries.end(), is_listed)) digests[name] = Sha256OfFile(file);
  }
}

/// A digest of the names and contents of all scripts and rules in a folder of the program.
std::string DigestOfFolder(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string ending = it->path().extension().string();
    if ((ending == ".lua" || ending == ".soar") && it->is_regular_file(error)) files.push_back(it->path());
  }
  std::ranges::sort(files);
  std::string all;
  for (const fs::path& file : files)
    all += file.lexically_relative(folder).generic_string() + " " + Sha256OfFile(file) + "\n";
  return Sha256(all);
}

void AddLibrary(const sim::Scenario& scenario, OrderedJson& made) {
  for (const fs::path& folder : LibraryFolders(scenario)) {
    // The location of the installation is not significant.
    const fs::path normal = (folder / "").lexically_normal().parent_path();
    made["library_sha256"][(normal.parent_path().filename() / normal.filename()).generic_string()] =
        DigestOfFolder(folder);
  }
}

}  // namespace

void SetOrigin(Origin origin) {
  OriginOfProgram() = std::move(origin);
}

const Origin& TheOrigin() {
  return OriginOfProgram();
}

std::string HostName() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "host";
}

std::string SystemText() {
  utsname name{};
  if (uname(&name) != 0) return {};
  return std::string(name.sysname) + " " + name.release + " " + name.machine;
}

std::string NowText() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  char text[32] = "";
  if (gmtime_r(&now, &parts) != nullptr) std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

std::string ManifestOf(const sim::Scenario& scenario, const Header& header) {
  OrderedJson made = OrderedJson::object();
  AddProgram(header.build, header.folder, made);
  made["scenario"] = scenario.name;
  made["seed"] = header.seed;
  OrderedJson& digests = made["sha256"] = OrderedJson::object();
  AddKeptFiles(scenario, header, digests);
  AddFilesNamedIn(scenario, digests);
  AddLibrary(scenario, made);
  return made.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::string ManifestOfBranch(const std::string& manifest, const std::string& build) {
  OrderedJson made = OrderedJson::parse(manifest, nullptr, false);
  if (!made.is_object()) made = OrderedJson::object();
  for (const char* name : {"commit", "command", "working_folder", "host", "system"}) made.erase(name);
  std::error_code error;
  AddProgram(build, fs::current_path(error).string(), made);
  return made.dump(-1, ' ', false, OrderedJson::error_handler_t::replace);
}

std::string ManifestIn(const fs::path& recording) {
  constexpr std::uint32_t kMostBytes = 4u << 20;
  std::ifstream in(recording, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(kMagic.size()));
  // The manifest follows the header.
  for (std::string bytes(kFrameBytes, '\0'); in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));) {
    BlockFrame frame;
    if (!DecodeFrame(bytes, frame) || frame.kind == BlockKind::kTicks || frame.compressed_bytes > kMostCompressedBytes)
      break;
    if (frame.kind != kManifestBlock) {
      in.seekg(frame.compressed_bytes, std::ios::cur);
      continue;
    }
    std::string payload(frame.compressed_bytes, '\0'), manifest;
    const bool is_whole = static_cast<bool>(in.read(payload.data(), static_cast<std::streamsize>(payload.size())));
    if (!is_whole || frame.plain_bytes > kMostBytes || !DecodePayload(frame, payload, manifest)) break;
    return manifest;
  }
  return {};
}

std::vector<std::pair<std::string, std::string>> EntriesOf(const std::string& manifest) {
  std::vector<std::pair<std::string, std::string>> entries;
  const OrderedJson read = OrderedJson::parse(manifest, nullptr, false);
  if (!read.is_object()) return entries;
  for (const auto& [name, value] : read.items())
    entries.emplace_back(name, value.is_string() ? value.get<std::string>()
                                                 : value.dump(-1, ' ', false, OrderedJson::error_handler_t::replace));
  return entries;
}

}  // namespace soarbox::record
