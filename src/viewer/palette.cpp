// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/palette.h"

#include <algorithm>

namespace soarbox::viewer {
namespace {

using Paint = Look::Paint;
using world::Color;

struct NamedLook {
  std::string_view name;
  Look look;
};

constexpr Color kWhite{0.88f, 0.88f, 0.87f, 1}, kRed{0.80f, 0.16f, 0.13f, 1}, kGreen{0.22f, 0.62f, 0.24f, 1},
    kBlue{0.16f, 0.36f, 0.78f, 1}, kYellow{0.92f, 0.78f, 0.20f, 1}, kDark{0.05f, 0.06f, 0.08f, 1};

/// The second colour of ground is that of its grass; transparent: no grass.
constexpr Color kGrass{0.36f, 0.44f, 0.22f, 1}, kBare{0, 0, 0, 0};

Color Clear(Color color) {
  color.a = 0.45f;
  return color;
}

const std::vector<NamedLook>& Looks() {
  static const std::vector<NamedLook> looks{
      {"White", {kWhite, kDark, 0.2f, 0, Paint::kPlain, 1}},
      {"Red", {kRed, kDark, 0.3f, 0, Paint::kPlain, 1}},
      {"Green", {kGreen, kDark, 0.3f, 0, Paint::kPlain, 1}},
      {"Blue", {kBlue, kDark, 0.3f, 0, Paint::kPlain, 1}},
      {"RedGlow", {kRed, kDark, 0.3f, 1.2f, Paint::kPlain, 1}},
      {"GreenGlow", {kGreen, kDark, 0.3f, 1.2f, Paint::kPlain, 1}},
      {"BlueGlow", {kBlue, kDark, 0.3f, 1.2f, Paint::kPlain, 1}},
      {"TransparentRed", {Clear(kRed), kDark, 0.4f, 0, Paint::kPlain, 1}},
      {"TransparentGreen", {Clear(kGreen), kDark, 0.4f, 0, Paint::kPlain, 1}},
      {"TransparentBlue", {Clear(kBlue), kDark, 0.4f, 0, Paint::kPlain, 1}},
      {"TransparentYellow", {Clear(kYellow), kDark, 0.4f, 0, Paint::kPlain, 1}},
      {"TransparentWhite", {Clear(kWhite), kDark, 0.4f, 0, Paint::kPlain, 1}},
      {"Ground", {{0.55f, 0.52f, 0.47f, 1}, kBare, 0.05f, 0, Paint::kGround, 1}},
      {"Ground2", {{0.60f, 0.605f, 0.56f, 1}, kGrass, 0.05f, 0, Paint::kGround, 1}},
      {"NobiaxModular", {{0.80f, 0.79f, 0.76f, 1}, {0.10f, 0.13f, 0.16f, 1}, 0.1f, 0, Paint::kConcrete, 0.39f}},
      {"base_material", {kWhite, kDark, 0.2f, 0, Paint::kPlain, 1}},
      {"base_animated_material", {kWhite, kDark, 0.2f, 0, Paint::kPlain, 1}},
      {"SF_Soldier_Body", {{0.55f, 0.58f, 0.55f, 1}, kDark, 0.35f, 0, Paint::kPlain, 1}},
      {"SF_Soldier_Body_Dark", {{0.22f, 0.24f, 0.26f, 1}, kDark, 0.35f, 0, Paint::kPlain, 1}},
      {"SF_Soldier_HelmetVisor", {{0.85f, 0.60f, 0.15f, 1}, kDark, 0.9f, 0.2f, Paint::kPlain, 1}},
      {"SF_Soldier_HelmetVisor_Dark", {{0.55f, 0.10f, 0.08f, 1}, kDark, 0.9f, 0.2f, Paint::kPlain, 1}},
      {"SF_Weapon_WeaponBody", {{0.20f, 0.21f, 0.23f, 1}, kDark, 0.5f, 0, Paint::kPlain, 1}},
      {"SF_Weapon_Holo", {{0.20f, 0.75f, 0.90f, 0.5f}, kDark, 0.5f, 1.0f, Paint::kPlain, 1}},
      {"SF_Weapon_Stabilization", {{0.35f, 0.36f, 0.38f, 1}, kDark, 0.5f, 0, Paint::kPlain, 1}},
      {"SF_Weapon_Thursters", {{0.90f, 0.55f, 0.15f, 1}, kDark, 0.5f, 0.6f, Paint::kPlain, 1}},
      {"Particles/Bullet", {{1.0f, 0.85f, 0.45f, 1}, kDark, 0.2f, 1.5f, Paint::kPlain, 1}},
      {"Particles/Impact", {{0.85f, 0.80f, 0.70f, 1}, kDark, 0.1f, 0.3f, Paint::kPlain, 1}},
      {"debug_draw", {Clear(kWhite), kDark, 0.1f, 0.5f, Paint::kPlain, 1}},
      {"debug_opaque_draw", {kWhite, kDark, 0.1f, 0.5f, Paint::kPlain, 1}},
      {"Soarbox/Brick", {{0.98f, 0.97f, 0.95f, 1}, {0.10f, 0.14f, 0.17f, 1}, 0.06f, 0, Paint::kBrick, 0.78f}},
      {"Soarbox/Concrete", {{0.80f, 0.79f, 0.76f, 1}, {0.10f, 0.13f, 0.16f, 1}, 0.1f, 0, Paint::kConcrete, 0.39f}},
      {"Soarbox/Crate", {{0.90f, 0.66f, 0.38f, 1}, {0.20f, 0.19f, 0.18f, 1}, 0.14f, 0, Paint::kCrate, 1.25f}},
      {"Soarbox/Metal", {{0.62f, 0.66f, 0.70f, 1}, {0.15f, 0.16f, 0.17f, 1}, 0.38f, 0, Paint::kConcrete, 0.5f}},
      {"Soarbox/Leaves", {{0.62f, 0.74f, 0.42f, 1}, {0.31f, 0.24f, 0.17f, 1}, 0.02f, 0, Paint::kLeaves, 1}},
      {"Soarbox/Stone", {{0.78f, 0.77f, 0.74f, 1}, kDark, 0.05f, 0, Paint::kStone, 0.5f}},
      {"Soarbox/Rock", {{0.62f, 0.60f, 0.56f, 1}, kDark, 0.05f, 0, Paint::kStone, 0.5f}},
      {"Soarbox/Medkit", {{0.95f, 0.95f, 0.93f, 1}, {0.83f, 0.06f, 0.06f, 1}, 0.25f, 0, Paint::kPlain, 1}},
      {"Soarbox/Ammunition", {{0.30f, 0.34f, 0.20f, 1}, {0.86f, 0.62f, 0.18f, 1}, 0.15f, 0, Paint::kPlain, 1}},
      {"Soarbox/Sack", {{0.71f, 0.58f, 0.38f, 1}, {0.35f, 0.22f, 0.12f, 1}, 0.02f, 0, Paint::kPlain, 1}},
      {"Soarbox/Sheep", {{0.93f, 0.91f, 0.84f, 1}, {0.16f, 0.13f, 0.12f, 1}, 0.02f, 0, Paint::kPlain, 1}},
      {"Soarbox/Bear", {{0.36f, 0.22f, 0.12f, 1}, {0.62f, 0.45f, 0.30f, 1}, 0.04f, 0, Paint::kPlain, 1}},
      {"Soarbox/Hare", {{0.66f, 0.53f, 0.38f, 1}, {0.88f, 0.80f, 0.72f, 1}, 0.03f, 0, Paint::kPlain, 1}},
      {"Soarbox/Cook", {{0.97f, 0.97f, 0.96f, 1}, {0.85f, 0.62f, 0.48f, 1}, 0.05f, 0, Paint::kPlain, 1}},
      {"Soarbox/Wolf", {{0.40f, 0.41f, 0.43f, 1}, {0.72f, 0.70f, 0.67f, 1}, 0.03f, 0, Paint::kPlain, 1}},
      {"Soarbox/Villager", {{0.24f, 0.36f, 0.56f, 1}, {0.84f, 0.64f, 0.44f, 1}, 0.03f, 0, Paint::kPlain, 1}},
      {"Soarbox/Robot", {{0.90f, 0.42f, 0.10f, 1}, {0.16f, 0.17f, 0.19f, 1}, 0.30f, 0, Paint::kPlain, 1}},
      {"Soarbox/Cart", {{0.58f, 0.40f, 0.22f, 1}, {0.42f, 0.34f, 0.16f, 1}, 0.03f, 0, Paint::kPlain, 1}},
      {"Soarbox/Bee", {{0.96f, 0.74f, 0.10f, 1}, {0.09f, 0.08f, 0.07f, 1}, 0.15f, 0, Paint::kPlain, 1}},
      {"Soarbox/Bell", {{0.82f, 0.58f, 0.20f, 1}, {0.42f, 0.28f, 0.17f, 1}, 0.05f, 0, Paint::kPlain, 1}},
      {"Soarbox/Yellow", {kYellow, kDark, 0.3f, 0, Paint::kPlain, 1}},
      {"Soarbox/Purple", {{0.46f, 0.20f, 0.62f, 1}, kDark, 0.3f, 0, Paint::kPlain, 1}},
      {"Soarbox/Orange", {{0.94f, 0.46f, 0.10f, 1}, kDark, 0.3f, 0, Paint::kPlain, 1}},
      {"Soarbox/Black", {{0.07f, 0.07f, 0.08f, 1}, kDark, 0.4f, 0, Paint::kPlain, 1}},
      {"Soarbox/BoardLight", {{0.66f, 0.68f, 0.62f, 1}, kDark, 0.05f, 0, Paint::kPlain, 1}},
      {"Soarbox/BoardDark", {{0.56f, 0.59f, 0.53f, 1}, kDark, 0.05f, 0, Paint::kPlain, 1}},
      {"Soarbox/Gold", {{1.00f, 0.76f, 0.16f, 1}, kDark, 0.6f, 0, Paint::kPlain, 1}},
      {"Soarbox/Silver", {{0.82f, 0.85f, 0.89f, 1}, kDark, 0.6f, 0, Paint::kPlain, 1}},
      {"Soarbox/Bronze", {{0.68f, 0.38f, 0.17f, 1}, kDark, 0.6f, 0, Paint::kPlain, 1}},
      {"Soarbox/RedFlower", {{0.86f, 0.12f, 0.14f, 1}, {0.52f, 0.62f, 0.14f, 1}, 0.05f, 0, Paint::kPlain, 1}},
      {"Soarbox/BlueFlower", {{0.20f, 0.34f, 0.90f, 1}, {0.52f, 0.62f, 0.14f, 1}, 0.05f, 0, Paint::kPlain, 1}},
      {"Soarbox/WhiteFlower", {{0.95f, 0.95f, 0.93f, 1}, {0.52f, 0.62f, 0.14f, 1}, 0.05f, 0, Paint::kPlain, 1}},
      {"Soarbox/Hedge", {{0.20f, 0.38f, 0.13f, 1}, kDark, 0.02f, 0, Paint::kPlain, 1}},
      {"Soarbox/Hills", {{0.40f, 0.47f, 0.24f, 1}, {0.33f, 0.28f, 0.22f, 1}, 0.02f, 0, Paint::kPlain, 1}},
      {"Soarbox/Model", {{1, 1, 1, 1}, kDark, 0.15f, 0, Paint::kCorners, 1}},
      {"Soarbox/Missing", {{1, 1, 1, 1}, kDark, 0.1f, 0.35f, Paint::kMissing, 1}},
  };
  return looks;
}

}  // namespace

bool FindLook(std::string_view name, Look& look) {
  const auto& looks = Looks();
  const auto found =
      std::find_if(looks.begin(), looks.end(), [&](const NamedLook& named) { return named.name == name; });
  if (found == looks.end()) return false;
  look = found->look;
  return true;
}

world::Color AgentColor(std::string_view kind) {
  const auto has = [kind](std::string_view part) { return kind.find(part) != std::string_view::npos; };
  if (has("seek")) return {0.86f, 0.22f, 0.17f, 1};
  if (has("follow")) return {0.13f, 0.47f, 0.80f, 1};
  if (has("waypoint")) return {0.20f, 0.62f, 0.36f, 1};
  if (has("lua")) return {0.95f, 0.56f, 0.10f, 1};
  if (kind == "soar") return {0.50f, 0.30f, 0.72f, 1};
  constexpr Color kOthers[] = {{0.50f, 0.30f, 0.72f, 1}, {0.09f, 0.60f, 0.62f, 1}, {0.83f, 0.31f, 0.55f, 1},
                               {0.62f, 0.60f, 0.16f, 1}, {0.55f, 0.37f, 0.24f, 1}, {0.44f, 0.50f, 0.58f, 1}};
  std::uint32_t hash = 2166136261u;
  for (const char c : kind) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
  return kOthers[hash % std::size(kOthers)];
}

world::Color TeamColor(std::string_view team) {
  if (team.empty()) return {0.33f, 0.33f, 0.27f, 1};
  const auto has = [team](std::string_view part) { return team.find(part) != std::string_view::npos; };
  // Different in lightness and on the blue-yellow axis too, for people who cannot distinguish red from green.
  if (team == "team1" || has("blue")) return {0.05f, 0.36f, 0.88f, 1};
  if (team == "team2" || has("red")) return {0.90f, 0.24f, 0.06f, 1};
  if (has("green")) return {0.00f, 0.66f, 0.50f, 1};
  if (has("yellow")) return {0.97f, 0.86f, 0.24f, 1};
  return AgentColor(team);
}

bool IsAgentColorMaterial(std::string_view material) {
  constexpr std::string_view kJustSomeTexture[] = {
      "", "Ground", "Ground2", "White", "NobiaxModular", "base_material", "base_animated_material"};
  return std::find(std::begin(kJustSomeTexture), std::end(kJustSomeTexture), material) == std::end(kJustSomeTexture);
}

}  // namespace soarbox::viewer
