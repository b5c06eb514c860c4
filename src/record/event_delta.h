// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "bytes/byte_stream.h"

namespace soarbox::record {

/// What a mind does in one tick is much like what it did in the one before: the same percepts with other numbers, the
/// same operators with other identifiers. Writes the bytes of an event log (mind/event_log.h) as what differs from
/// those of another, event by event.
void WriteEventDelta(ByteWriter& out, std::string_view before, std::string_view now);

/// Reads the bytes of the log back. They may be anything if what was written is.
std::string ReadEventDelta(ByteReader& in, std::string_view before);

}  // namespace soarbox::record
