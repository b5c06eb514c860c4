// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox {

/// The alphabet of base 64 (RFC 4648) and its variant for URLs and JSON Web Tokens.
inline constexpr std::string_view kBase64Letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
inline constexpr std::string_view kBase64UrlLetters =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

/// Bytes in base 64, without padding.
inline std::string ToUnpaddedBase64(std::string_view bytes, std::string_view letters) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  std::uint32_t held = 0;
  int bits = 0;
  for (const char byte : bytes) {
    held = (held << 8) | static_cast<unsigned char>(byte);
    for (bits += 8; bits >= 6;) {
      bits -= 6;
      text += letters[(held >> bits) & 63];
    }
  }
  if (bits > 0) text += letters[(held << (6 - bits)) & 63];
  return text;
}

/// Bytes in base 64, padded with = to a multiple of four letters.
inline std::string ToBase64(std::string_view bytes) {
  std::string text = ToUnpaddedBase64(bytes, kBase64Letters);
  text.append((4 - text.size() % 4) % 4, '=');
  return text;
}

/// The bytes of an unpadded text. Nothing if it has a letter outside the alphabet, a single letter at the end, or bits
/// after its last byte that are not 0.
inline std::optional<std::string> FromUnpaddedBase64(std::string_view text, std::string_view letters) {
  std::string bytes;
  std::uint32_t held = 0;
  int bits = 0;
  for (const char letter : text) {
    const std::size_t value = letters.find(letter);
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

/// The same for a text in the usual alphabet, with or without padding.
inline std::optional<std::string> FromBase64(std::string_view text) {
  if (text.ends_with('=') && text.size() % 4 != 0) return std::nullopt;
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  return FromUnpaddedBase64(text, kBase64Letters);
}

/// Bytes as base64url without padding, as JSON Web Tokens use it (RFC 7515), and back.
inline std::string ToBase64Url(std::string_view bytes) {
  return ToUnpaddedBase64(bytes, kBase64UrlLetters);
}
inline std::optional<std::string> FromBase64Url(std::string_view text) {
  return FromUnpaddedBase64(text, kBase64UrlLetters);
}

}  // namespace soarbox
