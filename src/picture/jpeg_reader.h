// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "picture/png_reader.h"

namespace soarbox::picture {

/// The result of reading a JPEG file: the pixels, or an error.
struct JpegRead {
  Pixels pixels;
  std::string problem;  ///< "the file ends within its picture"; empty: none.
};

/// Maximum width and height, and maximum number of pixels.
inline constexpr int kMostJpegSide = 4096;
inline constexpr int kMostJpegPixels = 8 << 20;

/// Whether the file begins like a JPEG file.
bool IsJpeg(std::string_view file);

/// Reads a JPEG file, which is not trusted: each length in it is checked. Supports gray and coloured pictures of 8
/// bits, baseline and progressive, with any sampling. Does not support arithmetic coding, lossless files and CMYK. The
/// pixels are the same on every machine, because all computations use integers. Components with fewer samples are
/// enlarged by repeating samples, without interpolation.
JpegRead ReadJpeg(std::string_view file);

}  // namespace soarbox::picture
