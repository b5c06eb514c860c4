// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;

namespace soarbox::record {

// A recording on disk (docs/dev/recording_format.md): eight bytes that identify the format, then blocks. A block is a
// frame of 40 bytes and a payload compressed with zstd. Readers ignore everything after the last complete block. If the
// program is killed, the recording therefore ends a little earlier.

inline constexpr std::string_view kMagic = "SOARBOX\x1a";
/// The only version that this program reads. It is incremented when the format changes, so that
/// readers of another version say so and do not report damage.
inline constexpr std::uint16_t kVersion = 13;

enum class BlockKind : std::uint16_t {
  kHeader = 1,  ///< The Header; always the first block.
  kInputs = 2,  ///< Inputs before the ticks of the next block, or of ticks that a bounded recording has dropped.
  kTicks = 3,   ///< Consecutive ticks; the first is complete, the others are differences.
  kWaits = 5,   ///< Waits; at the end, if the run waited. The ticks do not depend on it.
};

/// How often and how long a run waited for its recording.
struct Waits {
  std::uint64_t ticks = 0;  ///< Number of ticks that waited.
  double seconds = 0;       ///< Real time, in total.
};

/// Precedes each block. Little-endian, in this order.
struct BlockFrame {
  std::uint16_t version = kVersion;
  BlockKind kind = BlockKind::kTicks;
  std::uint32_t compressed_bytes = 0;
  std::uint32_t plain_bytes = 0;
  std::uint32_t ticks = 0;  ///< Number of ticks in the block; 0 in other blocks.
  std::uint64_t first_tick = 0;
  std::uint64_t payload_check = 0;  ///< Checksum of the compressed payload (CheckOfPayload), which detects any changed
                                    ///< bit.
  std::uint64_t check = 0;          ///< Checksum of the fields above, so that random bytes are not taken for a frame.
};
inline constexpr std::size_t kFrameBytes = 40;

// Our blocks are far below these limits. Files that exceed them are refused.
inline constexpr std::uint32_t kMostCompressedBytes = 64u << 20;
inline constexpr std::uint32_t kMostPlainBytes = 256u << 20;
inline constexpr std::uint32_t kMostTicksPerBlock = 4096;
inline constexpr std::uint64_t kMostTicks = std::uint64_t{1} << 53;

/// Encodes blocks one after the other. It reuses memory, which costs less than EncodeBlock.
class BlockEncoder {
 public:
  BlockEncoder();
  /// Returns a frame and its compressed payload. The caller sets `kind`, `ticks` and `first_tick`.
  std::string Encode(BlockFrame frame, std::string_view payload);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
  };
  std::unique_ptr<ZSTD_CCtx_s, Free> context_;
};
/// Encodes one block.
std::string EncodeBlock(BlockFrame frame, std::string_view payload);
/// Reads a frame. Returns false if the bytes are not a frame or exceed the limits.
bool DecodeFrame(std::string_view bytes, BlockFrame& frame);
std::uint64_t CheckOfPayload(std::string_view compressed);
/// Decompresses a payload. Returns false if it is damaged.
bool DecodePayload(const BlockFrame& frame, std::string_view compressed, std::string& payload);

}  // namespace soarbox::record
