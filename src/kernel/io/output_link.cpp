// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/io/output_link.h"

#include <algorithm>

#include "kernel/decide/engine.h"

namespace soarbox::kernel {

namespace {

/// Room for the output of a small agent, so that its first commands cost what the later ones do.
constexpr std::size_t kUsualElements = 8;

}  // namespace

OutputLink::OutputLink(Engine& engine) : engine_(engine) {
  members_.reserve(kUsualElements);
  for (std::vector<OutputChange>* list : {&current_, &next_, &changes_}) list->reserve(kUsualElements);
  new_commands_.reserve(kUsualElements);
}

void OutputLink::SetIdentifier(Symbol identifier) {
  identifier_ = identifier;
  if (member_.size() <= identifier.index()) member_.resize(identifier.index() + 1u, 0);
  member_[identifier.index()] = 1;
  members_.assign(1, identifier);
}

void OutputLink::Traverse(Symbol id) {
  if (member_.size() <= id.index()) member_.resize(id.index() + 1u, 0);
  if (member_[id.index()] != 0) return;
  member_[id.index()] = 1;
  members_.push_back(id);
}

bool OutputLink::Collect() {
  if (!dirty_) return false;
  dirty_ = false;
  const WorkingMemory& memory = engine_.memory;
  for (const Symbol id : members_) {
    if (id.index() < member_.size()) member_[id.index()] = 0;
  }
  members_.clear();
  next_.clear();
  Traverse(identifier_);
  const auto visit = [&](WmeId first) {
    for (WmeId wme = first; wme != WmeId::kNone; wme = memory.record(wme).next) {
      const Wme& content = memory.wme(wme);
      next_.push_back({true, content.timetag, content.id, content.attribute, content.value});
      if (content.value.IsIdentifier()) Traverse(content.value);
    }
  };
  for (std::size_t n = 0; n < members_.size(); ++n) {
    const IdentifierRecord& record = memory.identifier(members_[n]);
    for (SlotId slot = record.slots; slot != SlotId::kNone; slot = memory.slot(slot).next)
      visit(memory.slot(slot).wmes);
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
  dirty_ = false;
  member_.clear();
  members_.clear();
  current_.clear();
  next_.clear();
  changes_.clear();
  new_commands_.clear();
}

}  // namespace soarbox::kernel
