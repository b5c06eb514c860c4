// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/palette.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "looks_json.h"

namespace soarbox::viewer {
namespace {

using Paint = Look::Paint;
using world::Color;

constexpr std::pair<std::string_view, Paint> kPaints[] = {
    {"plain", Paint::kPlain}, {"ground", Paint::kGround},   {"concrete", Paint::kConcrete},
    {"brick", Paint::kBrick}, {"crate", Paint::kCrate},     {"leaves", Paint::kLeaves},
    {"stone", Paint::kStone}, {"missing", Paint::kMissing}, {"corners", Paint::kCorners}};

Color ColorOf(const nlohmann::json& channels) {
  const auto at = [&](std::size_t i) { return channels.at(i).get<float>(); };
  return {at(0), at(1), at(2), at(3)};
}

/// A colour of kinds or teams whose names contain a word; with "=" before it, of the one with this name.
using WordColor = std::pair<std::string, Color>;

/// The tables of looks.json, which pages read, too.
struct Tables {
  std::map<std::string, Look, std::less<>> looks;
  std::vector<WordColor> kinds, teams;
  std::vector<Color> others;          ///< Of other kinds.
  std::vector<std::string> textures;  ///< Materials that give a body no colour.
};

const Tables& Read() {
  static const Tables tables = [] {
    const nlohmann::json json = nlohmann::json::parse(kLooksJson);
    Tables read;
    for (const nlohmann::json& row : json.at("looks")) {
      const auto number = [&](std::size_t i) { return row.at(i).get<float>(); };
      const auto paint =
          std::ranges::find(kPaints, row.at(5).get<std::string>(), &std::pair<std::string_view, Paint>::first);
      read.looks[row.at(0).get<std::string>()] = {ColorOf(row.at(1)), ColorOf(row.at(2)), number(3),
                                                  number(4),          paint->second,      number(6)};
    }
    for (const auto& [name, colors] : {std::pair{"kinds", &read.kinds}, {"teams", &read.teams}})
      for (const nlohmann::json& row : json.at(name))
        colors->emplace_back(row.at(0).get<std::string>(), ColorOf(row.at(1)));
    for (const nlohmann::json& color : json.at("others")) read.others.push_back(ColorOf(color));
    json.at("textures").get_to(read.textures);
    return read;
  }();
  return tables;
}

/// The colour of the first word that a name contains; null if there is none.
const Color* FindColor(const std::vector<WordColor>& colors, std::string_view name) {
  const auto fits = [name](const WordColor& one) {
    return one.first.starts_with('=') ? one.first.substr(1) == name : name.find(one.first) != std::string_view::npos;
  };
  const auto found = std::ranges::find_if(colors, fits);
  return found == colors.end() ? nullptr : &found->second;
}

}  // namespace

bool FindLook(std::string_view name, Look& look) {
  const auto found = Read().looks.find(name);
  if (found == Read().looks.end()) return false;
  look = found->second;
  return true;
}

Color AgentColor(std::string_view kind) {
  if (const Color* const known = FindColor(Read().kinds, kind)) return *known;
  std::uint32_t hash = 2166136261u;
  for (const char c : kind) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return Read().others[hash % Read().others.size()];
}

// The colours differ in lightness and on the blue-yellow axis, too, for people who cannot distinguish red from green.
Color TeamColor(std::string_view team) {
  const Color* const known = FindColor(Read().teams, team);
  return known != nullptr ? *known : AgentColor(team);
}

bool IsAgentColorMaterial(std::string_view material) {
  return std::ranges::find(Read().textures, material) == Read().textures.end();
}

}  // namespace soarbox::viewer
