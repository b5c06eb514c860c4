// SPDX-License-Identifier: BSD-2-Clause
// Lists what can be opened, and searches everywhere for a text.
#include <algorithm>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "debugger/memory.h"
#include "workbench/desk.h"

namespace soarbox::workbench {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostOfKind = 12, kShortest = 2;

bool HasPart(std::string_view text, std::string_view part) {
  const auto same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

/// Adds the contents of the folder of a path that is being typed, or of the working directory.
void AddFolder(const std::string& typed, std::vector<ScenarioOffer>& offers) {
  constexpr std::size_t kMost = 200;
  const std::size_t slash = typed.rfind('/');
  const fs::path folder = slash == std::string::npos ? fs::path(".") : fs::path(typed.substr(0, slash + 1));
  std::error_code error;
  std::vector<std::string> names;
  for (fs::directory_iterator at(folder, error), end; !error && at != end && names.size() < kMost;
       at.increment(error)) {
    const fs::path& path = at->path();
    const std::string extension = path.extension().string();
    const bool is_world = fs::exists(path / "scenario.toml", error) || fs::exists(path / "Sandbox.lua", error);
    const bool is_file = extension == ".soarrec" || extension == ".soar" || extension == ".toml" || extension == ".lua";
    error.clear();
    const bool is_folder = at->is_directory(error) && slash != std::string::npos;
    error.clear();
    if (!is_world && !is_file && !is_folder) continue;
    std::string name = slash == std::string::npos ? path.filename().string() : path.string();
    if (is_folder && !is_world) name += "/";
    names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  for (std::string& name : names) offers.push_back({std::move(name), "here"});
}

void FindInFile(const std::string& file, std::string_view text, bool is_rules, std::vector<FoundPlace>& places,
                std::size_t& count) {
  std::ifstream in(file);
  int number = 0;
  for (std::string line; std::getline(in, line) && count < kMostOfKind;) {
    ++number;
    if (!HasPart(line, text)) continue;
    ++count;
    FoundPlace place;
    place.kind = is_rules ? FoundPlace::Kind::kRule : FoundPlace::Kind::kFile;
    place.title = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    place.detail = fs::path(file).filename().string() + ":" + std::to_string(number);
    place.file = file;
    place.line = number;
    places.push_back(std::move(place));
  }
}

}  // namespace

void Desk::FillOffers(Contents& contents, explain::Inspector* mind) {
  constexpr auto kEvery = std::chrono::seconds(2);
  if (Clock::now() - read_recent_ > kEvery) {
    read_recent_ = Clock::now();
    contents.recent = surroundings_.RecentRuns();
  }
  contents.searched = searched_;
  contents.places.clear();
  contents.scenarios.clear();
  contents.all_files.clear();
  if (!offers_) return;
  contents.scenarios = surroundings_.Scenarios();
  if (surroundings_.MayBrowse()) AddFolder(searched_, contents.scenarios);
  std::vector<sim::WatchedFile> files;
  if (common_.Live() != nullptr) files = debugger::FilesOf(*common_.Live(), {});
  for (const sim::WatchedFile& file : files) contents.all_files.push_back(file.file.string());
  if (mind != nullptr && !visible_.Has(PanelId::kRules)) contents.rules = debugger::ListRules(*mind);
  if (searched_.size() < kShortest) return;

  std::size_t in_rules = 0, in_scripts = 0;
  for (const sim::WatchedFile& file : files)
    FindInFile(file.file.string(), searched_, file.is_rules, contents.places, file.is_rules ? in_rules : in_scripts);
  if (mind != nullptr) {
    for (const explain::ElementFact& element : debugger::SearchMemory(*mind, searched_, kMostOfKind)) {
      FoundPlace place;
      place.kind = FoundPlace::Kind::kMemory;
      place.title = "(" + element.id + " ^" + element.attribute + " " + element.value + ")";
      place.detail = agent_;
      place.agent = agent_;
      place.id = element.id;
      contents.places.push_back(std::move(place));
    }
  }
  const auto time = [&](std::uint64_t tick) {
    char text[32];
    std::snprintf(text, sizeof text, "%.2f s", static_cast<double>(tick) * contents.moment.step_s);
    return std::string(text);
  };
  std::size_t in_trace = 0;
  const auto& lines = models_.trace.lines();
  for (auto line = lines.rbegin(); line != lines.rend() && in_trace < kMostOfKind; ++line) {
    if (!HasPart(line->text, searched_)) continue;
    ++in_trace;
    FoundPlace place;
    place.kind = FoundPlace::Kind::kTrace;
    place.title = line->text;
    place.detail = line->agent + " " + time(line->tick);
    place.tick = line->tick;
    contents.places.push_back(std::move(place));
  }
}

}  // namespace soarbox::workbench
