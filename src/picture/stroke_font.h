// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "picture/image.h"

namespace soarbox::picture {

/// Width of a text in pixels, for capitals of height `height_px`. A character that is not ASCII counts as one unknown
/// character.
float TextWidth(std::string_view text, float height_px);

/// Draws a line of text that begins at (x, base_y) on the baseline. Letters are strokes, so any size is smooth.
/// Characters that are not ASCII are drawn as boxes.
void WriteText(Image& image, float x, float base_y, float height_px, std::string_view text, Ink ink, float width_px);

}  // namespace soarbox::picture
