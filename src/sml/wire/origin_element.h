// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "mind/origin.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The calls that switch the noting of origins on, and that ask for one by the argument "timetag" or "command".
/// Soarbox's own: other kernels answer with an error.
inline constexpr const char* kNoteOriginsCall = "soarbox_note_origins";
inline constexpr const char* kOriginCall = "soarbox_origin";

/// Adds <origins> with an <origin> for each.
void AddOrigins(Element& parent, const mind::OriginFacts& facts);
/// Reads the <origins> of an answer. Places that are out of bounds are dropped; without <origins> nothing is noted.
mind::OriginFacts ReadOrigins(const Element& parent);

}  // namespace soarbox::wire
