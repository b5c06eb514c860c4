// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace soarbox::serve {

/// Messages between the server and an engine, on a byte stream: one byte for the kind, four for the length (little
/// endian), then the payload.
enum class FrameKind : std::uint8_t {
  kText = 'j',      ///< JSON: a request, or a message for the pages that are connected now.
  kHello = 'h',     ///< JSON: a run begins; also sent to pages that connect later.
  kFlow = 'w',      ///< JSON: state of the run's clock; the newest is also sent to pages that connect later.
  kContents = 'c',  ///< The name of contents, a byte 0, and their JSON; the newest of each name is also sent to pages
                    ///< that connect later.
  kDone = 'd',      ///< All requests so far were carried out.
  kScene = 's',     ///< A block of the scene stream that needs the previous one (docs/dev/stream.md).
  kFull = 'f',      ///< A complete block of the scene stream.
  kAlive = 'b',     ///< Heartbeat: the engine's main loop is running.
  kReason = 'e',    ///< Text: the error because of which the engine ends.
};
struct Frame {
  FrameKind kind = FrameKind::kText;
  std::string bytes;
};

/// The path of a place's folder as pages see it. The real path contains the place's secret.
inline constexpr std::string_view kShownRoot = "/place";

/// Maximum size of a frame. A longer frame is an error.
constexpr std::size_t kMostFrameBytes = 16u << 20;

std::string WriteFrame(FrameKind kind, std::string_view bytes);

/// Extracts frames from a byte stream.
class FrameReader {
 public:
  void Add(std::string_view bytes) { held_.append(bytes); }
  /// The next complete frame; nothing if more bytes are needed, or if the stream is broken.
  std::optional<Frame> Take();
  /// True after an unknown kind or a frame that is too long. No further frames can be read.
  bool is_broken() const { return is_broken_; }

 private:
  std::string held_;
  std::size_t begin_ = 0;  ///< Bytes before it were processed.
  bool is_broken_ = false;
};

}  // namespace soarbox::serve
