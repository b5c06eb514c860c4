// SPDX-License-Identifier: BSD-2-Clause
#include "model/model.h"

#include <map>
#include <mutex>

#include "world/asset_store.h"
#include "world/state_hash.h"

namespace soarbox::model {
namespace {

struct Models {
  std::mutex mutex;
  std::map<std::uint64_t, std::shared_ptr<const Model>> by_hash;
};

Models& AllModels() {
  static Models models;
  return models;
}

std::uint64_t HashOfModel(const Model& model) {
  world::StateHash hash;
  for (const Corner& corner : model.corners) {
    hash.Add(corner.position);
    hash.Add(corner.normal);
    hash.Add(corner.red, corner.green);
    hash.Add(corner.blue);
  }
  for (const std::uint32_t index : model.indices) hash.Add(static_cast<std::uint64_t>(index));
  return hash.value();
}

}  // namespace

std::string KeepModel(std::string_view name, Model model) {
  const std::uint64_t hash = HashOfModel(model);
  Models& models = AllModels();
  const std::scoped_lock lock(models.mutex);
  if (const auto found = models.by_hash.find(hash); found == models.by_hash.end())
    models.by_hash.emplace(hash, std::make_shared<const Model>(std::move(model)));
  return world::AssetKey(name, hash);
}

std::shared_ptr<const Model> FindModel(std::string_view key) {
  const auto hash = world::HashInKey(key);
  if (!hash) return nullptr;
  Models& models = AllModels();
  const std::scoped_lock lock(models.mutex);
  const auto found = models.by_hash.find(*hash);
  return found == models.by_hash.end() ? nullptr : found->second;
}

bool IsModelName(std::string_view name) {
  return name.ends_with(".glb") || name.ends_with(".gltf");
}

}  // namespace soarbox::model
