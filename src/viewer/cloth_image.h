// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "viewer/images.h"
#include "viewer/skin_mesh.h"

namespace soarbox::viewer {

/// One picture with all materials that soldiers wear: sixteen cells, one for each Cloth.
Image ClothImage(int cell_size);

struct ClothPlace {
  float u, v;
};
/// Texture coordinates of a point of the body (in m, in its bind pose).
ClothPlace PlaceOnCloth(Cloth cloth, world::Vec3 at);

/// 0..1
float GlossOf(Cloth cloth);

}  // namespace soarbox::viewer
