// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "bytes/byte_stream.h"

namespace soarbox::record {

/// Writes the bytes of an event log (mind/event_log.h) as the difference from the log of another tick, event by event.
/// What a mind does in one tick is similar to the tick before: the same percepts with other values, the same operators
/// with other identifiers.
void WriteEventDelta(ByteWriter& out, std::string_view before, std::string_view now);

/// Reads the bytes of the log back. If the input is damaged, they can be anything.
std::string ReadEventDelta(ByteReader& in, std::string_view before);

}  // namespace soarbox::record
