// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/panels/text_capture.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <optional>

namespace soarbox::viewer {
namespace {

void AppendUtf8(std::string& text, unsigned code) {
  if (code < 0x80) {
    text.push_back(static_cast<char>(code));
  } else if (code < 0x800) {
    text.push_back(static_cast<char>(0xc0 | (code >> 6)));
    text.push_back(static_cast<char>(0x80 | (code & 0x3f)));
  } else {
    text.push_back(static_cast<char>(0xe0 | (code >> 12)));
    text.push_back(static_cast<char>(0x80 | ((code >> 6) & 0x3f)));
    text.push_back(static_cast<char>(0x80 | (code & 0x3f)));
  }
}

struct Letter {
  unsigned code;
  float pen, end, base;  ///< Left and right end of its cell, and the top of its line, px.
  float left, right, top, bottom, space, size;
};

/// Finds letters by the place of their glyph in the atlas.
class LetterFinder {
 public:
  explicit LetterFinder(const ImFontAtlas& fonts) {
    for (const ImFont* font : fonts.Fonts) {
      for (const ImFontGlyph& glyph : font->Glyphs) {
        if (glyph.Visible) letters_.try_emplace({glyph.U0, glyph.V0}, std::pair{font, &glyph});
      }
    }
  }

  std::optional<Letter> Find(const ImDrawVert& first, const ImDrawVert& last) const {
    const auto found = letters_.find({first.uv.x, first.uv.y});
    if (found == letters_.end()) return std::nullopt;
    const auto& [font, glyph] = found->second;
    const float width = glyph->X1 - glyph->X0;
    if (width <= 0 || last.pos.x <= first.pos.x) return std::nullopt;
    const float scale = (last.pos.x - first.pos.x) / width;
    Letter letter{};
    letter.code = glyph->Codepoint;
    letter.pen = first.pos.x - glyph->X0 * scale;
    letter.end = letter.pen + glyph->AdvanceX * scale;
    letter.base = first.pos.y - glyph->Y0 * scale;
    letter.left = first.pos.x;
    letter.right = last.pos.x;
    letter.top = first.pos.y;
    letter.bottom = last.pos.y;
    const ImFontGlyph* space = font->FindGlyphNoFallback(' ');
    letter.space = (space != nullptr ? space->AdvanceX : font->FontSize / 3) * scale;
    letter.size = font->FontSize * scale;
    return letter;
  }

 private:
  std::map<std::pair<float, float>, std::pair<const ImFont*, const ImFontGlyph*>> letters_;
};

/// Joins letters to runs.
class TextCollector {
 public:
  void Add(const Letter& letter, const ImVec4& clip) {
    constexpr float kMostSpaces = 2.6f;
    const float gap = letter.pen - pen_;
    const bool goes_on = has_run_ && std::abs(letter.base - base_) < 1.5f && gap > -0.5f * letter.space &&
                         gap < kMostSpaces * letter.space;
    if (!goes_on) Close();
    if (!has_run_) {
      has_run_ = true;
      base_ = letter.base;
      run_.top = letter.base;
      run_.bottom = letter.base + letter.size;
    } else {
      for (int spaces = static_cast<int>(std::lround(gap / letter.space)); spaces > 0; --spaces) Put(" ", pen_);
    }
    const bool seen = letter.right > clip.x + 0.5f && letter.left < clip.z - 0.5f && letter.bottom > clip.y + 0.5f &&
                      letter.top < clip.w - 0.5f;
    if (letter.left < clip.x - 1 || letter.right > clip.z + 1) run_.is_cut = run_.is_cut_x = true;
    if (letter.top < clip.y - 1 || letter.bottom > clip.w + 1) run_.is_cut = run_.is_cut_y = true;
    if (seen) {
      const ImVec4 box{std::max(letter.left, clip.x), std::max(letter.top, clip.y), std::min(letter.right, clip.z),
                       std::min(letter.bottom, clip.w)};
      ImVec4& all = run_.seen;
      all = any_seen_
                ? ImVec4{std::min(all.x, box.x), std::min(all.y, box.y), std::max(all.z, box.z), std::max(all.w, box.w)}
                : box;
      any_seen_ = true;
      std::string bytes;
      AppendUtf8(bytes, letter.code);
      Put(bytes, letter.pen);
    }
    pen_ = letter.end;
  }

  void Close() {
    if (has_run_ && any_seen_ && !run_.text.empty()) {
      while (!run_.text.empty() && run_.text.front() == ' ') {
        run_.text.erase(run_.text.begin());
        run_.at.erase(run_.at.begin());
      }
      run_.at.push_back(pen_);
      shown_.push_back(run_);
    }
    run_ = {};
    has_run_ = any_seen_ = false;
  }

  std::vector<ShownText> Take() {
    Close();
    return std::move(shown_);
  }

 private:
  void Put(std::string_view bytes, float at) {
    for (const char c : bytes) {
      run_.text.push_back(c);
      run_.at.push_back(at);
    }
  }

  std::vector<ShownText> shown_;
  ShownText run_;
  bool has_run_ = false, any_seen_ = false;
  float pen_ = 0, base_ = 0;
};

}  // namespace

std::vector<ShownText> CaptureText(const ImDrawData& drawn, const ImFontAtlas& fonts) {
  const LetterFinder finder(fonts);
  TextCollector collector;
  for (int n = 0; n < drawn.CmdListsCount; ++n) {
    const ImDrawList& list = *drawn.CmdLists[n];
    for (const ImDrawCmd& command : list.CmdBuffer) {
      ImVec4 clip = command.ClipRect;
      clip.x = std::max(clip.x, 0.0f);
      clip.y = std::max(clip.y, 0.0f);
      clip.z = std::min(clip.z, drawn.DisplaySize.x);
      clip.w = std::min(clip.w, drawn.DisplaySize.y);
      const ImDrawIdx* index = list.IdxBuffer.Data + command.IdxOffset;
      // A letter is a rectangle: two triangles, 0 1 2 0 2 3.
      for (unsigned i = 0; i + 6 <= command.ElemCount;) {
        const ImDrawIdx first = index[i], last = index[i + 2];
        const bool is_rectangle = index[i + 3] == first && index[i + 4] == last && index[i + 1] == first + 1 &&
                                  last == first + 2 && index[i + 5] == first + 3;
        const auto letter = is_rectangle ? finder.Find(list.VtxBuffer[static_cast<int>(command.VtxOffset + first)],
                                                       list.VtxBuffer[static_cast<int>(command.VtxOffset + last)])
                                         : std::nullopt;
        if (!letter) {
          i += 3;
          continue;
        }
        collector.Add(*letter, clip);
        i += 6;
      }
    }
    collector.Close();
  }
  return collector.Take();
}

TextPlace FindText(const std::vector<ShownText>& shown, std::string_view text, int number) {
  for (const ShownText& run : shown) {
    if (run.text == text && --number == 0) return {&run, 0};
  }
  for (const ShownText& run : shown) {
    if (run.text == text) continue;
    for (std::size_t at = run.text.find(text); at != std::string::npos; at = run.text.find(text, at + 1)) {
      if (--number == 0) return {&run, at};
    }
  }
  return {};
}

}  // namespace soarbox::viewer
