// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "record/format.h"
#include "record/tick_record.h"

namespace soarbox::record {

/// Consecutive ticks as a recording stores them: the frame, then the compressed payload.
struct EncodedBlock {
  BlockFrame frame;
  std::string bytes;
};

/// Puts ticks into blocks, each as its difference from the one before. The first tick of a block is complete in itself.
class BlockBuilder {
 public:
  explicit BlockBuilder(std::uint32_t ticks_per_block) : ticks_per_block_(ticks_per_block) {}

  /// Adds the next tick; true if the block is now full and must be taken. `tick` is then an earlier one, whose memory
  /// may serve again.
  bool Add(TickRecord& tick);
  bool empty() const { return frame_.ticks == 0; }
  /// Returns the current block; the next tick begins another.
  EncodedBlock Take();

 private:
  std::uint32_t ticks_per_block_;
  BlockEncoder encoder_;
  BlockFrame frame_;
  std::string payload_;
  std::uint64_t made_of_ = 0;  ///< Bytes of minds' events that a reader makes of payload_.
  TickRecord before_;          ///< The last tick in payload_.
};

/// Reads the ticks of one block, cheaply forwards; backwards it starts the block again.
class BlockCursor {
 public:
  /// Loads the payload of another block.
  void Load(const BlockFrame& frame, std::string payload);
  void Unload() { frame_.ticks = 0; }
  bool Has(std::uint64_t tick) const { return tick >= frame_.first_tick && tick < frame_.first_tick + frame_.ticks; }
  /// Null if the block is damaged. Ask only for ticks of the block. Valid until the next call.
  const TickRecord* At(std::uint64_t tick);

 private:
  void Rewind();

  BlockFrame frame_;
  std::string payload_;
  std::size_t read_ = 0;      ///< Bytes of the payload that record_ is the result of.
  std::uint64_t budget_ = 0;  ///< How much more memory the remaining bytes may ask for.
  std::uint64_t next_tick_ = 0;
  TickRecord record_;
};

}  // namespace soarbox::record
