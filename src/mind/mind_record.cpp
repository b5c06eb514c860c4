// SPDX-License-Identifier: BSD-2-Clause
#include "mind/mind_record.h"

namespace soarbox::mind {

/// Stores the operator of a level of the goal stack; removes the levels below it.
void MindRecord::Settle(int level, std::string_view operator_name) {
  waits_in_.clear();
  if (level < 1 || level > 1000) return;
  const auto above = static_cast<std::size_t>(level - 1);
  if (above + 1 == depth_ && operators_[above] == operator_name) return;  // Unchanged.
  // The memory of names is reused from decision to decision.
  if (operators_.size() < above + 1) operators_.resize(above + 1);
  for (std::size_t i = depth_; i < above; ++i) operators_[i].clear();
  if (operators_[above] != operator_name) operators_[above] = operator_name;
  depth_ = operator_name.empty() ? above : above + 1;
}

void MindRecord::OnOperator(const OperatorSelected& selected) {
  Settle(selected.level, selected.name.empty() ? selected.id : selected.name);
  events.Add(selected);
}

void MindRecord::OnState(const StateMade& made) {
  if (waits_in_ == made.id) return;
  Settle(made.level, {});
  waits_in_ = made.id;
  events.Add(made);
}

void MindRecord::OnStateGone(const StateGone& gone) {
  Settle(gone.level, {});
  events.Add(gone);
}

void MindRecord::OnCommand(std::uint64_t timetag, std::string_view rule) {
  if (rule.empty()) return;
  names_ += rule;
  makers_.push_back({timetag, names_.size()});
}

std::string_view MindRecord::MakerOf(std::uint64_t timetag) const {
  std::string_view rule;
  std::size_t begin = 0;
  for (const Maker& maker : makers_) {
    if (maker.timetag == timetag) rule = std::string_view(names_).substr(begin, maker.name_end - begin);
    begin = maker.name_end;
  }
  return rule;
}

std::string MindRecord::Operators() const {
  std::string all;
  for (std::size_t i = 0; i < depth_; ++i) {
    const std::string& name = operators_[i];
    if (!name.empty()) all += (all.empty() ? "" : " > ") + name;
  }
  return all;
}

void MindRecord::Clear() {
  events.Clear();
  makers_.clear();
  names_.clear();
}

}  // namespace soarbox::mind
