// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

namespace soarbox::stream {

/// The bytes as a stream of zlib's format, which browsers undo with DecompressionStream("deflate"). Empty on failure.
std::string Deflate(std::string_view bytes);

}  // namespace soarbox::stream
