// SPDX-License-Identifier: BSD-2-Clause
#include "record/kept_assets.h"

#include <algorithm>

#include "diagnostics/problem.h"
#include "model/gltf.h"
#include "world/asset_store.h"

namespace soarbox::record {

void StoreAssets(const std::vector<KeptFile>& files) {
  for (const KeptFile& file : files) {
    if (!world::IsAssetName(file.name)) continue;
    if (!model::IsModelName(file.name)) {
      world::KeepAsset(file.name, file.content);
      continue;
    }
    const std::string folder = file.name.substr(0, file.name.rfind('/') + 1);
    Result<model::Model> read = model::ReadGltf(file.content, [&](std::string_view name) -> Result<std::string> {
      const std::string wanted = folder + std::string(name);
      const auto found = std::ranges::find_if(
          files, [&](const KeptFile& other) { return other.folder == file.folder && other.name == wanted; });
      if (found != files.end()) return found->content;
      return NewProblem("it was not kept");
    });
    if (read) model::KeepModel(file.name, std::move(*read));
  }
}

}  // namespace soarbox::record
