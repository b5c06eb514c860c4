// SPDX-License-Identifier: BSD-2-Clause
#include "world/wav_file.h"

#include <cstddef>
#include <cstdint>

namespace soarbox::world {
namespace {

std::uint32_t LittleEndian(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t number = 0;
  for (std::size_t i = count; i-- > 0;) number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
  return number;
}

/// Returns why this format cannot be played; empty if it can.
std::string WhyNotPlayed(std::string_view format) {
  if (format.size() < 16) return "its format is cut off";
  const std::uint32_t kind = LittleEndian(format, 0, 2), channels = LittleEndian(format, 2, 2),
                      rate = LittleEndian(format, 4, 4), bits = LittleEndian(format, 14, 2);
  if (kind != 1 || (bits != 8 && bits != 16)) return "its samples are not PCM with 8 or 16 bits: save it as PCM";
  if (channels < 1 || channels > 2) return "it has " + std::to_string(channels) + " channels; one or two are played";
  if (rate < 8000 || rate > 48000)
    return "it has " + std::to_string(rate) + " samples a second; 8,000 to 48,000 are played";
  return {};
}

}  // namespace

std::string WhyNoWav(std::string_view file) {
  if (file.size() < 12 || !file.starts_with("RIFF") || file.substr(8, 4) != "WAVE") return "this is not a WAV file";
  bool has_format = false;
  for (std::size_t at = 12; file.size() - at >= 8;) {
    const std::string_view kind = file.substr(at, 4);
    const std::size_t length = LittleEndian(file, at + 4, 4);
    at += 8;
    if (length > file.size() - at) return "the file is cut off";
    if (kind == "fmt ") {
      if (std::string why = WhyNotPlayed(file.substr(at, length)); !why.empty()) return why;
      has_format = true;
    } else if (kind == "data") {
      return !has_format ? "its samples come before their format" : length == 0 ? "it has no samples" : "";
    }
    // Chunks begin at even offsets.
    at += length + length % 2;
    if (at > file.size()) break;
  }
  return "it has no samples";
}

}  // namespace soarbox::world
