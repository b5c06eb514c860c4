// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "record/file_format.h"
#include "record/minds_codec.h"
#include "record/tick_record.h"

namespace soarbox::record {

/// Consecutive ticks as a recording stores them: a frame and a compressed payload.
struct EncodedBlock {
  BlockFrame frame;
  std::string bytes;
};

/// Encodes ticks into blocks. Each tick is stored as its difference from the previous one; the first tick of a block is
/// complete.
class BlockBuilder {
 public:
  explicit BlockBuilder(std::uint32_t ticks_per_block) : ticks_per_block_(ticks_per_block) {}

  /// Adds the next tick. Returns true if the block is full; the caller must then call Take. On return, `tick` contains
  /// an earlier tick, whose memory the caller can reuse.
  bool Add(TickRecord& tick);
  bool empty() const { return frame_.ticks == 0; }
  /// Returns the current block. The next tick begins a new one.
  EncodedBlock Take();

 private:
  std::uint32_t ticks_per_block_;
  BlockEncoder encoder_;
  BlockFrame frame_;
  std::string payload_;
  std::uint64_t made_of_ = 0;  ///< Size in bytes of the minds' events that a reader decodes from payload_.
  TickRecord before_;          ///< The last tick in payload_.
  MindsEncoder minds_;
};

/// Reads the ticks of one block. Reading forwards is cheap; going back starts again at the first tick of the block.
class BlockCursor {
 public:
  /// Loads the payload of another block.
  void Load(const BlockFrame& frame, std::string payload);
  void Unload() { frame_.ticks = 0; }
  bool Has(std::uint64_t tick) const { return tick >= frame_.first_tick && tick < frame_.first_tick + frame_.ticks; }
  /// Returns null if the block is damaged. `tick` must be in the block. Valid until the next call.
  const TickRecord* At(std::uint64_t tick);

 private:
  void Rewind();

  BlockFrame frame_;
  std::string payload_;
  std::size_t read_ = 0;      ///< Number of bytes of the payload that were decoded to get record_.
  std::uint64_t budget_ = 0;  ///< How much more memory decoding may allocate for the remaining bytes.
  std::uint64_t next_tick_ = 0;
  TickRecord record_;
  MindsDecoder minds_;
};

}  // namespace soarbox::record
