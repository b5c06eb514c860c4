// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "mind/origin.h"
#include "sml/wire/element.h"

namespace soarbox::wire {

/// The calls that enable recording of origins, and that request one by the argument "timetag" or "command". Soarbox
/// only: other kernels answer with an error.
inline constexpr const char* kNoteOriginsCall = "soarbox_note_origins";
inline constexpr const char* kOriginCall = "soarbox_origin";

/// Adds <origins> with one <origin> each.
void AddOrigins(Element& parent, const mind::OriginFacts& facts);
/// Reads the <origins> of a response. Indices out of range are dropped. Without <origins>, the result is empty.
mind::OriginFacts ReadOrigins(const Element& parent);

}  // namespace soarbox::wire
