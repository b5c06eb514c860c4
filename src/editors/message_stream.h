// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::editors {

/// The framing that the Language Server Protocol and the Debug Adapter Protocol share: header lines, of which
/// Content-Length counts, an empty line, and as many bytes. Takes any bytes, in any pieces.
class MessageStream {
 public:
  static constexpr std::size_t kLongest = 64u << 20;       ///< Bytes of one message.
  static constexpr std::size_t kLongestHeader = 8 * 1024;  ///< Bytes before a message without an end of the header.

  void Add(std::string_view bytes) { bytes_ += bytes; }

  /// A message, or what is wrong with the bytes in its place. After a fault the stream goes on at the next header.
  struct Message {
    std::string body;
    std::string fault;  ///< Not empty: there is no body.
  };
  /// The next message, once all of it is there.
  std::optional<Message> Next();

  /// A message with its header.
  static std::string Frame(std::string_view body);

 private:
  std::string bytes_;
  std::size_t skip_ = 0;  ///< Bytes of a message that is too long, still to come.
};

/// Lines, one message each, as the Model Context Protocol has them on standard input.
class LineStream {
 public:
  static constexpr std::size_t kLongest = 16u << 20;

  void Add(std::string_view bytes) { bytes_ += bytes; }
  /// The next whole line without its end. A line that is too long is given as a fault, and left out.
  std::optional<MessageStream::Message> Next();

 private:
  std::string bytes_;
  std::size_t searched_ = 0;
  bool skips_ = false;
};

}  // namespace soarbox::editors
