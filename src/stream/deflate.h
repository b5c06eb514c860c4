// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::stream {

/// Compresses bytes in zlib's format, which browsers decompress with DecompressionStream("deflate"). Empty on failure.
std::string Deflate(std::string_view bytes);

}  // namespace soarbox::stream
