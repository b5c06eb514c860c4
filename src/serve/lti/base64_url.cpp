// SPDX-License-Identifier: BSD-2-Clause
#include "serve/lti/base64_url.h"

#include <cstdint>

namespace soarbox::lti {

constexpr std::string_view kBase64Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

std::string ToBase64Url(std::string_view bytes) {
  std::string text;
  std::uint32_t held = 0;
  int bits = 0;
  for (const char byte : bytes) {
    held = (held << 8) | static_cast<unsigned char>(byte);
    for (bits += 8; bits >= 6;) {
      bits -= 6;
      text += kBase64Letters[(held >> bits) & 63];
    }
  }
  if (bits > 0) text += kBase64Letters[(held << (6 - bits)) & 63];
  return text;
}

std::optional<std::string> FromBase64Url(std::string_view text) {
  std::string bytes;
  std::uint32_t held = 0;
  int bits = 0;
  for (const char letter : text) {
    const std::size_t value = kBase64Letters.find(letter);
    if (value == std::string_view::npos) return std::nullopt;
    held = (held << 6) | static_cast<std::uint32_t>(value);
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>((held >> bits) & 255);
  }
  const bool has_rest = (held & ((1u << bits) - 1)) != 0;
  if (has_rest || bits >= 6) return std::nullopt;
  return bytes;
}

}  // namespace soarbox::lti
