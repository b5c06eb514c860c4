// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::picture {

/// Pixels of four bytes (red, green, blue, alpha), in rows from the top.
struct Pixels {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

/// The result of reading a PNG file: the pixels, or an error.
struct PngRead {
  Pixels pixels;
  std::string problem;  ///< "the file ends within a chunk"; empty: none.
};

/// Maximum width and height.
inline constexpr int kMostPngSide = 4096;

/// Reads a PNG file, which is not trusted: each length in it is checked. Supports gray, colours and palettes of up to 8
/// bits, with or without transparency; not interlaced files and not 16 bits.
PngRead ReadPng(std::string_view file);

}  // namespace soarbox::picture
