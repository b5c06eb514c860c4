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

/// What reading a PNG file gave: pixels, or why there are none.
struct PngRead {
  Pixels pixels;
  std::string problem;  ///< "the file ends within a chunk"; empty: none.
};

/// Largest width and height that are read.
inline constexpr int kMostPngSide = 4096;

/// Reads a PNG file from anywhere: each length in it is checked. Gray, colours and palettes of up to 8 bits, each with
/// or without transparency, are read; interlaced files and those of 16 bits are not.
PngRead ReadPng(std::string_view file);

}  // namespace soarbox::picture
