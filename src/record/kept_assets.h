// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <vector>

#include "record/kept_files.h"

namespace soarbox::record {

/// Stores the images, sounds and models of a recording's files where renderers of its scenes find them
/// (world/asset_store.h, model/model.h). Files that cannot be used are skipped, because recordings are not trusted.
void StoreAssets(const std::vector<KeptFile>& files);

}  // namespace soarbox::record
