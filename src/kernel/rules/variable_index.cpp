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

void VariableIndex::Number(TestDraft& test) {
  if (test.referent.IsVariable()) {
    test.variable = Add(test.referent);
  }
  for (TestDraft& part : test.parts) {
    Number(part);
  }
}

void VariableIndex::Number(ValueDraft& value) {
  if (value.symbol.IsVariable()) {
    value.variable = Add(value.symbol);
  }
  for (ValueDraft& argument : value.arguments) {
    Number(argument);
  }
}

void VariableIndex::NumberAll(const DraftList<ConditionDraft>& conditions) {
  for (ConditionDraft& condition : conditions) {
    Number(condition.id);
    Number(condition.attribute);
    Number(condition.value);
    NumberAll(condition.conditions);
  }
}

void VariableIndex::NumberAll(const DraftList<ActionDraft>& actions) {
  for (ActionDraft& action : actions) {
    Number(action.id);
    Number(action.attribute);
    Number(action.value);
    Number(action.referent);
  }
}

}  // namespace soarbox::kernel
