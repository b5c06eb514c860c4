// SPDX-License-Identifier: BSD-2-Clause
#include "picture/png.h"

#include <zlib.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace soarbox::picture {
namespace {

constexpr std::size_t kChannels = 3;

void AddNumber(std::string& out, std::uint32_t number) {
  for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(number >> shift & 0xff);
}

void AddChunk(std::string& out, std::string_view kind, std::string_view content) {
  AddNumber(out, static_cast<std::uint32_t>(content.size()));
  const std::size_t from = out.size();
  out.append(kind).append(content);
  const auto* const bytes = reinterpret_cast<const Bytef*>(out.data() + from);
  AddNumber(out, static_cast<std::uint32_t>(crc32(0, bytes, static_cast<uInt>(out.size() - from))));
}

/// The one of three neighbours that is nearest to left + above - corner (the Paeth predictor of the standard).
int Predicted(int left, int above, int corner) {
  const int to_left = std::abs(above - corner), to_above = std::abs(left - corner),
            to_corner = std::abs(left + above - 2 * corner);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : corner;
}

/// Each row after the number of its filter, as differences from predicted values.
std::string FilteredRows(const Image& image) {
  constexpr char kPaeth = 4;
  const std::size_t row = kChannels * static_cast<std::size_t>(image.width);
  std::string rows;
  rows.reserve((row + 1) * static_cast<std::size_t>(image.height));
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
    const std::uint8_t* const here = image.rgb.data() + y * row;
    const std::uint8_t* const above = y > 0 ? here - row : nullptr;
    rows += kPaeth;
    for (std::size_t i = 0; i < row; ++i) {
      const int left = i >= kChannels ? here[i - kChannels] : 0, up = above != nullptr ? above[i] : 0,
                corner = above != nullptr && i >= kChannels ? above[i - kChannels] : 0;
      rows += static_cast<char>(here[i] - Predicted(left, up, corner));
    }
  }
  return rows;
}

std::string Packed(const std::string& bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::string packed(size, '\0');
  constexpr int kLevel = 6;
  compress2(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
            static_cast<uLong>(bytes.size()), kLevel);
  packed.resize(size);
  return packed;
}

}  // namespace

std::string PngOf(const Image& image) {
  std::string head;
  AddNumber(head, static_cast<std::uint32_t>(image.width));
  AddNumber(head, static_cast<std::uint32_t>(image.height));
  // 8 bits, RGB without alpha, the only compression and filter methods, no interlacing.
  head += std::string_view("\x08\x02\x00\x00\x00", 5);
  std::string out = "\x89PNG\r\n\x1a\n";
  AddChunk(out, "IHDR", head);
  AddChunk(out, "IDAT", Packed(FilteredRows(image)));
  AddChunk(out, "IEND", {});
  return out;
}

}  // namespace soarbox::picture
