// SPDX-License-Identifier: BSD-2-Clause
#include "editors/message_stream.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace soarbox::editors {
namespace {

constexpr std::string_view kName = "content-length:";

/// The number of the header's Content-Length; nothing if it is missing or invalid.
std::optional<std::size_t> LengthIn(std::string_view header) {
  while (!header.empty()) {
    const std::size_t end = std::min(header.find('\n'), header.size());
    std::string_view line = header.substr(0, end);
    header.remove_prefix(std::min(end + 1, header.size()));
    std::string name(line.substr(0, kName.size()));
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (name != kName) continue;
    line.remove_prefix(kName.size());
    line.remove_prefix(std::min(line.find_first_not_of(" \t"), line.size()));
    line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
    std::size_t length = 0;
    const auto [stop, error] = std::from_chars(line.data(), line.data() + line.size(), length);
    if (error != std::errc{} || stop != line.data() + line.size()) return std::nullopt;
    return length;
  }
  return std::nullopt;
}

}  // namespace

std::optional<MessageStream::Message> MessageStream::Next() {
  if (skip_ > 0) {
    const std::size_t skipped = std::min(skip_, bytes_.size());
    bytes_.erase(0, skipped);
    skip_ -= skipped;
    if (skip_ > 0) return std::nullopt;
  }
  // Some clients end lines with only \n.
  std::size_t end = bytes_.find("\r\n\r\n"), behind = 4;
  if (const std::size_t plain = bytes_.find("\n\n"); plain < end) {
    end = plain;
    behind = 2;
  }
  if (end == std::string::npos) {
    if (bytes_.size() <= kLongestHeader) return std::nullopt;
    bytes_.clear();
    return Message{{}, "no header of a message ends within " + std::to_string(kLongestHeader) + " bytes"};
  }
  const std::optional<std::size_t> length = LengthIn(std::string_view(bytes_).substr(0, end));
  if (!length) {
    bytes_.erase(0, end + behind);
    return Message{{}, "this header has no Content-Length with a number"};
  }
  if (*length > kLongest) {
    bytes_.erase(0, end + behind);
    skip_ = *length;
    return Message{{}, "this message has more than " + std::to_string(kLongest) + " bytes"};
  }
  if (bytes_.size() - end - behind < *length) return std::nullopt;
  Message message{bytes_.substr(end + behind, *length), {}};
  bytes_.erase(0, end + behind + *length);
  return message;
}

std::string MessageStream::Frame(std::string_view body) {
  return "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + std::string(body);
}

std::optional<MessageStream::Message> LineStream::Next() {
  const std::size_t end = bytes_.find('\n', searched_);
  if (end == std::string::npos) {
    searched_ = bytes_.size();
    if (bytes_.size() <= kLongest) return std::nullopt;
    bytes_.clear();
    searched_ = 0;
    if (skips_) return std::nullopt;
    skips_ = true;
    return MessageStream::Message{{}, "this message has more than " + std::to_string(kLongest) + " bytes"};
  }
  std::string line = bytes_.substr(0, end);
  bytes_.erase(0, end + 1);
  searched_ = 0;
  if (skips_) {
    skips_ = false;
    return Next();
  }
  if (line.ends_with('\r')) line.pop_back();
  return MessageStream::Message{std::move(line), {}};
}

}  // namespace soarbox::editors
