// SPDX-License-Identifier: BSD-2-Clause
#include "picture/jpeg_reader.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "picture/jpeg_bits.h"

namespace soarbox::picture {
namespace {

constexpr int kSide = 8, kArea = kSide * kSide;
constexpr int kMostDc = 32767;

/// Indices of coefficients in a block, in the order in which the file stores them.
constexpr std::array<std::uint8_t, kArea> kZigzag = {0,  1,  8,  16, 9,  2,  3,  10, 17, 24, 32, 25, 18, 11, 4,  5,
                                                     12, 19, 26, 33, 40, 48, 41, 34, 27, 20, 13, 6,  7,  14, 21, 28,
                                                     35, 42, 49, 56, 57, 50, 43, 36, 29, 22, 15, 23, 30, 37, 44, 51,
                                                     58, 59, 52, 45, 38, 31, 39, 46, 53, 60, 61, 54, 47, 55, 62, 63};

struct Component {
  int id = 0, across = 1, down = 1;  ///< `across`, `down`: number of its blocks in a unit.
  std::size_t quantizer = 0;
  int blocks_x = 0, blocks_y = 0;  ///< Number of its blocks, including the padding of the last units.
  std::size_t dc = 0, ac = 0;      ///< Indices of its Huffman tables in the current scan.
  int last_dc = 0;
  std::vector<std::int16_t> coefficients = {};
  std::vector<std::uint8_t> samples = {};

  std::int16_t* Block(int x, int y) {
    return coefficients.data() +
           (static_cast<std::size_t>(y) * static_cast<std::size_t>(blocks_x) + static_cast<std::size_t>(x)) * kArea;
  }
};

/// The coefficients that a scan stores: `first` to `last` of each block, without their lowest `low` bits. If `high` is
/// not 0, the scan adds one bit to the coefficients of earlier scans.
struct Scan {
  std::vector<Component*> components;
  int first = 0, last = kArea - 1, high = 0, low = 0;
};

/// 2048 times the cosine of `angle` * pi / 16. The value for angle 4 is also the factor of the constant term.
int Cosine(int angle) {
  constexpr int kQuarter[] = {2048, 2009, 1892, 1703, 1448, 1138, 784, 400, 0};
  angle %= 32;
  if (angle > 16) angle = 32 - angle;
  return angle > 8 ? -kQuarter[16 - angle] : kQuarter[angle];
}

/// The factors of the inverse cosine transform, by frequency and position.
const std::array<std::array<int, kSide>, kSide>& Waves() {
  static const auto waves = [] {
    std::array<std::array<int, kSide>, kSide> made{};
    for (int u = 0; u < kSide; ++u)
      for (int x = 0; x < kSide; ++x)
        made[static_cast<std::size_t>(u)][static_cast<std::size_t>(x)] = u == 0 ? Cosine(4) : Cosine((2 * x + 1) * u);
    return made;
  }();
  return waves;
}

std::uint8_t Clamped(std::int64_t value) {
  return static_cast<std::uint8_t>(std::clamp<std::int64_t>(value, 0, 255));
}

/// Computes the samples of a block from its coefficients with the inverse cosine transform: first columns, then rows.
void Transform(const std::int16_t* block, const std::array<std::uint16_t, kArea>& quantizer, std::uint8_t* to,
               std::size_t pitch) {
  const auto& waves = Waves();
  std::array<std::int64_t, kArea> columns{};
  for (std::size_t u = 0; u < kSide; ++u) {
    for (std::size_t v = 0; v < kSide; ++v) {
      const std::int64_t coefficient = std::int64_t{block[v * kSide + u]} * quantizer[v * kSide + u];
      if (coefficient == 0) continue;
      for (std::size_t y = 0; y < kSide; ++y) columns[y * kSide + u] += coefficient * waves[v][y];
    }
  }
  for (std::size_t y = 0; y < kSide; ++y) {
    for (std::size_t x = 0; x < kSide; ++x) {
      std::int64_t sum = 0;
      for (std::size_t u = 0; u < kSide; ++u) sum += columns[y * kSide + u] * waves[u][x];
      // Each of the two factors is half a cosine times 4096, so the sum is divided by 4096 * 4096.
      to[y * pitch + x] = Clamped(((sum + (std::int64_t{1} << 23)) >> 24) + 128);
    }
  }
}

class Reader {
 public:
  explicit Reader(std::string_view file) : file_(file) {}

  JpegRead Read() {
    if (!IsJpeg(file_)) Fail("this is not a JPEG file");
    at_ = 2;
    while (Goes() && ReadSegment()) {
    }
    if (Goes() && scans_ == 0) Fail("the file has no picture");
    JpegRead read;
    if (Goes()) read.pixels = Paint();
    read.problem = problem_;
    return read;
  }

 private:
  bool Goes() const { return problem_.empty(); }
  void Fail(const char* problem) {
    if (Goes()) problem_ = problem;
  }
  int Byte(std::size_t at) const { return at < file_.size() ? static_cast<unsigned char>(file_[at]) : 0; }
  int Word(std::size_t at) const { return Byte(at) << 8 | Byte(at + 1); }

  /// Reads the next marker and its segment. Returns false after the last one.
  bool ReadSegment() {
    while (at_ < file_.size() && Byte(at_) != 0xff) ++at_;
    while (at_ < file_.size() && Byte(at_) == 0xff) ++at_;
    if (at_ >= file_.size()) {
      // A file without an end marker is accepted if it contains a picture.
      if (scans_ == 0) Fail("the file ends before its picture");
      return false;
    }
    const int marker = Byte(at_++);
    constexpr int kEnd = 0xd9;
    if (marker == kEnd) return false;
    if (marker == 0 || marker == 1 || (marker >= 0xd0 && marker <= 0xd8)) return true;
    const auto length = static_cast<std::size_t>(Word(at_));
    if (length < 2 || at_ + length > file_.size()) {
      Fail("the file ends within a segment");
      return false;
    }
    const std::size_t begin = at_ + 2, end = at_ + length;
    at_ = end;
    ReadContent(marker, begin, end);
    return true;
  }

  void ReadContent(int marker, std::size_t begin, std::size_t end) {
    switch (marker) {
      case 0xc0:
      case 0xc1:
      case 0xc2:
        is_progressive_ = marker == 0xc2;
        return ReadFrame(begin, end);
      case 0xc4:
        return ReadCodes(begin, end);
      case 0xda:
        return ReadScan(begin, end);
      case 0xdb:
        return ReadQuantizers(begin, end);
      case 0xdd:
        restart_every_ = Word(begin);
        return;
      case 0xee:  // Adobe: specifies whether the components are red, green and blue.
        if (end - begin >= 12 && file_.substr(begin, 5) == "Adobe") is_rgb_ = Byte(begin + 11) == 0;
        return;
      default:
        if (marker >= 0xc3 && marker <= 0xcf && marker != 0xc8 && marker != 0xcc)
          Fail("it is lossless or arithmetically coded, which is not read: save it as an ordinary JPEG or as PNG");
    }
  }

  void ReadQuantizers(std::size_t begin, std::size_t end) {
    while (begin < end && Goes()) {
      const int what = Byte(begin++), bytes = what >> 4 != 0 ? 2 : 1;
      const auto table = static_cast<std::size_t>(what & 15);
      if (table >= quantizers_.size() || begin + static_cast<std::size_t>(bytes) * kArea > end)
        return Fail("a quantization table is damaged");
      for (const std::uint8_t place : kZigzag) {
        quantizers_[table][place] = static_cast<std::uint16_t>(bytes == 2 ? Word(begin) : Byte(begin));
        begin += static_cast<std::size_t>(bytes);
      }
    }
  }

  void ReadCodes(std::size_t begin, std::size_t end) {
    while (begin < end && Goes()) {
      if (begin + 17 > end) return Fail("a Huffman table is damaged");
      const int what = Byte(begin++);
      std::array<std::uint8_t, 16> counts{};
      std::size_t total = 0;
      for (std::uint8_t& count : counts) total += count = static_cast<std::uint8_t>(Byte(begin++));
      const auto table = static_cast<std::size_t>(what & 15);
      if (table >= 4 || what >> 4 > 1 || begin + total > end) return Fail("a Huffman table is damaged");
      std::vector<std::uint8_t> values;
      for (std::size_t i = 0; i < total; ++i) values.push_back(static_cast<std::uint8_t>(Byte(begin++)));
      if (!(what >> 4 == 0 ? dc_ : ac_)[table].Set(counts, std::move(values))) Fail("a Huffman table is damaged");
    }
  }

  void ReadFrame(std::size_t begin, std::size_t end) {
    if (!components_.empty()) return Fail("it has several pictures");
    if (end - begin < 6 || Byte(begin) != 8) return Fail("it does not have 8 bits per channel");
    height_ = Word(begin + 1);
    width_ = Word(begin + 3);
    const int count = Byte(begin + 5);
    if (width_ < 1 || height_ < 1 || width_ > kMostJpegSide || height_ > kMostJpegSide ||
        width_ * height_ > kMostJpegPixels)
      return Fail("it has no pixels, or more than 8 million, or more than 4096 on a side");
    if (count != 1 && count != 3)
      return Fail("it is neither gray nor of three colours (CMYK is not read): save it as RGB");
    if (end - begin < 6 + 3 * static_cast<std::size_t>(count)) return Fail("its frame is damaged");
    for (int i = 0; i < count; ++i) {
      const std::size_t at = begin + 6 + 3 * static_cast<std::size_t>(i);
      Component component{Byte(at), Byte(at + 1) >> 4, Byte(at + 1) & 15, static_cast<std::size_t>(Byte(at + 2))};
      if (component.across < 1 || component.across > 4 || component.down < 1 || component.down > 4 ||
          component.quantizer >= quantizers_.size())
        return Fail("its frame is damaged");
      most_across_ = std::max(most_across_, component.across);
      most_down_ = std::max(most_down_, component.down);
      components_.push_back(std::move(component));
    }
    if (count == 3) is_rgb_ |= components_[0].id == 'R' && components_[1].id == 'G' && components_[2].id == 'B';
    units_x_ = (width_ + most_across_ * kSide - 1) / (most_across_ * kSide);
    units_y_ = (height_ + most_down_ * kSide - 1) / (most_down_ * kSide);
    for (Component& component : components_) {
      component.blocks_x = units_x_ * component.across;
      component.blocks_y = units_y_ * component.down;
      component.coefficients.resize(static_cast<std::size_t>(component.blocks_x) *
                                    static_cast<std::size_t>(component.blocks_y) * kArea);
    }
  }

  void ReadScan(std::size_t begin, std::size_t end) {
    constexpr int kMostScans = 100;
    if (components_.empty()) return Fail("its picture has no frame");
    if (++scans_ > kMostScans) return Fail("it has too many scans");
    Scan scan;
    const int count = Byte(begin);
    if (count < 1 || count > static_cast<int>(components_.size()) ||
        end - begin < 4 + 2 * static_cast<std::size_t>(count))
      return Fail("a scan is damaged");
    for (int i = 0; i < count; ++i) {
      const std::size_t at = begin + 1 + 2 * static_cast<std::size_t>(i);
      const auto found = std::ranges::find(components_, Byte(at), &Component::id);
      if (found == components_.end()) return Fail("a scan is damaged");
      found->dc = static_cast<std::size_t>(Byte(at + 1) >> 4);
      found->ac = static_cast<std::size_t>(Byte(at + 1) & 15);
      if (found->dc >= 4 || found->ac >= 4) return Fail("a scan is damaged");
      scan.components.push_back(&*found);
    }
    if (is_progressive_) {
      const std::size_t at = begin + 1 + 2 * static_cast<std::size_t>(count);
      scan.first = Byte(at);
      scan.last = Byte(at + 1);
      scan.high = Byte(at + 2) >> 4;
      scan.low = Byte(at + 2) & 15;
      if (scan.first > scan.last || scan.last >= kArea || scan.low > 13 || (scan.first > 0 && count > 1) ||
          (scan.first == 0 && scan.last > 0))
        return Fail("a scan is damaged");
    }
    for (const Component* component : scan.components) {
      const bool needs_dc = scan.first == 0 && scan.high == 0, needs_ac = scan.last > 0;
      if ((needs_dc && !dc_[component->dc].is_set()) || (needs_ac && !ac_[component->ac].is_set()))
        return Fail("a scan has no Huffman table");
    }
    Decode(scan);
  }

  /// Decodes the data of a scan, unit by unit. A scan of a single component contains only the blocks that the picture
  /// covers.
  void Decode(const Scan& scan) {
    JpegBits bits(file_, at_);
    const bool is_alone = scan.components.size() == 1;
    Component& first = *scan.components.front();
    const auto needed = [](int length, int part, int most) {
      return (length * part + most * kSide - 1) / (most * kSide);
    };
    const int across = is_alone ? needed(width_, first.across, most_across_) : units_x_;
    const int down = is_alone ? needed(height_, first.down, most_down_) : units_y_;
    empty_blocks_ = 0;
    for (Component* component : scan.components) component->last_dc = 0;
    for (int unit = 0; unit < across * down; ++unit) {
      if (bits.IsOver()) return Fail("the file ends within its picture");
      if (restart_every_ > 0 && unit > 0 && unit % restart_every_ == 0) {
        bits.Restart();
        empty_blocks_ = 0;
        for (Component* component : scan.components) component->last_dc = 0;
      }
      const int x = unit % across, y = unit / across;
      if (is_alone) {
        DecodeBlock(scan, first, first.Block(x, y), bits);
        continue;
      }
      for (Component* component : scan.components)
        for (int v = 0; v < component->down; ++v)
          for (int u = 0; u < component->across; ++u)
            DecodeBlock(scan, *component, component->Block(x * component->across + u, y * component->down + v), bits);
    }
    at_ = bits.at();
  }

  void DecodeBlock(const Scan& scan, Component& component, std::int16_t* block, JpegBits& bits) {
    if (scan.first == 0) {
      if (scan.high == 0) {
        const int change = bits.Signed(std::min(bits.Value(dc_[component.dc]), 15));
        component.last_dc = std::clamp(component.last_dc + change, -kMostDc, kMostDc);
        block[0] = static_cast<std::int16_t>(component.last_dc * (1 << scan.low));
      } else if (bits.Bit() != 0) {
        block[0] = static_cast<std::int16_t>(block[0] | 1 << scan.low);
      }
    }
    if (scan.last == 0) return;
    scan.high == 0 ? DecodeFirst(scan, component, block, bits) : Refine(scan, component, block, bits);
  }

  void DecodeFirst(const Scan& scan, const Component& component, std::int16_t* block, JpegBits& bits) {
    if (empty_blocks_ > 0) {
      --empty_blocks_;
      return;
    }
    for (int k = std::max(scan.first, 1); k <= scan.last; ++k) {
      const int code = bits.Value(ac_[component.ac]), zeros = code >> 4, size = code & 15;
      if (size == 0) {
        if (zeros == 15) {
          k += 15;
          continue;
        }
        // The rest of this block is zero, and so are the next `empty_blocks_` blocks.
        empty_blocks_ = is_progressive_ ? (1 << zeros) - 1 + bits.Bits(zeros) : 0;
        return;
      }
      k += zeros;
      const int value = bits.Signed(size);
      if (k <= scan.last)
        block[kZigzag[static_cast<std::size_t>(k)]] = static_cast<std::int16_t>(value * (1 << scan.low));
    }
  }

  /// Adds a bit to each coefficient that is not zero, and reads new coefficients.
  void Refine(const Scan& scan, const Component& component, std::int16_t* block, JpegBits& bits) {
    const auto bit = static_cast<std::int16_t>(1 << scan.low);
    const auto correct = [&](std::int16_t& value) {
      if (bits.Bit() != 0 && (value & bit) == 0)
        value = static_cast<std::int16_t>(value > 0 ? value + bit : value - bit);
    };
    int k = scan.first;
    if (empty_blocks_ == 0) {
      for (; k <= scan.last; ++k) {
        const int code = bits.Value(ac_[component.ac]);
        int zeros = code >> 4;
        std::int16_t value = 0;
        if ((code & 15) != 0) {
          value = bits.Bit() != 0 ? bit : static_cast<std::int16_t>(-bit);
        } else if (zeros < 15) {
          empty_blocks_ = (1 << zeros) + bits.Bits(zeros);
          break;
        }
        for (; k <= scan.last; ++k) {
          std::int16_t& old = block[kZigzag[static_cast<std::size_t>(k)]];
          if (old != 0) {
            correct(old);
          } else if (zeros-- == 0) {
            old = value;
            break;
          }
        }
      }
    }
    if (empty_blocks_ == 0) return;
    for (; k <= scan.last; ++k)
      if (std::int16_t& old = block[kZigzag[static_cast<std::size_t>(k)]]; old != 0) correct(old);
    --empty_blocks_;
  }

  Pixels Paint() {
    for (Component& component : components_) {
      const std::size_t pitch = static_cast<std::size_t>(component.blocks_x) * kSide;
      component.samples.resize(pitch * static_cast<std::size_t>(component.blocks_y) * kSide);
      for (int y = 0; y < component.blocks_y; ++y)
        for (int x = 0; x < component.blocks_x; ++x)
          Transform(component.Block(x, y), quantizers_[component.quantizer],
                    component.samples.data() + static_cast<std::size_t>(y) * kSide * pitch +
                        static_cast<std::size_t>(x) * kSide,
                    pitch);
      component.coefficients = {};
    }
    Pixels pixels{width_, height_, {}};
    pixels.rgba.reserve(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) AddPixel(x, y, pixels.rgba);
    return pixels;
  }

  void AddPixel(int x, int y, std::vector<std::uint8_t>& rgba) const {
    const auto sample = [&](const Component& component) -> std::int64_t {
      const int u = x * component.across / most_across_, v = y * component.down / most_down_;
      return component.samples[static_cast<std::size_t>(v) * static_cast<std::size_t>(component.blocks_x) * kSide +
                               static_cast<std::size_t>(u)];
    };
    const std::int64_t light = sample(components_[0]);
    if (components_.size() == 1 || is_rgb_) {
      const bool is_gray = components_.size() == 1;
      const auto green = is_gray ? light : sample(components_[1]), blue = is_gray ? light : sample(components_[2]);
      rgba.insert(rgba.end(), {Clamped(light), Clamped(green), Clamped(blue), 255});
      return;
    }
    // Converts the colours of JFIF to RGB. The factors are multiplied by 65536.
    constexpr std::int64_t kHalf = 1 << 15;
    const std::int64_t cb = sample(components_[1]) - 128, cr = sample(components_[2]) - 128;
    rgba.insert(rgba.end(), {Clamped(light + ((91881 * cr + kHalf) >> 16)),
                             Clamped(light - ((22554 * cb + 46802 * cr + kHalf) >> 16)),
                             Clamped(light + ((116130 * cb + kHalf) >> 16)), 255});
  }

  std::string_view file_;
  std::size_t at_ = 0;
  std::string problem_;
  std::array<std::array<std::uint16_t, kArea>, 4> quantizers_{};
  std::array<JpegCodes, 4> dc_, ac_;
  std::vector<Component> components_;
  int width_ = 0, height_ = 0, most_across_ = 1, most_down_ = 1, units_x_ = 0, units_y_ = 0;
  int restart_every_ = 0, scans_ = 0;
  int empty_blocks_ = 0;  ///< Number of following blocks of the scan without new coefficients.
  bool is_progressive_ = false, is_rgb_ = false;
};

}  // namespace

bool IsJpeg(std::string_view file) {
  return file.starts_with("\xff\xd8\xff");
}

JpegRead ReadJpeg(std::string_view file) {
  return Reader(file).Read();
}

}  // namespace soarbox::picture
