// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace soarbox::wire {

/// No message may be longer. The protocol sets no limit; an endless one must not eat the memory.
inline constexpr std::uint32_t kMaxMessageBytes = 64u << 20;

/// The four bytes that go before a message: its length, most significant byte first.
std::array<char, 4> FrameHeader(std::size_t length);
/// Header and message in one string.
std::string Frame(std::string_view message);

/// Cuts a stream of bytes into messages. Bytes come in pieces of any size; several messages may be in one piece.
class FrameReader {
 public:
  explicit FrameReader(std::uint32_t max_message_bytes = kMaxMessageBytes) : limit_(max_message_bytes) {}

  /// Appends the messages that are complete now to `messages`; empty ones are dropped. False if a length is above the
  /// limit: the stream cannot be read any further.
  bool Feed(std::string_view bytes, std::vector<std::string>& messages);

  /// Bytes of a message that is not complete yet.
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
