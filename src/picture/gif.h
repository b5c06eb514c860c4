// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "picture/image.h"

namespace soarbox::picture {

/// Creates an animated GIF that repeats, one picture at a time. Each picture has its own palette of 255 colours.
/// Unchanged pixels need almost no space.
class GifMaker {
 public:
  /// All pictures have this size. `hundredths`: how long each is shown, in 1/100 s.
  GifMaker(int width, int height, int hundredths);
  /// Returns the bytes of the file for this picture. Those of the first picture include the beginning of the file.
  std::string Add(const Image& image);
  /// Returns the bytes at the end of the file.
  static std::string End();

 private:
  int width_, height_, hundredths_;
  Image before_;  ///< The previous picture; empty at first.
};

}  // namespace soarbox::picture
