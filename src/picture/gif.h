// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "picture/image.h"

namespace soarbox::picture {

/// Makes an animated GIF that repeats, picture by picture. Each picture has the 255 colours that suit it best; pixels
/// that stay as they were cost next to nothing.
class GifMaker {
 public:
  /// All pictures have this size. `hundredths` is how long each is shown, in 1/100 s.
  GifMaker(int width, int height, int hundredths);
  /// The bytes of the file that this picture adds; those of the first begin the file.
  std::string Add(const Image& image);
  /// The bytes that end the file.
  static std::string End();

 private:
  int width_, height_, hundredths_;
  Image before_;  ///< The picture before; empty at first.
};

}  // namespace soarbox::picture
