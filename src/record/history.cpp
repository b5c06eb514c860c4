// SPDX-License-Identifier: BSD-2-Clause
#include "record/history.h"

#include <algorithm>
#include <utility>

namespace soarbox::record {
namespace {

std::string_view PayloadOf(const EncodedBlock& block) {
  return std::string_view(block.bytes).substr(kFrameBytes);
}

}  // namespace

History::History(Header header, const HistorySettings& settings)
    : header_(std::move(header)), settings_(settings), builder_(settings.ticks_per_block) {}

std::uint64_t History::first_tick() const {
  if (!blocks_.empty()) return blocks_.front()->frame.first_tick;
  return newest_.empty() ? 0 : newest_.front().tick;
}

std::uint64_t History::last_tick() const {
  if (!newest_.empty()) return newest_.back().tick;
  return blocks_.empty() ? 0 : blocks_.back()->frame.first_tick + blocks_.back()->frame.ticks - 1;
}

void History::Keep(std::shared_ptr<const EncodedBlock> block) {
  bytes_ += block->bytes.size();
  blocks_.push_back(std::move(block));
  const auto is_too_much = [&] {
    return bytes_ > settings_.most_bytes ||
           blocks_.back()->frame.first_tick - blocks_.front()->frame.first_tick > settings_.most_ticks;
  };
  for (; blocks_.size() > 1 && is_too_much(); blocks_.pop_front()) bytes_ -= blocks_.front()->bytes.size();
}

void History::Add(const TickRecord& record) {
  if (!record.inputs.empty()) inputs_.push_back({record.tick, record.inputs});
  newest_.push_back(record);
  TickRecord copy = record;
  if (!builder_.Add(copy)) return;
  Keep(std::make_shared<const EncodedBlock>(builder_.Take()));
  newest_.clear();
}

Result<const TickRecord*> History::At(std::uint64_t tick) {
  if (empty() || !Holds(tick)) return NotThere(*this, tick);
  if (!newest_.empty() && tick >= newest_.front().tick)
    return &newest_[static_cast<std::size_t>(tick - newest_.front().tick)];
  if (!cursor_.Has(tick)) {
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), tick, [](std::uint64_t wanted, const auto& b) {
      return wanted < b->frame.first_tick;
    });
    const EncodedBlock& block = **(after - 1);
    BlockFrame frame;
    std::string payload;
    if (DecodeFrame(block.bytes, frame) && DecodePayload(frame, PayloadOf(block), payload))
      cursor_.Load(frame, std::move(payload));
  }
  if (cursor_.Has(tick))
    if (const TickRecord* record = cursor_.At(tick)) return record;
  Diagnostic problem = NotThere(*this, tick);  // Happens only if memory ran out while it was stored.
  problem.message = "the record of tick " + std::to_string(tick) + " is lost";
  return problem;
}

std::unique_ptr<History> History::UpTo(std::uint64_t tick) {
  auto past = std::make_unique<History>(header_, settings_);
  std::uint64_t next = first_tick();
  for (const std::shared_ptr<const EncodedBlock>& block : blocks_) {
    if (block->frame.first_tick + block->frame.ticks - 1 > tick) break;
    past->Keep(block);
    next = block->frame.first_tick + block->frame.ticks;
  }
  for (; !empty() && next <= std::min(tick, last_tick()); ++next)
    if (const Result<const TickRecord*> record = At(next)) past->Add(**record);
  past->inputs_.clear();
  for (const TickInputs& entry : inputs_)
    if (entry.tick <= tick) past->inputs_.push_back(entry);
  return past;
}

}  // namespace soarbox::record
