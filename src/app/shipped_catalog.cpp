// SPDX-License-Identifier: BSD-2-Clause
#include "app/shipped_catalog.h"

#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/lesson.h"
#include "app/lesson_progress.h"
#include "record/reader.h"

namespace soarbox::app {
namespace {

/// The scenario of a match on a board of the game.
std::string MatchOf(const std::string& script, const std::vector<serve::Player>& players) {
  std::string text = "# A match that `soarbox serve` has made.\ndescription = \"" + script + ": ";
  for (std::size_t i = 0; i < players.size(); ++i) text += (i == 0 ? "" : " against ") + players[i].name;
  text += "\"\nscript = \"" + script + ".lua\"\nturn = 10\n";
  for (const serve::Player& player : players)
    text += "\n[[agent]]\nname = " + nlohmann::json(player.name).dump() +
            "\nrules = " + nlohmann::json(player.rules).dump() + "\nby = \"sandbox\"\n";
  return text;
}

}  // namespace

ShippedCatalog::ShippedCatalog(const sim::DataFolders& data) {
  std::vector<Diagnostic> problems;
  const auto add = [&](const std::filesystem::path& folder, const std::string& course) {
    for (const Lesson& lesson : ReadLessons(folder, data, problems)) {
      if (!course.empty() && hints_.contains(lesson.name)) continue;  // A course may contain lessons of other courses.
      lessons_.push_back({lesson.name, lesson.title, course});
      hints_[lesson.name] = lesson.hints;
    }
  };
  add(ShippedLessons(data), {});
  for (const std::string& course : CoursesIn(ShippedLessons(data))) add(ShippedLessons(data) / course, course);
  for (const Diagnostic& problem : problems) std::cerr << Format(problem);
  for (const std::string& name : sim::ListScenarios(data))
    scenarios_.push_back({name, sim::DescribeScenario(name, data)});
}

std::vector<serve::Game> ShippedCatalog::Games() const {
  constexpr int kEaters_s = 120, kTanks_s = 200;
  return {{"eaters", "Eaters", kEaters_s, [](const auto& players) { return MatchOf("Eaters", players); }},
          {"tanksoar", "TankSoar", kTanks_s, [](const auto& players) { return MatchOf("TankSoar", players); }}};
}

serve::Catalog::Recording ShippedCatalog::Describe(const std::filesystem::path& recording) const {
  const Result<std::unique_ptr<record::Reader>> reader = record::Reader::Open(recording);
  if (!reader) return {};
  const record::Header& header = (*reader)->header();
  return {std::filesystem::path(header.scenario).filename().string(),
          static_cast<double>((*reader)->last_tick() - (*reader)->first_tick()) * header.step_s};
}

serve::Progress ShippedCatalog::ProgressOf(const std::filesystem::path& state, const std::string& lesson) const {
  const LessonProgress progress = LessonProgress::Below(state);
  serve::Progress told{progress.IsPassed(lesson), progress.Get(lesson, "attempts"), progress.Get(lesson, "hints")};
  const auto hints = hints_.find(lesson);
  if (told.hints > 0 && hints != hints_.end() && !hints->second.empty())
    told.last_hint =
        hints->second[std::min<std::size_t>(static_cast<std::size_t>(told.hints), hints->second.size()) - 1];
  return told;
}

bool IsPlainName(std::string_view name) {
  return !name.empty() && name.size() <= 100 && name.front() != '.' && std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
}

}  // namespace soarbox::app
