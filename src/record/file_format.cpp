// SPDX-License-Identifier: BSD-2-Clause
#include "record/file_format.h"

#include <zstd.h>

#include <bit>
#include <cstring>
#include <memory>

#include "bytes/byte_stream.h"
#include "world/state_hash.h"

namespace soarbox::record {
namespace {

constexpr int kCompressionLevel = 2;

std::uint64_t CheckOf(const BlockFrame& frame) {
  world::StateHash hash;
  hash.Add(static_cast<std::uint64_t>(frame.version) << 16 | static_cast<std::uint64_t>(frame.kind));
  hash.Add(static_cast<std::uint64_t>(frame.compressed_bytes) << 32 | frame.plain_bytes);
  hash.Add(static_cast<std::uint64_t>(frame.ticks));
  hash.Add(frame.first_tick);
  hash.Add(frame.payload_check);
  return hash.value();
}

}  // namespace

std::uint64_t CheckOfPayload(std::string_view compressed) {
  world::StateHash hash;
  hash.Add(static_cast<std::uint64_t>(compressed.size()));
  for (; compressed.size() >= 8; compressed.remove_prefix(8)) {
    std::uint64_t value;
    std::memcpy(&value, compressed.data(), sizeof value);
    if constexpr (std::endian::native == std::endian::big) value = __builtin_bswap64(value);
    hash.Add(value);
  }
  ByteReader in(compressed);
  std::uint64_t rest = 0;
  while (!in.AtEnd()) rest = rest << 8 | in.Byte();
  hash.Add(rest);
  return hash.value();
}

BlockEncoder::BlockEncoder() : context_(ZSTD_createCCtx()) {}

void BlockEncoder::Free::operator()(ZSTD_CCtx_s* context) const {
  ZSTD_freeCCtx(context);
}

std::string EncodeBlock(BlockFrame frame, std::string_view payload) {
  return BlockEncoder().Encode(frame, payload);
}

std::string BlockEncoder::Encode(BlockFrame frame, std::string_view payload) {
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, kCompressionLevel);
  const std::size_t bound = ZSTD_compressBound(payload.size());
  const auto buffer = std::make_unique_for_overwrite<char[]>(bound);
  const std::size_t size = ZSTD_compress2(context_.get(), buffer.get(), bound, payload.data(), payload.size());
  // With a buffer of this size, compression can only fail for lack of memory. Every reader then refuses the empty
  // block.
  const std::string_view compressed(buffer.get(), ZSTD_isError(size) != 0 ? 0 : size);
  frame.compressed_bytes = static_cast<std::uint32_t>(compressed.size());
  frame.plain_bytes = static_cast<std::uint32_t>(payload.size());
  frame.payload_check = CheckOfPayload(compressed);
  std::string block;
  block.reserve(kFrameBytes + compressed.size());
  ByteWriter out(block);
  out.Fixed32(static_cast<std::uint32_t>(frame.version) | static_cast<std::uint32_t>(frame.kind) << 16);
  for (const std::uint32_t number : {frame.compressed_bytes, frame.plain_bytes, frame.ticks}) out.Fixed32(number);
  out.Fixed64(frame.first_tick);
  out.Fixed64(frame.payload_check);
  out.Fixed64(CheckOf(frame));
  return block += compressed;
}

bool DecodeFrame(std::string_view bytes, BlockFrame& frame) {
  ByteReader in(bytes.substr(0, kFrameBytes));
  const std::uint32_t names = in.Fixed32();
  frame.version = static_cast<std::uint16_t>(names);
  frame.kind = static_cast<BlockKind>(names >> 16);
  for (std::uint32_t* number : {&frame.compressed_bytes, &frame.plain_bytes, &frame.ticks}) *number = in.Fixed32();
  frame.first_tick = in.Fixed64();
  frame.payload_check = in.Fixed64();
  frame.check = in.Fixed64();
  return !in.failed() && frame.check == CheckOf(frame) && frame.compressed_bytes <= kMostCompressedBytes &&
         frame.plain_bytes <= kMostPlainBytes && frame.ticks <= kMostTicksPerBlock && frame.first_tick <= kMostTicks;
}

bool DecodePayload(const BlockFrame& frame, std::string_view compressed, std::string& payload) {
  if (CheckOfPayload(compressed) != frame.payload_check) return false;
  // The size is also in zstd's frame. Both must be equal, so that a forged size cannot cause a larger allocation.
  if (ZSTD_getFrameContentSize(compressed.data(), compressed.size()) != frame.plain_bytes) return false;
  payload.resize(frame.plain_bytes);
  const std::size_t size = ZSTD_decompress(payload.data(), payload.size(), compressed.data(), compressed.size());
  return ZSTD_isError(size) == 0 && size == payload.size();
}

}  // namespace soarbox::record
