// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "picture/png_reader.h"

namespace soarbox::picture {

/// What reading a JPEG file gave: pixels, or why there are none.
struct JpegRead {
  Pixels pixels;
  std::string problem;  ///< "the file ends within its picture"; empty: none.
};

/// Largest width and height that are read, and most pixels.
inline constexpr int kMostJpegSide = 4096;
inline constexpr int kMostJpegPixels = 8 << 20;

/// Whether the file begins as a JPEG file does.
bool IsJpeg(std::string_view file);

/// Reads a JPEG file from anywhere: each length in it is checked. Gray and coloured pictures of 8 bits are read,
/// baseline and progressive, with any sampling. Arithmetic coding, lossless files and CMYK are not. The pixels are the
/// same on every machine: all computations use integers. Colours of fewer samples are repeated, not interpolated.
JpegRead ReadJpeg(std::string_view file);

}  // namespace soarbox::picture
