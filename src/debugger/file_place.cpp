// SPDX-License-Identifier: BSD-2-Clause
#include "debugger/file_place.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>

namespace soarbox::debugger {
namespace {

constexpr std::array<std::string_view, 3> kEndings{".soar", ".lua", ".toml"};

bool IsDecimal(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Names of files can contain most characters, but in messages they end at these.
bool EndsName(char c) {
  return std::string_view(" \t\r\n'\"()<>,;|").find(c) != std::string_view::npos;
}

}  // namespace

std::optional<FilePlace> FindFilePlace(std::string_view text) {
  for (std::size_t colon = text.find(':'); colon != std::string_view::npos; colon = text.find(':', colon + 1)) {
    const std::string_view before = text.substr(0, colon);
    const bool is_file = std::ranges::any_of(kEndings, [&](std::string_view end) { return before.ends_with(end); });
    if (!is_file || colon + 1 >= text.size() || !IsDecimal(text[colon + 1])) continue;
    FilePlace place;
    const auto from = std::find_if(before.rbegin(), before.rend(), EndsName);
    place.begin = static_cast<std::size_t>(before.rend() - from);
    place.file = before.substr(place.begin);
    const auto read = std::from_chars(text.data() + colon + 1, text.data() + text.size(), place.line);
    auto end = static_cast<std::size_t>(read.ptr - text.data());
    // The column is part of the marked text.
    if (end + 1 < text.size() && text[end] == ':' && IsDecimal(text[end + 1])) {
      ++end;
      while (end < text.size() && IsDecimal(text[end])) ++end;
    }
    place.length = end - place.begin;
    if (read.ec == std::errc()) return place;
  }
  return std::nullopt;
}

bool IsEditable(std::string_view file) {
  return file.ends_with(kEndings[0]) || file.ends_with(kEndings[1]);
}

}  // namespace soarbox::debugger
