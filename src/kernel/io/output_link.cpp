// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/io/output_link.h"

#include <algorithm>

namespace soarbox::kernel {

namespace {

/// Room for the output of a small agent, so that its first commands cost what the later ones do.
constexpr std::size_t kUsualElements = 8;

}  // namespace

OutputLink::OutputLink(const WorkingMemory& memory, OutputMarks& marks) : memory_(memory), marks_(marks) {
  members_.reserve(kUsualElements);
  for (std::vector<OutputChange>* list : {&current_, &next_, &changes_}) list->reserve(kUsualElements);
  new_commands_.reserve(kUsualElements);
}

void OutputLink::SetIdentifier(Symbol identifier) {
  identifier_ = identifier;
  marks_.Mark(identifier);
  members_.assign(1, identifier);
}

void OutputLink::Traverse(Symbol id) {
  if (marks_.IsMarked(id)) return;
  marks_.Mark(id);
  members_.push_back(id);
}

bool OutputLink::Collect() {
  if (!marks_.TakeChange()) return false;
  for (const Symbol id : members_) marks_.Unmark(id);
  members_.clear();
  next_.clear();
  Traverse(identifier_);
  const auto visit = [&](WmeId first) {
    for (WmeId wme = first; wme != WmeId::kNone; wme = memory_.record(wme).next) {
      const Wme& content = memory_.wme(wme);
      next_.push_back({true, content.timetag, content.id, content.attribute, content.value});
      if (content.value.IsIdentifier()) Traverse(content.value);
    }
  };
  for (std::size_t n = 0; n < members_.size(); ++n) {
    const IdentifierRecord& record = memory_.identifier(members_[n]);
    for (SlotId slot = record.slots; slot != SlotId::kNone; slot = memory_.slot(slot).next)
      visit(memory_.slot(slot).wmes);
    visit(record.architecture_wmes);
    visit(record.input_wmes);
  }
  const auto by_timetag = [](const OutputChange& a, const OutputChange& b) { return a.timetag < b.timetag; };
  if (!std::is_sorted(next_.begin(), next_.end(), by_timetag)) std::sort(next_.begin(), next_.end(), by_timetag);

  current_.swap(next_);
  const std::vector<OutputChange>& before = next_;
  if (std::ranges::equal(before, current_, {}, &OutputChange::timetag, &OutputChange::timetag)) return false;

  // Both lists are in time-tag order: what stands in only one of them has come or gone. Removals go first.
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
  auto old = before.begin();
  for (const OutputChange& change : current_) {
    while (old != before.end() && old->timetag < change.timetag) ++old;
    if (old != before.end() && old->timetag == change.timetag) continue;
    changes_.push_back(change);
    if (change.id == identifier_ && change.value.IsIdentifier()) {
      new_commands_.push_back({change.attribute, change.value, change.timetag});
    }
  }
  return true;
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
