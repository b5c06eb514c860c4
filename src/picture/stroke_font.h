// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string_view>

#include "picture/image.h"

namespace soarbox::picture {

/// How wide a text is, in pixels, if its capitals are `height_px` high. Each byte above 0x7f that begins a character
/// counts as one unknown character.
float TextWidth(std::string_view text, float height_px);

/// Writes a line of text from its left end on the base line. Letters are strokes, so any size is smooth. Characters
/// other than those of ASCII are drawn as boxes.
void WriteText(Image& image, float x, float base_y, float height_px, std::string_view text, Ink ink, float width_px);

}  // namespace soarbox::picture
