// SPDX-License-Identifier: BSD-2-Clause
#include "sim/input_door.h"

#include <algorithm>

#include "sim/input_names.h"

namespace soarbox::sim {
namespace {

/// Combines two consecutive inputs into one, if no information is lost.
bool Merge(InputValue& before, const InputValue& after) {
  if (std::holds_alternative<CameraInput>(before) && std::holds_alternative<CameraInput>(after)) {
    before = after;
    return true;
  }
  auto* axis = std::get_if<PadInput>(&before);
  const auto* moved = std::get_if<PadInput>(&after);
  if (axis != nullptr && moved != nullptr) {
    const bool is_same = axis->pad == moved->pad && axis->part == moved->part && !IsPadButton(axis->part);
    if (is_same) axis->value = moved->value;
    return is_same;
  }
  auto* move = std::get_if<PointerInput>(&before);
  const auto* next = std::get_if<PointerInput>(&after);
  if (move == nullptr || next == nullptr) return false;
  *move = {next->x_px, next->y_px, move->dx_px + next->dx_px, move->dy_px + next->dy_px};
  return true;
}

}  // namespace

bool InputDoor::Submit(Input input) {
  input.tick = std::max(input.tick, tick_ + 1);
  const auto behind = std::upper_bound(waiting_.begin(), waiting_.end(), input.tick,
                                       [](std::uint64_t tick, const Input& other) { return tick < other.tick; });
  if (behind != waiting_.begin()) {
    Input& last = *std::prev(behind);
    if (last.tick == input.tick && Merge(last.value, input.value)) return true;
  }
  const auto first = std::lower_bound(waiting_.begin(), behind, input.tick,
                                      [](const Input& other, std::uint64_t tick) { return other.tick < tick; });
  if (static_cast<std::size_t>(behind - first) >= kMostPerTick) return false;
  waiting_.insert(behind, std::move(input));
  return true;
}

void InputDoor::Note(InputValue value) {
  if (noted_.size() < kMostPerTick) noted_.push_back({tick_ + 1, std::move(value), false});
}

void InputDoor::BeginTick(std::uint64_t tick) {
  tick_ = tick;
  taken_ = std::exchange(noted_, {});
  noted_count_ = taken_.size();
  while (!waiting_.empty() && waiting_.front().tick <= tick) {
    taken_.push_back(std::move(waiting_.front()));
    waiting_.pop_front();
  }
}

}  // namespace soarbox::sim
