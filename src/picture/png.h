// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "picture/image.h"

namespace soarbox::picture {

/// Encodes the image as PNG: 8 bits per channel, no alpha.
std::string PngOf(const Image& image);

}  // namespace soarbox::picture
