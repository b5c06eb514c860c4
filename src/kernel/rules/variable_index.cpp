// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

std::uint32_t VariableIndex::AddNew(Symbol variable, std::uint32_t slot) {
  if (size_ < kFirst) {
    first_[size_] = variable;
  } else {
    more_.push_back(variable);
  }
  slots_[slot] = ++size_;
  if (size_ * 2 > mask_) {
    mask_ = mask_ * 2 + 1;
    more_slots_.assign(mask_ + 1u, 0);
    slots_ = more_slots_.data();
    for (std::uint32_t number = 0; number < size_; ++number) {
      slots_[Slot(this->variable(number))] = number + 1;
    }
  }
  return size_ - 1;
}

void VariableIndex::AddAll(const TestDraft& test) {
  if (test.referent.IsVariable()) {
    Add(test.referent);
  }
  for (const TestDraft& part : test.parts) {
    AddAll(part);
  }
}

void VariableIndex::AddAll(const DraftList<ConditionDraft>& conditions) {
  for (const ConditionDraft& condition : conditions) {
    AddAll(condition.id);
    AddAll(condition.attribute);
    AddAll(condition.value);
    AddAll(condition.conditions);
  }
}

void VariableIndex::AddAll(const ValueDraft& value) {
  if (value.symbol.IsVariable()) {
    Add(value.symbol);
  }
  for (const ValueDraft& argument : value.arguments) {
    AddAll(argument);
  }
}

}  // namespace soarbox::kernel
