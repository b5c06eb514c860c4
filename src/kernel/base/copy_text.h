// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace soarbox::kernel {

/// Copies a text that is usually short, without a function call. `to` must have room for the text and must not overlap
/// it.
inline void CopyText(char* to, std::string_view text) {
  const char* const from = text.data();
  const std::size_t size = text.size();
  const auto copy = [&](std::size_t at, auto word) {
    std::memcpy(&word, from + at, sizeof(word));
    std::memcpy(to + at, &word, sizeof(word));
  };
  if (size > 64) {
    std::memcpy(to, from, size);
  } else if (size >= 8) {
    for (std::size_t at = 0; at + 8 < size; at += 8) copy(at, std::uint64_t{0});
    copy(size - 8, std::uint64_t{0});
  } else if (size >= 4) {
    copy(0, std::uint32_t{0});
    copy(size - 4, std::uint32_t{0});
  } else {
    for (std::size_t at = 0; at < size; ++at) to[at] = from[at];
  }
}

}  // namespace soarbox::kernel
