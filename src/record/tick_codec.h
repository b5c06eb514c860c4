// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bytes/byte_stream.h"
#include "record/format.h"
#include "record/tick_record.h"

namespace soarbox::record {

/// Writes a tick as its difference from the one before; with an empty one before it, it is complete in itself.
void WriteTick(ByteWriter& out, const TickRecord& before, const TickRecord& now);

/// Turns the record of one tick into that of the next. If the bytes make no sense, `in` has failed.
void ReadTick(ByteReader& in, TickRecord& record);

/// The inputs before a tick, kept when a bounded recording drops the tick's frames.
void WriteInputs(ByteWriter& out, std::uint64_t tick, const std::vector<std::string>& inputs);
void ReadInputs(ByteReader& in, std::uint64_t& tick, std::vector<std::string>& inputs);

}  // namespace soarbox::record
