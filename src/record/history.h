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

/// How much of a running world stays in memory. The oldest records are dropped first. All inputs are kept.
struct HistorySettings {
  std::uint64_t most_bytes = 256u << 20;
  std::uint64_t most_ticks = 30u * 60 * 30;  ///< Half an hour of the usual ticks.
  std::uint32_t ticks_per_block = 30;
};

/// The past of a running world, in memory: the records of its newest ticks, and all inputs since its beginning. A
/// Branch goes back to any of these ticks and continues from there.
class History final : public TickSource {
 public:
  /// The header describes the run (HeaderOf). The history is empty until the first Add.
  explicit History(Header header, const HistorySettings& settings = {});

  /// Adds the tick after the last one. The first tick can be any.
  void Add(const TickRecord& record);
  bool empty() const { return blocks_.empty() && newest_.empty(); }
  /// Memory used by the records, without those of the current block.
  std::uint64_t bytes() const { return bytes_; }

  /// The history of a branch that leaves this run at a tick: all inputs up to it, and the records that are still
  /// available. Shares memory with this history.
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
  std::vector<TickRecord> newest_;  ///< The ticks of the current block, in order.
  BlockBuilder builder_;
  std::vector<TickInputs> inputs_;  ///< Only ticks that had inputs.
  std::uint64_t bytes_ = 0;
  BlockCursor cursor_;
};

}  // namespace soarbox::record
