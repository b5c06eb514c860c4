// SPDX-License-Identifier: BSD-2-Clause
#include "world/media_catalog.h"

#include <utility>

#include "world/body_meshes.h"
#include "world/modular_meshes.h"
#include "world/scenery_meshes.h"

namespace soarbox::world {
namespace {

// The names that the sandbox's scripts can use without loading resources (lua_api.md 11).
constexpr const char* kMaterials[] = {
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
constexpr const char* kSkies[] = {"ThickCloudsWaterSkyBox"};
constexpr const char* kParticles[] = {"Bullet", "BulletImpact"};

std::string Hint(std::string_view name, const std::vector<std::string_view>& known, std::string_view otherwise) {
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

template <typename Names>
std::vector<std::string_view> Views(const Names& names) {
  std::vector<std::string_view> views;
  for (const auto& name : names) {
    if constexpr (requires { name.first; }) {
      views.emplace_back(name.first);
    } else {
      views.emplace_back(name);
    }
  }
  return views;
}

std::string UnknownName(std::string_view what, std::string_view name) {
  return "unknown " + std::string(what) + " \"" + std::string(name) + "\"";
}

}  // namespace

MediaCatalog::MediaCatalog() {
  for (const ModularMesh& mesh : kModularMeshes) {
    AddMesh("models/nobiax_modular/" + std::string(mesh.name) + ".mesh", {mesh.min, mesh.max});
  }
  for (const BodyMesh& mesh : kBodyMeshes) AddMesh(std::string(mesh.name), mesh.bounds);
  for (const SceneryMesh& mesh : kSceneryMeshes) AddMesh(std::string(mesh.name), mesh.bounds);
  for (const char* name : kMaterials) AddMaterial(name);
  for (const char* name : kSkies) AddSky(name);
  for (const char* name : kParticles) AddParticle(name);
}

void MediaCatalog::AddMesh(std::string name, MeshBounds bounds) {
  meshes_[std::move(name)] = bounds;
}
void MediaCatalog::AddMaterial(std::string name) {
  materials_.insert(std::move(name));
}
void MediaCatalog::AddSky(std::string name) {
  skies_.insert(std::move(name));
}
void MediaCatalog::AddParticle(std::string name) {
  particles_.insert(std::move(name));
}

bool MediaCatalog::HasMesh(std::string_view name) const {
  return meshes_.find(name) != meshes_.end();
}
bool MediaCatalog::HasMaterial(std::string_view name) const {
  return materials_.find(name) != materials_.end();
}

MeshBounds MediaCatalog::LookUpMesh(std::string_view name) {
  const auto found = meshes_.find(name);
  if (found != meshes_.end()) return found->second;
  Warn(UnknownName("mesh", name), Hint(name, Views(meshes_), "a box of 1 m is shown instead"));
  return {};
}

std::string MediaCatalog::LookUpMaterial(std::string_view name) {
  if (HasMaterial(name)) return std::string(name);
  Warn(UnknownName("material", name), Hint(name, Views(materials_), "\"White\" is used instead"));
  return "White";
}

std::string MediaCatalog::LookUpSky(std::string_view name) {
  if (skies_.find(name) != skies_.end()) return std::string(name);
  Warn(UnknownName("sky", name), Hint(name, Views(skies_), "the sky stays plain"));
  return {};
}

std::string MediaCatalog::LookUpParticle(std::string_view name) {
  if (particles_.find(name) != particles_.end()) return std::string(name);
  Warn(UnknownName("particle effect", name), Hint(name, Views(particles_), "nothing is drawn in its place"));
  return {};
}

bool MediaCatalog::CheckResource(std::string_view name) {
  if (HasMesh(name) || HasMaterial(name) || skies_.find(name) != skies_.end() ||
      particles_.find(name) != particles_.end()) {
    return true;
  }
  Warn(UnknownName("resource", name), Hint(name, Views(meshes_), "it is not loaded"));
  return false;
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
