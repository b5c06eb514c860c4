// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "record/block_codec.h"
#include "record/tick_source.h"

namespace soarbox::record {

/// How much of a running world stays in memory. The oldest records are dropped first; all inputs stay.
struct HistorySettings {
  std::uint64_t most_bytes = 256u << 20;
  std::uint64_t most_ticks = 30u * 60 * 30;  ///< Half an hour of the usual ticks.
  std::uint32_t ticks_per_block = 30;
};

/// What has happened in a running world so far, in memory: the records of its newest ticks, by number, and all inputs
/// since its beginning. With a Branch you go back to any of these ticks and continue from there.
class History final : public TickSource {
 public:
  /// The header says which run it is (HeaderOf). Holds no tick before the first Add.
  explicit History(Header header, const HistorySettings& settings = {});

  /// Adds the tick after the last one; the first may be any.
  void Add(const TickRecord& record);
  bool empty() const { return blocks_.empty() && newest_.empty(); }
  /// The memory that its records use, without the ticks of the current block.
  std::uint64_t bytes() const { return bytes_; }

  /// The past of a branch that leaves this run at a tick: all inputs up to it, and the records still held. Shares
  /// memory with this history.
  std::unique_ptr<History> UpTo(std::uint64_t tick);

  const Header& header() const override { return header_; }
  std::string name() const override { return "this run"; }
  std::uint64_t first_tick() const override;
  std::uint64_t last_tick() const override;
  Result<const TickRecord*> At(std::uint64_t tick) override;
  Result<std::vector<TickInputs>> Inputs() override { return inputs_; }

 private:
  void Keep(std::shared_ptr<const EncodedBlock> block);

  Header header_;
  HistorySettings settings_;
  std::deque<std::shared_ptr<const EncodedBlock>> blocks_;
  std::vector<TickRecord> newest_;  ///< Of the current block, in order.
  BlockBuilder builder_;
  std::vector<TickInputs> inputs_;  ///< Of ticks that had some.
  std::uint64_t bytes_ = 0;
  BlockCursor cursor_;
};

}  // namespace soarbox::record
