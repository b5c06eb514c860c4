// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::wire {

/// Maximum length of a message. The protocol sets no limit, but an endless message must not exhaust the memory.
inline constexpr std::uint32_t kMaxMessageBytes = 64u << 20;

/// The four bytes before a message: its length, most significant byte first.
std::array<char, 4> FrameHeader(std::size_t length);
/// Header and message in one string.
std::string Frame(std::string_view message);

/// Splits a stream of bytes into messages. The bytes may come in chunks of any size; a chunk may contain several
/// messages.
class FrameReader {
 public:
  explicit FrameReader(std::uint32_t max_message_bytes = kMaxMessageBytes) : limit_(max_message_bytes) {}

  /// Appends the complete messages to `messages`; empty ones are dropped. Returns false if a length exceeds the limit:
  /// the rest of the stream cannot be read.
  bool Feed(std::string_view bytes, std::vector<std::string>& messages);

  /// Number of bytes of an incomplete message.
  std::size_t pending() const { return header_bytes_ + body_.size(); }

 private:
  std::uint32_t limit_;
  std::array<unsigned char, 4> header_{};
  std::size_t header_bytes_ = 0;
  std::uint32_t length_ = 0;
  bool broken_ = false;
  std::string body_;
};

}  // namespace soarbox::wire
