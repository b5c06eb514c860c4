// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "bytes/buffered_writer.h"
#include "bytes/byte_stream.h"

namespace soarbox::record {

/// Writes bytes as their difference from similar ones: their size (0 if equal to that of the others), then alternating
/// counts of bytes that are equal at the same position and of new bytes, until the size is reached.
void WriteDifference(BufferedWriter& out, std::string_view before, std::string_view now);

/// Reads the bytes back and appends them to `now`. If the input is damaged, they can be anything.
void ReadDifference(ByteReader& in, std::string_view before, std::string& now);

}  // namespace soarbox::record
