// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct ZSTD_CCtx_s;

namespace soarbox::record {

// A recording on disk (docs/recording.md): eight bytes that name the format, then blocks. A block is a frame of 40
// bytes and a payload compressed with zstd. Readers ignore what follows the last complete block: a program that was
// killed leaves a recording that ends a little earlier.

inline constexpr std::string_view kMagic = "SOARBOX\x1a";
/// The only one that this program reads. It rises when the format changes after a release.
inline constexpr std::uint16_t kVersion = 11;

enum class BlockKind : std::uint16_t {
  kHeader = 1,  ///< Header; the first block.
  kInputs = 2,  ///< Inputs before the ticks of the next block, or of ticks that a bounded recording dropped.
  kTicks = 3,   ///< Consecutive ticks; the first is complete in itself.
};

/// Before each block, little-endian, in this order.
struct BlockFrame {
  std::uint16_t version = kVersion;
  BlockKind kind = BlockKind::kTicks;
  std::uint32_t compressed_bytes = 0;
  std::uint32_t plain_bytes = 0;
  std::uint32_t ticks = 0;  ///< Ticks in the block; 0 in others.
  std::uint64_t first_tick = 0;
  std::uint64_t payload_check = 0;  ///< Of the compressed payload (CheckOfPayload): detects any changed bit.
  std::uint64_t check = 0;          ///< Of the fields before it, so that random bytes do not look like a frame.
};
inline constexpr std::size_t kFrameBytes = 40;

// No block of ours comes near these limits; a file that claims more is refused.
inline constexpr std::uint32_t kMostCompressedBytes = 64u << 20;
inline constexpr std::uint32_t kMostPlainBytes = 256u << 20;
inline constexpr std::uint32_t kMostTicksPerBlock = 4096;
inline constexpr std::uint64_t kMostTicks = std::uint64_t{1} << 53;

/// Makes blocks one after the other in the same memory, which costs less than new memory for each.
class BlockEncoder {
 public:
  BlockEncoder();
  /// A frame and its compressed payload. The caller sets `kind` and ticks.
  std::string Encode(BlockFrame frame, std::string_view payload);

 private:
  struct Free {
    void operator()(ZSTD_CCtx_s* context) const;
  };
  std::unique_ptr<ZSTD_CCtx_s, Free> context_;
};
/// The same of one block alone.
std::string EncodeBlock(BlockFrame frame, std::string_view payload);
/// Reads a frame; false if the bytes are not one or exceed the limits.
bool DecodeFrame(std::string_view bytes, BlockFrame& frame);
std::uint64_t CheckOfPayload(std::string_view compressed);
/// False if the payload is damaged.
bool DecodePayload(const BlockFrame& frame, std::string_view compressed, std::string& payload);

}  // namespace soarbox::record
