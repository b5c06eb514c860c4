// SPDX-License-Identifier: BSD-2-Clause
#include "viewer/markup.h"

#include <optional>

namespace soarbox::viewer {
namespace {

using world::UiFont;

std::optional<UiFont> FontByNumber(std::string_view number) {
  if (number == "9") return UiFont::kSmall;
  if (number == "91") return UiFont::kSmallMono;
  if (number == "14") return UiFont::kMedium;
  if (number == "141") return UiFont::kMediumMono;
  if (number == "24") return UiFont::kLarge;
  if (number == "241") return UiFont::kLargeMono;
  return std::nullopt;
}

}  // namespace

std::vector<TextLine> ParseMarkup(std::string_view markup) {
  std::vector<TextLine> lines(1);
  TextRun run;
  const auto flush = [&] {
    if (!run.text.empty()) lines.back().push_back(run);
    run.text.clear();
  };
  for (std::size_t i = 0; i < markup.size(); ++i) {
    const char c = markup[i];
    if (c == '\n') {
      flush();
      // An empty line has the height of the current font.
      if (lines.back().empty()) lines.back().push_back(run);
      lines.emplace_back();
      continue;
    }
    if (c != '%') {
      if (c != '\r') run.text.push_back(c == '\t' ? ' ' : c);
      continue;
    }
    if (++i == markup.size()) break;
    const char command = markup[i];
    if (command == '%') {
      run.text.push_back('%');
    } else if (command >= '0' && command <= '9') {
      flush();
      run.palette_index = command - '0';
    } else if (command == 'R' || command == 'r') {
      flush();
      run.palette_index = 0;
    } else if (command == 'M' || command == 'm') {
      flush();
      run.fixed_width = !run.fixed_width;
    } else if (command == '@' || command == ':') {
      const std::size_t end = markup.find('%', i + 1);
      if (end == std::string_view::npos) break;
      if (command == '@') {
        const auto font = FontByNumber(markup.substr(i + 1, end - i - 1));
        if (!font) break;
        flush();
        run.font = *font;
      }
      i = end;
    }
  }
  flush();
  return lines;
}

float LineHeight(UiFont font) {
  switch (font) {
    case UiFont::kSmall:
    case UiFont::kSmallMono:
      return 14;
    case UiFont::kMedium:
    case UiFont::kMediumMono:
      return 22;
    case UiFont::kLarge:
    case UiFont::kLargeMono:
      break;
  }
  return 38;
}

float FixedWidth(UiFont font) {
  switch (font) {
    case UiFont::kSmall:
      return 13;
    case UiFont::kSmallMono:
      return 8;
    case UiFont::kMedium:
      return 20;
    case UiFont::kMediumMono:
      return 11;
    case UiFont::kLarge:
      return 34;
    case UiFont::kLargeMono:
      break;
  }
  return 20;
}

}  // namespace soarbox::viewer
