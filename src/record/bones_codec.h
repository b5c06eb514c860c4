// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "bytes/buffered_writer.h"
#include "bytes/byte_stream.h"
#include "world/animation/body_bones.h"

namespace soarbox::record {

/// Writes the bones of a body as the difference from the tick before. If the movements of the body are known, they are
/// written; otherwise the position of each bone.
void PutBones(BufferedWriter& out, const world::BodyBones& before, const world::BodyBones& now);

/// Reads a difference and applies it to the bones of the tick before.
void GetBones(ByteReader& in, world::BodyBones& bones);

/// Compares bit for bit, so that -0 and NaN replay exactly.
bool AreSameBones(const world::BodyBones& a, const world::BodyBones& b);

}  // namespace soarbox::record
