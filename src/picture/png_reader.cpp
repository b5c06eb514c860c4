// SPDX-License-Identifier: BSD-2-Clause
#include "picture/png_reader.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdlib>

namespace soarbox::picture {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::size_t kFrame = 12;  // Length, kind and check of a chunk.
constexpr std::size_t kHead = 13;

enum ColorKind : std::uint8_t { kGray = 0, kRgb = 2, kPalette = 3, kGrayAlpha = 4, kRgba = 6 };

struct Head {
  std::uint32_t width = 0, height = 0;
  std::uint8_t bits = 0;
  ColorKind kind = kGray;

  std::size_t Channels() const {
    switch (kind) {
      case kRgb:
        return 3;
      case kGrayAlpha:
        return 2;
      case kRgba:
        return 4;
      default:
        return 1;
    }
  }
  std::size_t RowBytes() const { return (std::size_t{width} * Channels() * bits + 7) / 8; }
  /// Distance to the pixel on the left in the filters of rows.
  std::size_t Step() const { return std::max<std::size_t>(1, Channels() * bits / 8); }
};

std::uint8_t ByteAt(std::string_view bytes, std::size_t at) {
  return static_cast<std::uint8_t>(bytes[at]);
}

std::uint32_t NumberAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | ByteAt(bytes, at + i);
  return number;
}

/// The parts of a file; `problem` says what is wrong.
struct Parts {
  Head head;
  std::string packed;
  std::vector<std::array<std::uint8_t, 4>> palette;
  std::string transparent;
  std::string problem;
};

void ReadHead(std::string_view content, Parts& parts) {
  if (content.size() != kHead) {
    parts.problem = "its header has the wrong length";
    return;
  }
  Head& head = parts.head;
  head.width = NumberAt(content, 0);
  head.height = NumberAt(content, 4);
  head.bits = ByteAt(content, 8);
  const std::uint8_t kind = ByteAt(content, 9);
  if (head.width < 1 || head.height < 1 || head.width > kMostPngSide || head.height > kMostPngSide) {
    parts.problem = "an image has 1 to " + std::to_string(kMostPngSide) + " pixels on each side";
    return;
  }
  const bool is_known = kind == kGray || kind == kRgb || kind == kPalette || kind == kGrayAlpha || kind == kRgba;
  const bool is_small = head.bits == 1 || head.bits == 2 || head.bits == 4;
  if (!is_known || !(head.bits == 8 || (is_small && (kind == kGray || kind == kPalette)))) {
    parts.problem = head.bits == 16 ? "16 bits per channel are not read: save it with 8" : "its colour type is unknown";
    return;
  }
  if (ByteAt(content, 12) != 0) parts.problem = "interlaced images are not read: save it without interlacing";
  head.kind = static_cast<ColorKind>(kind);
}

Parts ReadParts(std::string_view file) {
  Parts parts;
  if (!file.starts_with(kSignature)) {
    parts.problem = "this is not a PNG file";
    return parts;
  }
  bool has_head = false;
  for (std::size_t at = kSignature.size(); parts.problem.empty();) {
    if (file.size() - at < kFrame) {
      parts.problem = "the file is cut off";
      break;
    }
    const std::size_t length = NumberAt(file, at);
    if (length > file.size() - at - kFrame) {
      parts.problem = "the file ends within a chunk";
      break;
    }
    const std::string_view kind = file.substr(at + 4, 4), content = file.substr(at + 8, length);
    at += kFrame + length;
    if (!has_head && kind != "IHDR") {
      parts.problem = "its first chunk is not a header";
    } else if (kind == "IHDR") {
      ReadHead(content, parts);
      has_head = true;
    } else if (kind == "PLTE") {
      for (std::size_t i = 0; i + 3 <= content.size() && parts.palette.size() < 256; i += 3)
        parts.palette.push_back({ByteAt(content, i), ByteAt(content, i + 1), ByteAt(content, i + 2), 255});
    } else if (kind == "tRNS") {
      parts.transparent = content;
    } else if (kind == "IDAT") {
      parts.packed.append(content);
    } else if (kind == "IEND") {
      break;
    }
  }
  return parts;
}

int PredictedByte(int left, int above, int corner) {
  const int to_left = std::abs(above - corner), to_above = std::abs(left - corner),
            to_corner = std::abs(left + above - 2 * corner);
  if (to_left <= to_above && to_left <= to_corner) return left;
  return to_above <= to_corner ? above : corner;
}

/// Undoes the filter of a row in place; `above` is null for the first one. False if there is no such filter.
bool Unfilter(std::uint8_t filter, std::uint8_t* row, const std::uint8_t* above, std::size_t bytes, std::size_t step) {
  if (filter > 4) return false;
  for (std::size_t i = 0; i < bytes; ++i) {
    const int left = i >= step ? row[i - step] : 0, up = above != nullptr ? above[i] : 0,
              corner = above != nullptr && i >= step ? above[i - step] : 0;
    int add = 0;
    if (filter == 1) add = left;
    if (filter == 2) add = up;
    if (filter == 3) add = (left + up) / 2;
    if (filter == 4) add = PredictedByte(left, up, corner);
    row[i] = static_cast<std::uint8_t>(row[i] + add);
  }
  return true;
}

/// The value of a channel that may have fewer than 8 bits.
std::uint8_t Sample(const std::uint8_t* row, const Head& head, std::size_t index) {
  if (head.bits == 8) return row[index];
  const std::size_t bit = index * head.bits;
  const int shift = static_cast<int>(8 - head.bits - bit % 8);
  return static_cast<std::uint8_t>(row[bit / 8] >> shift & ((1 << head.bits) - 1));
}

void PutRow(const Parts& parts, const std::uint8_t* row, std::uint8_t* out) {
  const Head& head = parts.head;
  const std::size_t channels = head.Channels();
  const int full = 255 / ((1 << head.bits) - 1);
  const auto clear_gray = parts.transparent.size() >= 2 ? ByteAt(parts.transparent, 1) : 256;
  for (std::size_t x = 0; x < head.width; ++x, out += 4) {
    const auto at = [&](std::size_t channel) { return Sample(row, head, x * channels + channel); };
    std::array<std::uint8_t, 4> color{0, 0, 0, 255};
    if (head.kind == kPalette) {
      const std::uint8_t index = at(0);
      if (index < parts.palette.size()) color = parts.palette[index];
      if (index < parts.transparent.size()) color[3] = ByteAt(parts.transparent, index);
    } else if (head.kind == kGray || head.kind == kGrayAlpha) {
      color[0] = color[1] = color[2] = static_cast<std::uint8_t>(at(0) * full);
      color[3] = head.kind == kGrayAlpha ? at(1) : at(0) == clear_gray ? 0 : 255;
    } else {
      for (std::size_t channel = 0; channel < channels; ++channel) color[channel] = at(channel);
      if (head.kind == kRgb && parts.transparent.size() >= 6 && color[0] == ByteAt(parts.transparent, 1) &&
          color[1] == ByteAt(parts.transparent, 3) && color[2] == ByteAt(parts.transparent, 5))
        color[3] = 0;
    }
    std::copy(color.begin(), color.end(), out);
  }
}

}  // namespace

PngRead ReadPng(std::string_view file) {
  Parts parts = ReadParts(file);
  const Head& head = parts.head;
  if (parts.problem.empty() && head.kind == kPalette && parts.palette.empty()) parts.problem = "it has no palette";
  if (!parts.problem.empty()) return {{}, parts.problem};
  const std::size_t row_bytes = head.RowBytes();
  std::vector<std::uint8_t> rows((row_bytes + 1) * head.height);
  auto size = static_cast<uLongf>(rows.size());
  const int result = uncompress(rows.data(), &size, reinterpret_cast<const Bytef*>(parts.packed.data()),
                                static_cast<uLong>(parts.packed.size()));
  if (result != Z_OK || size != rows.size()) return {{}, "its pixels are damaged"};
  PngRead read;
  read.pixels.width = static_cast<int>(head.width);
  read.pixels.height = static_cast<int>(head.height);
  read.pixels.rgba.resize(std::size_t{4} * head.width * head.height);
  std::uint8_t* above = nullptr;
  for (std::size_t y = 0; y < head.height; ++y) {
    std::uint8_t* const row = rows.data() + y * (row_bytes + 1);
    if (!Unfilter(row[0], row + 1, above, row_bytes, head.Step())) return {{}, "its pixels are damaged"};
    PutRow(parts, row + 1, read.pixels.rgba.data() + std::size_t{4} * head.width * y);
    above = row + 1;
  }
  return read;
}

}  // namespace soarbox::picture
