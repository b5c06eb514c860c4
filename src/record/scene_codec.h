// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "bytes/byte_stream.h"
#include "record/format.h"
#include "world/scene_snapshot.h"

namespace soarbox::record {

/// Writes a scene as its difference from an earlier one; with an empty earlier scene it is complete in itself.
void WriteScene(ByteWriter& out, const world::SceneSnapshot& before, const world::SceneSnapshot& now);

/// Turns the earlier scene into the later one. If the bytes make no sense, `in` has failed and the scene is useless.
/// In either case, memory stays below a multiple of the bytes read and of `scene`.
void ReadScene(ByteReader& in, world::SceneSnapshot& scene);

}  // namespace soarbox::record
