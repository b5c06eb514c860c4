// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

#include "bytes/byte_stream.h"
#include "world/animation/body_bones.h"

namespace soarbox::record {

/// Writes the bones of a body as what its movements are, if that is known, else as where each bone is; in both cases as
/// the difference from the tick before.
void PutBones(ByteWriter& out, const world::BodyBones& before, const world::BodyBones& now);

/// Turns the bones of the tick before into those of the next.
void GetBones(ByteReader& in, world::BodyBones& bones);

/// Bit for bit, so that -0 and NaN replay as they were.
bool AreSameBones(const world::BodyBones& a, const world::BodyBones& b);

}  // namespace soarbox::record
