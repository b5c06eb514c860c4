// SPDX-License-Identifier: BSD-2-Clause
#include "picture/gif.h"

#include <algorithm>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace soarbox::picture {
namespace {

constexpr std::size_t kMostColors = 255;
constexpr std::uint8_t kUnchanged = 255;  ///< The transparent entry of each palette.
constexpr int kBitsKept = 5, kCells = 1 << (3 * kBitsKept);

void AddShort(std::string& out, int number) {
  out += static_cast<char>(number & 0xff);
  out += static_cast<char>(number >> 8 & 0xff);
}

/// Index of the cell that contains the colour of a pixel. The colour space is divided into 32,768 cells.
int CellOf(const std::uint8_t* pixel) {
  constexpr int kDropped = 8 - kBitsKept;
  return (pixel[0] >> kDropped) << (2 * kBitsKept) | (pixel[1] >> kDropped) << kBitsKept | pixel[2] >> kDropped;
}

int ChannelOf(int cell, int channel) {
  return cell >> ((2 - channel) * kBitsKept) & ((1 << kBitsKept) - 1);
}

/// Cells that share one colour of the palette.
struct Group {
  std::vector<int> cells;
  std::uint64_t pixels = 0;
  int channel = 0, spread = 0;  ///< The channel with the largest spread of the cells, and that spread.
};

Group GroupOf(std::vector<int> cells, const std::vector<std::uint32_t>& counts) {
  Group group;
  for (const int cell : cells) group.pixels += counts[static_cast<std::size_t>(cell)];
  for (int channel = 0; channel < 3; ++channel) {
    int least = 1 << kBitsKept, most = 0;
    for (const int cell : cells) {
      least = std::min(least, ChannelOf(cell, channel));
      most = std::max(most, ChannelOf(cell, channel));
    }
    if (most - least > group.spread) {
      group.spread = most - least;
      group.channel = channel;
    }
  }
  group.cells = std::move(cells);
  return group;
}

/// Repeatedly halves the group for which a split helps most (median cut).
std::vector<Group> GroupsOf(const std::vector<std::uint32_t>& counts) {
  std::vector<int> used;
  for (int cell = 0; cell < kCells; ++cell)
    if (counts[static_cast<std::size_t>(cell)] > 0) used.push_back(cell);
  std::vector<Group> groups;
  groups.push_back(GroupOf(std::move(used), counts));
  while (groups.size() < kMostColors) {
    const auto worth = [](const Group& group) { return group.pixels * static_cast<std::uint64_t>(group.spread); };
    const auto widest =
        std::ranges::max_element(groups, [&](const Group& a, const Group& b) { return worth(a) < worth(b); });
    if (widest->spread == 0) break;
    std::vector<int> cells = std::move(widest->cells);
    const int channel = widest->channel;
    std::ranges::stable_sort(cells, [&](int a, int b) { return ChannelOf(a, channel) < ChannelOf(b, channel); });
    std::uint64_t below = 0;
    std::size_t middle = 0;
    while (middle + 1 < cells.size() && below * 2 < widest->pixels)
      below += counts[static_cast<std::size_t>(cells[middle++])];
    const auto cut = cells.begin() + static_cast<std::ptrdiff_t>(std::max<std::size_t>(middle, 1));
    *widest = GroupOf({cells.begin(), cut}, counts);
    groups.push_back(GroupOf({cut, cells.end()}, counts));
  }
  return groups;
}

struct Indexed {
  std::string palette;               ///< 256 colours of three bytes.
  std::vector<std::uint8_t> pixels;  ///< Their indices in the palette.
};

Indexed IndexedOf(const Image& image, const Image& before) {
  const std::size_t count = image.rgb.size() / 3;
  std::vector<bool> is_same(count, false);
  std::vector<std::uint32_t> counts(kCells);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const pixel = &image.rgb[3 * i];
    is_same[i] = !before.rgb.empty() && std::equal(pixel, pixel + 3, &before.rgb[3 * i]);
    if (!is_same[i]) ++counts[static_cast<std::size_t>(CellOf(pixel))];
  }
  const std::vector<Group> groups = GroupsOf(counts);
  std::vector<std::uint8_t> number_of(kCells, 0);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const int cell : groups[g].cells) number_of[static_cast<std::size_t>(cell)] = static_cast<std::uint8_t>(g);
  Indexed made;
  std::vector<std::array<std::uint64_t, 4>> sums(kMostColors + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* const pixel = &image.rgb[3 * i];
    const std::uint8_t number = is_same[i] ? kUnchanged : number_of[static_cast<std::size_t>(CellOf(pixel))];
    made.pixels.push_back(number);
    if (is_same[i]) continue;
    for (std::size_t channel = 0; channel < 3; ++channel) sums[number][channel] += pixel[channel];
    ++sums[number][3];
  }
  for (const auto& sum : sums)
    for (std::size_t channel = 0; channel < 3; ++channel)
      made.palette += static_cast<char>(sum[3] > 0 ? (sum[channel] + sum[3] / 2) / sum[3] : 0);
  return made;
}

/// Writes codes of a few bits, lowest bits first, in blocks of up to 255 bytes that begin with their length.
class BitBlocks {
 public:
  void Add(unsigned code, int bits) {
    waiting_ |= code << count_;
    for (count_ += bits; count_ >= 8; count_ -= 8, waiting_ >>= 8) bytes_ += static_cast<char>(waiting_ & 0xff);
  }
  std::string Take() {
    if (count_ > 0) bytes_ += static_cast<char>(waiting_ & 0xff);
    std::string out;
    constexpr std::size_t kMost = 255;
    for (std::size_t at = 0; at < bytes_.size(); at += kMost) {
      const std::string part = bytes_.substr(at, kMost);
      out += static_cast<char>(part.size());
      out += part;
    }
    return out + '\0';
  }

 private:
  std::string bytes_;
  unsigned waiting_ = 0;
  int count_ = 0;
};

/// Compresses 8-bit codes in the format of GIF (Lempel-Ziv-Welch).
std::string PackedLzw(const std::vector<std::uint8_t>& pixels) {
  constexpr unsigned kClear = 256, kEnd = 257, kMostCodes = 4096;
  constexpr int kFirstBits = 9;
  BitBlocks out;
  std::unordered_map<unsigned, unsigned> known;  // A code and the pixel after it.
  unsigned next = kEnd + 1;
  int bits = kFirstBits;
  out.Add(kClear, bits);
  unsigned code = pixels.front();
  for (std::size_t i = 1; i < pixels.size(); ++i) {
    const unsigned longer = code << 8 | pixels[i];
    if (const auto at = known.find(longer); at != known.end()) {
      code = at->second;
      continue;
    }
    out.Add(code, bits);
    code = pixels[i];
    if (next == kMostCodes) {
      out.Add(kClear, bits);
      known.clear();
      next = kEnd + 1;
      bits = kFirstBits;
      continue;
    }
    if (next == 1u << bits) ++bits;
    known[longer] = next++;
  }
  out.Add(code, bits);
  if (next == 1u << bits && bits < 12) ++bits;
  out.Add(kEnd, bits);
  return out.Take();
}

}  // namespace

GifMaker::GifMaker(int width, int height, int hundredths) : width_(width), height_(height), hundredths_(hundredths) {}

std::string GifMaker::Add(const Image& image) {
  std::string out;
  if (before_.rgb.empty()) {
    out = "GIF89a";
    AddShort(out, width_);
    AddShort(out, height_);
    out += std::string_view("\x70\x00\x00", 3);  // No global palette.
    // Repeats forever.
    out += std::string_view("\x21\xff\x0bNETSCAPE2.0\x03\x01\x00\x00\x00", 19);
  }
  const Indexed indexed = IndexedOf(image, before_);
  // Keep pixels that are not drawn; duration; index of the transparent colour.
  out += std::string_view("\x21\xf9\x04\x05", 4);
  AddShort(out, hundredths_);
  out += static_cast<char>(kUnchanged);
  out += std::string_view("\x00\x2c\x00\x00\x00\x00", 6);
  AddShort(out, width_);
  AddShort(out, height_);
  out += '\x87';  // A local palette of 256 colours.
  out += indexed.palette;
  out += '\x08';
  out += PackedLzw(indexed.pixels);
  before_ = image;
  return out;
}

std::string GifMaker::End() {
  return ";";
}

}  // namespace soarbox::picture
