// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "bytes/buffered_writer.h"
#include "bytes/byte_stream.h"
#include "record/file_format.h"
#include "world/scene_snapshot.h"

namespace soarbox::record {

/// Writes a scene as its difference from an earlier one. If the earlier scene is empty, the output is complete.
void WriteScene(BufferedWriter& out, const world::SceneSnapshot& before, const world::SceneSnapshot& now);

/// Reads a difference and applies it to `scene`. If the bytes are invalid, `in` has failed and the scene is undefined.
/// In either case, memory is limited to a multiple of the bytes read plus the size of `scene`.
void ReadScene(ByteReader& in, world::SceneSnapshot& scene);

}  // namespace soarbox::record
