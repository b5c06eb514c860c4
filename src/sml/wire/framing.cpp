// SPDX-License-Identifier: BSD-2-Clause
#include "sml/wire/framing.h"

#include <algorithm>

namespace soarbox::wire {

std::array<char, 4> FrameHeader(std::size_t length) {
  return {static_cast<char>((length >> 24) & 0xFF), static_cast<char>((length >> 16) & 0xFF),
          static_cast<char>((length >> 8) & 0xFF), static_cast<char>(length & 0xFF)};
}

std::string Frame(std::string_view message) {
  const std::array<char, 4> header = FrameHeader(message.size());
  std::string out;
  out.reserve(header.size() + message.size());
  out.append(header.data(), header.size());
  out.append(message);
  return out;
}

bool FrameReader::Feed(std::string_view bytes, std::vector<std::string>& messages) {
  if (broken_) return false;
  while (!bytes.empty()) {
    if (header_bytes_ < header_.size()) {
      header_[header_bytes_++] = static_cast<unsigned char>(bytes.front());
      bytes.remove_prefix(1);
      if (header_bytes_ < header_.size()) continue;
      length_ = (std::uint32_t{header_[0]} << 24) | (std::uint32_t{header_[1]} << 16) |
                (std::uint32_t{header_[2]} << 8) | std::uint32_t{header_[3]};
      if (length_ > limit_) {
        broken_ = true;
        return false;
      }
      if (length_ == 0) header_bytes_ = 0;
      continue;
    }
    const std::size_t take = std::min<std::size_t>(bytes.size(), length_ - body_.size());
    body_.append(bytes.substr(0, take));
    bytes.remove_prefix(take);
    if (body_.size() == length_) {
      messages.push_back(std::move(body_));
      body_.clear();
      header_bytes_ = 0;
    }
  }
  return true;
}

}  // namespace soarbox::wire
