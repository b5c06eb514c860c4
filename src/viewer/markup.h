// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "world/scene_snapshot.h"

namespace soarbox::viewer {

/// A piece of text in one font and colour.
struct TextRun {
  std::string text;
  world::UiFont font = world::UiFont::kSmall;
  int palette_index = 0;     ///< 0..9
  bool fixed_width = false;  ///< %M: each character takes the font's fixed width.
};
using TextLine = std::vector<TextRun>;

/// Splits the sandbox's markup (lua_api.md section 10) into lines of runs. Like the sandbox, it skips the character
/// after an unknown command, and drops the remaining text after a font that does not exist.
std::vector<TextLine> ParseMarkup(std::string_view markup);

/// The line height of a font, in px.
float LineHeight(world::UiFont font);
/// The width of one character in fixed-width layout, in px.
float FixedWidth(world::UiFont font);

}  // namespace soarbox::viewer
