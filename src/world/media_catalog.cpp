// SPDX-License-Identifier: BSD-2-Clause
#include "world/media_catalog.h"

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include "world/body_meshes.h"
#include "world/modular_meshes.h"
#include "world/scenery_meshes.h"

namespace soarbox::world {
namespace {

// The names that the sandbox's scripts can use without loading resources (lua_api.md 11).
constexpr std::string_view kMaterials[] = {
    "White", "Red", "Green", "Blue", "RedGlow", "GreenGlow", "BlueGlow", "TransparentRed", "TransparentGreen",
    "TransparentBlue", "TransparentYellow", "TransparentWhite", "Ground", "Ground2", "NobiaxModular", "base_material",
    "base_animated_material", "SF_Soldier_Body", "SF_Soldier_Body_Dark", "SF_Soldier_HelmetVisor",
    "SF_Soldier_HelmetVisor_Dark", "SF_Weapon_WeaponBody", "SF_Weapon_Holo", "SF_Weapon_Stabilization",
    "SF_Weapon_Thursters", "Particles/Bullet", "Particles/Impact", "debug_draw", "debug_opaque_draw",
    // Surfaces, things and creatures of scenario files.
    "Soarbox/Brick", "Soarbox/Concrete", "Soarbox/Crate", "Soarbox/Metal", "Soarbox/Stone", "Soarbox/Rock",
    "Soarbox/Medkit", "Soarbox/Ammunition", "Soarbox/Sack", "Soarbox/Sheep", "Soarbox/Bear", "Soarbox/Hare",
    "Soarbox/Wolf", "Soarbox/Villager", "Soarbox/Robot", "Soarbox/Cart", "Soarbox/Bee", "Soarbox/Bell", "Soarbox/Gold",
    "Soarbox/Silver", "Soarbox/Bronze", "Soarbox/RedFlower", "Soarbox/BlueFlower", "Soarbox/WhiteFlower",
    "Soarbox/Hedge", "Soarbox/Cook", "Soarbox/Yellow", "Soarbox/Purple", "Soarbox/Orange", "Soarbox/Black",
    "Soarbox/BoardLight", "Soarbox/BoardDark"};
constexpr std::string_view kSkies[] = {"ThickCloudsWaterSkyBox"};
constexpr std::string_view kParticles[] = {"Bullet", "BulletImpact"};

using Names = std::vector<std::string_view>;

std::string Hint(std::string_view name, Names known, std::string_view otherwise) {
  std::ranges::sort(known);
  const std::string_view meant = Suggest(name, known);
  if (meant.empty()) {
    constexpr std::size_t kMostNamed = 100;  // A list of hundreds of meshes would not help.
    if (known.size() > kMostNamed) return std::string(otherwise) + "; docs/lua/names.md lists them";
    std::string all;
    for (const std::string_view one : known) all += (all.empty() ? "" : ", ") + std::string(one);
    return std::string(otherwise) + "; there are " + all;
  }
  return "did you mean \"" + std::string(meant) + "\"? " + std::string(otherwise);
}

std::string UnknownName(std::string_view what, std::string_view name) {
  return "unknown " + std::string(what) + " \"" + std::string(name) + "\"";
}

bool IsIn(std::string_view name, std::span<const std::string_view> names) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

MediaCatalog::MediaCatalog() {
  for (const ModularMesh& mesh : kModularMeshes) {
    AddMesh("models/nobiax_modular/" + std::string(mesh.name) + ".mesh", {mesh.min, mesh.max});
  }
  for (const BodyMesh& mesh : kBodyMeshes) AddMesh(std::string(mesh.name), mesh.bounds);
  for (const SceneryMesh& mesh : kSceneryMeshes) AddMesh(std::string(mesh.name), mesh.bounds);
}

void MediaCatalog::AddMesh(std::string name, MeshBounds bounds) {
  meshes_[std::move(name)] = bounds;
}

MeshBounds MediaCatalog::LookUpMesh(std::string_view name) {
  const auto found = meshes_.find(name);
  if (found != meshes_.end()) return found->second;
  WarnOfMesh("mesh", name, "a box of 1 m is shown instead");
  return {};
}

std::string MediaCatalog::LookUpMaterial(std::string_view name) {
  if (IsIn(name, kMaterials)) return std::string(name);
  Warn(UnknownName("material", name),
       Hint(name, {std::begin(kMaterials), std::end(kMaterials)}, "\"White\" is used instead"));
  return "White";
}

std::string MediaCatalog::LookUpSky(std::string_view name) {
  if (IsIn(name, kSkies)) return std::string(name);
  Warn(UnknownName("sky", name), Hint(name, {std::begin(kSkies), std::end(kSkies)}, "the sky stays plain"));
  return {};
}

std::string MediaCatalog::LookUpParticle(std::string_view name) {
  if (IsIn(name, kParticles)) return std::string(name);
  Warn(UnknownName("particle effect", name),
       Hint(name, {std::begin(kParticles), std::end(kParticles)}, "nothing is drawn in its place"));
  return {};
}

bool MediaCatalog::CheckResource(std::string_view name) {
  if (HasMesh(name) || IsIn(name, kMaterials) || IsIn(name, kSkies) || IsIn(name, kParticles)) return true;
  WarnOfMesh("resource", name, "it is not loaded");
  return false;
}

void MediaCatalog::WarnOfMesh(std::string_view what, std::string_view name, std::string_view otherwise) {
  Names known;
  for (const auto& [mesh, bounds] : meshes_) known.emplace_back(mesh);
  Warn(UnknownName(what, name), Hint(name, std::move(known), otherwise));
}

void MediaCatalog::Warn(std::string message, std::string hint) {
  if (!warned_.insert(message).second) return;
  Diagnostic warning;
  warning.severity = Severity::kWarning;
  warning.message = std::move(message);
  warning.hint = std::move(hint);
  warnings_.push_back(std::move(warning));
}

std::vector<Diagnostic> MediaCatalog::TakeWarnings() {
  return std::exchange(warnings_, {});
}

}  // namespace soarbox::world
