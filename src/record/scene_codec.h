// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "bytes/byte_stream.h"
#include "record/format.h"
#include "world/scene_snapshot.h"

namespace soarbox::record {

/// Writes a scene as what differs from an earlier one; an empty scene before it makes it stand alone.
void WriteScene(ByteWriter& out, const world::SceneSnapshot& before, const world::SceneSnapshot& now);

/// Turns the earlier scene into the later one. `in` has failed afterwards if the bytes do not make sense; the scene is
/// then of no use; `version` is the format's. Whether it has failed or not, memory stays below a multiple of the bytes
/// read and of `scene`.
void ReadScene(ByteReader& in, world::SceneSnapshot& scene, std::uint16_t version = kVersion);

}  // namespace soarbox::record
