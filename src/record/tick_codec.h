// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bytes/buffered_writer.h"
#include "bytes/byte_stream.h"
#include "record/file_format.h"
#include "record/minds_codec.h"
#include "record/tick_record.h"

namespace soarbox::record {

/// Writes a tick as its difference from the one before and from earlier ones of its block, which `minds` contains. If
/// both are empty, the output is complete.
void WriteTick(BufferedWriter& out, const TickRecord& before, const TickRecord& now, MindsEncoder& minds);

/// Reads a difference and applies it to `record`. If the bytes are invalid, `in` has failed.
void ReadTick(ByteReader& in, TickRecord& record, MindsDecoder& minds);

/// Writes the inputs before a tick. They are kept when a bounded recording drops the tick.
void WriteInputs(ByteWriter& out, std::uint64_t tick, const std::vector<std::string>& inputs);
void ReadInputs(ByteReader& in, std::uint64_t& tick, std::vector<std::string>& inputs);

}  // namespace soarbox::record
