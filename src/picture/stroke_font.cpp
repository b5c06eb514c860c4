// SPDX-License-Identifier: BSD-2-Clause
#include "picture/stroke_font.h"

#include <array>
#include <cstddef>

namespace soarbox::picture {
namespace {

/// A character: its width and its strokes. A point is two digits, x and y, on a grid: y = 2 is the baseline, 6 the
/// height of small letters and 8 that of capitals. A slash begins another stroke.
struct Glyph {
  int width;
  const char* strokes;
};

constexpr float kBase = 2, kCapital = 6, kGap = 1;

/// From space to tilde, in the order of ASCII.
constexpr std::array<Glyph, 95> kGlyphs = {{
    {4, ""},
    {2, "18 14/12 13"},
    {3, "08 06/28 26"},
    {6, "17 13/47 43/06 56/04 54"},
    {6, "57 47 17 06 15 45 54 43 13 03/38 32"},
    {6, "58 02/07 18 17 07/53 43 42 53"},
    {6, "52 17 18 28 37 04 03 12 32 54"},
    {1, "08 06"},
    {3, "28 06 04 22"},
    {3, "08 26 24 02"},
    {4, "27 23/06 44/04 46"},
    {5, "27 23/05 45"},
    {2, "13 12 01"},
    {4, "05 35"},
    {2, "12 13"},
    {5, "02 48"},
    {5, "18 38 47 43 32 12 03 07 18/47 03"},
    {4, "06 28 22/02 42"},
    {5, "07 18 38 47 46 02 42"},
    {5, "08 48 25 35 44 43 32 12 03"},
    {5, "32 38 04 44"},
    {5, "48 08 05 35 44 43 32 02"},
    {5, "48 28 06 03 12 32 43 44 35 05"},
    {5, "08 48 12"},
    {5, "15 06 07 18 38 47 46 35 15 04 03 12 32 43 44 35"},
    {5, "45 15 06 07 18 38 47 44 22 02"},
    {2, "13 12/16 15"},
    {2, "16 15/13 12 01"},
    {5, "47 05 43"},
    {5, "06 46/04 44"},
    {5, "07 45 03"},
    {5, "07 18 38 47 46 24/22 23"},
    {6, "44 35 25 24 34 44 55 57 38 18 07 03 12 42"},
    {5, "02 28 42/04 44"},
    {5, "02 08 38 47 46 35 44 43 32 02/05 35"},
    {5, "47 38 18 07 03 12 32 43"},
    {5, "02 08 28 46 44 22 02"},
    {5, "48 08 02 42/05 35"},
    {5, "48 08 02/05 35"},
    {5, "47 38 18 07 03 12 32 43 45 25"},
    {5, "08 02/48 42/05 45"},
    {3, "08 28/18 12/02 22"},
    {4, "38 33 22 12 03"},
    {5, "08 02/48 05 42"},
    {4, "08 02 32"},
    {7, "02 08 35 68 62"},
    {5, "02 08 42 48"},
    {5, "18 38 47 43 32 12 03 07 18"},
    {5, "02 08 38 47 46 35 05"},
    {5, "18 38 47 43 32 12 03 07 18/24 41"},
    {5, "02 08 38 47 46 35 05/25 42"},
    {5, "47 38 18 07 06 44 43 32 12 03"},
    {5, "08 48/28 22"},
    {5, "08 03 12 32 43 48"},
    {5, "08 22 48"},
    {7, "08 12 36 52 68"},
    {5, "08 42/02 48"},
    {5, "08 25 48/25 22"},
    {5, "08 48 02 42"},
    {3, "28 08 02 22"},
    {5, "08 42"},
    {3, "08 28 22 02"},
    {5, "06 28 46"},
    {5, "01 41"},
    {2, "08 17"},
    {4, "06 26 35 32/34 14 03 12 22 33"},
    {4, "08 02 22 33 35 26 06"},
    {4, "36 16 05 03 12 32"},
    {4, "38 32 12 03 05 16 36"},
    {4, "04 34 35 26 16 05 03 12 32"},
    {3, "38 28 17 12/06 36"},
    {4, "36 31 20 00/36 16 05 03 12 32"},
    {4, "08 02/05 16 26 35 32"},
    {1, "02 06/08 07"},
    {2, "16 11 00/18 17"},
    {4, "08 02/36 04 32"},
    {2, "08 03 12"},
    {7, "02 06 26 35 32/35 46 56 65 62"},
    {4, "02 06/05 16 26 35 32"},
    {4, "16 26 35 33 22 12 03 05 16"},
    {4, "00 06 26 35 33 22 02"},
    {4, "30 36 16 05 03 12 32"},
    {4, "02 06/05 16 36"},
    {4, "36 16 05 33 22 02"},
    {3, "18 13 22 32/06 36"},
    {4, "06 03 12 22 33/36 32"},
    {5, "06 22 46"},
    {7, "06 12 35 52 66"},
    {4, "06 32/02 36"},
    {5, "06 22/46 22 10 00"},
    {4, "06 36 02 32"},
    {3, "28 17 16 05 14 13 22"},
    {1, "08 00"},
    {3, "08 17 16 25 14 13 02"},
    {5, "04 15 34 45"},
}};
constexpr Glyph kUnknown = {4, "02 08 38 32 02"};

/// Calls `see(glyph)` for each character.
template <typename See>
void ForEachGlyph(std::string_view text, See see) {
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80 && code < 0xc0) continue;  // A continuation byte of a character.
    const bool is_known = code >= ' ' && code <= '~';
    see(is_known ? kGlyphs[static_cast<std::size_t>(code - ' ')] : kUnknown);
  }
}

}  // namespace

float TextWidth(std::string_view text, float height_px) {
  float width = 0;
  ForEachGlyph(text, [&](const Glyph& glyph) { width += static_cast<float>(glyph.width) + kGap; });
  return width > 0 ? (width - kGap) * height_px / kCapital : 0;
}

void WriteText(Image& image, float x, float base_y, float height_px, std::string_view text, Ink ink, float width_px) {
  const float unit = height_px / kCapital;
  ForEachGlyph(text, [&](const Glyph& glyph) {
    bool has_before = false;
    float before_x = 0, before_y = 0;
    for (const char* at = glyph.strokes; *at != 0; ++at) {
      if (*at == ' ') continue;
      if (*at == '/') {
        has_before = false;
        continue;
      }
      const float here_x = x + static_cast<float>(at[0] - '0') * unit;
      const float here_y = base_y - (static_cast<float>(at[1] - '0') - kBase) * unit;
      if (has_before) image.Line(before_x, before_y, here_x, here_y, width_px, ink);
      before_x = here_x;
      before_y = here_y;
      has_before = true;
      ++at;
    }
    x += (static_cast<float>(glyph.width) + kGap) * unit;
  });
}

}  // namespace soarbox::picture
