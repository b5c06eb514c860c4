// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/io/output_link.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace soarbox::kernel {

namespace {

/// Enough for the output of a small agent, so that its first commands do not allocate more than later ones.
constexpr std::size_t kUsualElements = 8;

}  // namespace

OutputLink::OutputLink(const WorkingMemory& memory, OutputMarks& marks) : memory_(memory), marks_(marks) {
  members_.reserve(kUsualElements);
  pending_.reserve(kUsualElements);
  visited_.reserve(kUsualElements);
  for (std::vector<OutputChange>* list : {&current_, &next_, &changes_}) list->reserve(kUsualElements);
  new_commands_.reserve(kUsualElements);
}

void OutputLink::SetIdentifier(Symbol identifier) {
  identifier_ = identifier;
  marks_.Mark(identifier);
  members_.assign(1, identifier);
}

void OutputLink::Visit(Symbol id) {
  marks_.Mark(id);
  members_.push_back(id);
  const std::size_t first = next_.size();
  const auto take = [&](WmeId wme) {
    for (; wme != WmeId::kNone; wme = memory_.record(wme).next) {
      const Wme& content = memory_.wme(wme);
      next_.push_back({true, content.timetag, content.id, content.attribute, content.value});
    }
  };
  const IdentifierRecord& record = memory_.identifier(id);
  take(record.input_wmes);
  for (SlotId slot = record.slots; slot != SlotId::kNone; slot = memory_.slot(slot).next) take(memory_.slot(slot).wmes);
  take(record.architecture_wmes);
  // The lists are sorted newest first. Here the elements are listed oldest first, but the newest object is visited
  // first.
  std::reverse(next_.begin() + static_cast<std::ptrdiff_t>(first), next_.end());
  for (std::size_t n = first; n < next_.size(); ++n) {
    if (next_[n].value.IsIdentifier() && !marks_.IsMarked(next_[n].value)) pending_.push_back(next_[n].value);
  }
}

bool OutputLink::Collect() {
  if (!marks_.TakeChange()) return false;
  for (const Symbol id : members_) marks_.Unmark(id);
  members_.clear();
  next_.clear();
  pending_.assign(1, identifier_);
  while (!pending_.empty()) {
    const Symbol id = pending_.back();
    pending_.pop_back();
    if (!marks_.IsMarked(id)) Visit(id);
  }
  const auto by_timetag = [](const OutputChange& a, const OutputChange& b) { return a.timetag < b.timetag; };
  visited_.clear();
  if (!std::is_sorted(next_.begin(), next_.end(), by_timetag)) {
    for (const OutputChange& change : next_) visited_.push_back(change.timetag);
    std::sort(next_.begin(), next_.end(), by_timetag);
  }

  current_.swap(next_);
  const std::vector<OutputChange>& before = next_;
  if (std::ranges::equal(before, current_, {}, &OutputChange::timetag, &OutputChange::timetag)) return false;

  // Both lists are in time-tag order: an element in only one of them was added or removed. Removals are listed first.
  ++generation_;
  changes_.clear();
  new_commands_.clear();
  auto now = current_.begin();
  for (const OutputChange& old : before) {
    while (now != current_.end() && now->timetag < old.timetag) ++now;
    if (now != current_.end() && now->timetag == old.timetag) continue;
    changes_.push_back(old);
    changes_.back().added = false;
  }
  const std::size_t removed = changes_.size();
  auto old = before.begin();
  for (const OutputChange& change : current_) {
    while (old != before.end() && old->timetag < change.timetag) ++old;
    if (old != before.end() && old->timetag == change.timetag) continue;
    changes_.push_back(change);
  }
  OrderAdditions(removed);
  for (const OutputChange& change : std::span(changes_).subspan(removed)) {
    if (change.id == identifier_ && change.value.IsIdentifier()) {
      new_commands_.push_back({change.attribute, change.value, change.timetag});
    }
  }
  return true;
}

void OutputLink::OrderAdditions(std::size_t first) {
  const std::size_t count = changes_.size() - first;
  if (count < 2 || visited_.empty()) return;
  const std::span<OutputChange> additions = std::span(changes_).subspan(first);
  // `next_` contains the previous elements, which are not needed any more.
  next_.clear();
  for (const std::uint64_t timetag : visited_) {
    const auto found = std::ranges::lower_bound(additions, timetag, {}, &OutputChange::timetag);
    if (found != additions.end() && found->timetag == timetag) next_.push_back(*found);
  }
  std::ranges::copy(next_, additions.begin());
}

void OutputLink::Reset() {
  identifier_ = Symbol();
  marks_.Clear();
  members_.clear();
  current_.clear();
  next_.clear();
  changes_.clear();
  new_commands_.clear();
}

}  // namespace soarbox::kernel
