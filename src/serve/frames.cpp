// SPDX-License-Identifier: BSD-2-Clause
#include "serve/frames.h"

namespace soarbox::serve {
namespace {

constexpr std::size_t kHeaderBytes = 5;

bool IsKind(char kind) {
  constexpr std::string_view kKinds = "jhwcdsfbe";
  return kKinds.find(kind) != std::string_view::npos;
}

}  // namespace

std::string WriteFrame(FrameKind kind, std::string_view bytes) {
  std::string frame;
  frame.reserve(kHeaderBytes + bytes.size());
  frame += static_cast<char>(kind);
  for (int shift = 0; shift < 32; shift += 8) frame += static_cast<char>((bytes.size() >> shift) & 0xff);
  return frame.append(bytes);
}

std::optional<Frame> FrameReader::Take() {
  if (is_broken_ || held_.size() - begin_ < kHeaderBytes) return std::nullopt;
  std::size_t size = 0;
  for (std::size_t i = 0; i < 4; ++i)
    size |= static_cast<std::size_t>(static_cast<unsigned char>(held_[begin_ + 1 + i])) << (8 * i);
  is_broken_ = !IsKind(held_[begin_]) || size > kMostFrameBytes;
  if (is_broken_ || held_.size() - begin_ - kHeaderBytes < size) return std::nullopt;
  Frame frame{static_cast<FrameKind>(held_[begin_]), held_.substr(begin_ + kHeaderBytes, size)};
  begin_ += kHeaderBytes + size;
  if (begin_ == held_.size() || begin_ > held_.size() / 2) {
    held_.erase(0, begin_);
    begin_ = 0;
  }
  return frame;
}

}  // namespace soarbox::serve
