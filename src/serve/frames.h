// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::serve {

/// Messages between the server and an engine, on a stream of bytes: one byte of kind, four of length (little endian),
/// then so many bytes.
enum class FrameKind : std::uint8_t {
  kText = 'j',      ///< JSON: a request, or what a page is told once.
  kHello = 'h',     ///< JSON: a run begins; whoever comes later is told, too.
  kFlow = 'w',      ///< JSON: how the world goes; likewise, the newest.
  kContents = 'c',  ///< The name of contents, a byte 0, and their JSON; likewise, the newest of each name.
  kDone = 'd',      ///< All requests so far are carried out.
  kScene = 's',     ///< A block of the scene stream that needs the one before (docs/dev/stream.md).
  kFull = 'f',      ///< A block that stands alone.
  kAlive = 'b',     ///< Heartbeat: the engine's loop has begun another round.
};
struct Frame {
  FrameKind kind = FrameKind::kText;
  std::string bytes;
};

/// The folder of a place as pages see it: its real path holds the place's secret.
inline constexpr std::string_view kShownRoot = "/place";

/// No frame is longer; a sender of more is broken.
constexpr std::size_t kMostFrameBytes = 16u << 20;

std::string WriteFrame(FrameKind kind, std::string_view bytes);

/// Takes frames out of bytes as they come.
class FrameReader {
 public:
  void Add(std::string_view bytes) { held_.append(bytes); }
  /// The next whole frame; none: more bytes have to come, or the stream is broken.
  std::optional<Frame> Take();
  /// An unknown kind, or a frame that is too long: nothing after it can be read.
  bool is_broken() const { return is_broken_; }

 private:
  std::string held_;
  std::size_t begin_ = 0;  ///< What lies before it is taken.
  bool is_broken_ = false;
};

}  // namespace soarbox::serve
