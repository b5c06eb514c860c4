// SPDX-License-Identifier: BSD-2-Clause
#include "record/block_codec.h"

#include <utility>

#include "bytes/byte_stream.h"
#include "record/tick_codec.h"

namespace soarbox::record {

bool BlockBuilder::Add(TickRecord& tick) {
  static const TickRecord kNothing;
  if (frame_.ticks == 0) {
    frame_.first_tick = tick.tick;
    minds_.Clear();
  }
  BufferedWriter out(payload_);
  WriteTick(out, frame_.ticks == 0 ? kNothing : before_, tick, minds_);
  out.Flush();
  for (const MindRecord& mind : tick.minds) made_of_ += mind.events.bytes().size();
  std::swap(before_, tick);
  // Ends a block early if it becomes large, for example because of many debug lines.
  constexpr std::size_t kLargeBlock = 16u << 20, kMuchMadeOf = 32u << 20;
  return ++frame_.ticks >= ticks_per_block_ || payload_.size() >= kLargeBlock || made_of_ >= kMuchMadeOf;
}

EncodedBlock BlockBuilder::Take() {
  EncodedBlock block;
  block.frame = std::exchange(frame_, {});
  block.bytes = encoder_.Encode(block.frame, payload_);
  payload_.clear();
  made_of_ = 0;
  return block;
}

void BlockCursor::Load(const BlockFrame& frame, std::string payload) {
  frame_ = frame;
  payload_ = std::move(payload);
  Rewind();
}

void BlockCursor::Rewind() {
  // Real ticks use about twice their encoded size in memory; short texts use more.
  constexpr std::uint64_t kTimes = 4, kAnyway = 64u << 20;
  read_ = 0;
  budget_ = kTimes * payload_.size() + kAnyway;
  next_tick_ = frame_.first_tick;
  record_ = {};
  minds_.Clear();
}

const TickRecord* BlockCursor::At(std::uint64_t tick) {
  if (tick + 1 == next_tick_ && read_ > 0) return &record_;
  if (tick < next_tick_) Rewind();
  while (next_tick_ <= tick) {
    ByteReader in(std::string_view(payload_).substr(read_));
    in.SetBudget(budget_);
    ReadTick(in, record_, minds_);
    budget_ = in.budget();
    if (in.failed() || record_.tick != next_tick_) {
      Unload();
      return nullptr;
    }
    read_ = payload_.size() - in.left();
    ++next_tick_;
  }
  world::PlaceHung(record_.scene.drawables);
  return &record_;
}

}  // namespace soarbox::record
