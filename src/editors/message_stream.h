// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::editors {

/// The framing of the Language Server Protocol and the Debug Adapter Protocol: header lines, of which only
/// Content-Length is used, an empty line, and that number of bytes. Accepts any bytes, in pieces of any size.
class MessageStream {
 public:
  static constexpr std::size_t kLongest = 64u << 20;       ///< Maximum size of a message in bytes.
  static constexpr std::size_t kLongestHeader = 8 * 1024;  ///< Maximum size of a header in bytes.

  void Add(std::string_view bytes) { bytes_ += bytes; }

  /// A message, or an error in the stream. After an error, Next() continues with the bytes that follow.
  struct Message {
    std::string body;
    std::string fault;  ///< If not empty, there is no body.
  };
  /// The next message, if it is complete.
  std::optional<Message> Next();

  /// Adds the header to a message.
  static std::string Frame(std::string_view body);

 private:
  std::string bytes_;
  std::size_t skip_ = 0;  ///< Remaining bytes of a message that is too long.
};

/// The framing of the Model Context Protocol on standard input: one message per line.
class LineStream {
 public:
  static constexpr std::size_t kLongest = 16u << 20;

  void Add(std::string_view bytes) { bytes_ += bytes; }
  /// The next complete line without its end. A line that is too long is skipped and reported as a fault.
  std::optional<MessageStream::Message> Next();

 private:
  std::string bytes_;
  std::size_t searched_ = 0;
  bool skips_ = false;
};

}  // namespace soarbox::editors
