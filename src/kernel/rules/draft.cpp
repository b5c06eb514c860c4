// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/draft.h"

#include <algorithm>

namespace soarbox::kernel {

namespace {

template <typename T>
bool SameItems(const DraftList<T>& a, const DraftList<T>& b) {
  const T* x = a.first;
  const T* y = b.first;
  for (; x != nullptr && y != nullptr; x = x->next, y = y->next) {
    if (!(*x == *y)) {
      return false;
    }
  }
  return x == y;
}

}  // namespace

bool operator==(const TestDraft& a, const TestDraft& b) {
  return a.kind == b.kind && a.referent == b.referent && a.disjunct_count == b.disjunct_count &&
         std::equal(a.disjuncts, a.disjuncts + a.disjunct_count, b.disjuncts) && SameItems(a.parts, b.parts);
}

bool operator==(const ConditionDraft& a, const ConditionDraft& b) {
  return a.kind == b.kind && a.tests_acceptable == b.tests_acceptable && a.id == b.id && a.attribute == b.attribute &&
         a.value == b.value && SameItems(a.conditions, b.conditions);
}

TestDraft Copy(const TestDraft& test, Arena& arena) {
  TestDraft copy = test;
  copy.next = nullptr;
  copy.parts = {};
  for (const TestDraft& part : test.parts) {
    copy.parts.Add(arena.New(part));
  }
  return copy;
}

ConditionDraft Copy(const ConditionDraft& condition, Arena& arena) {
  ConditionDraft copy = condition;
  copy.next = nullptr;
  copy.id = Copy(condition.id, arena);
  copy.attribute = Copy(condition.attribute, arena);
  copy.value = Copy(condition.value, arena);
  copy.conditions = {};
  for (const ConditionDraft& inner : condition.conditions) {
    copy.conditions.Add(arena.New(Copy(inner, arena)));
  }
  return copy;
}

ValueDraft Copy(const ValueDraft& value, Arena& arena) {
  ValueDraft copy = value;
  copy.next = nullptr;
  copy.arguments = {};
  for (const ValueDraft& argument : value.arguments) {
    copy.arguments.Add(arena.New(Copy(argument, arena)));
  }
  return copy;
}

TestDraft ToDraft(const Test& test, Arena& arena) {
  TestDraft draft = MakeTest(test.kind, test.referent());
  for (const Test& part : test.parts()) {
    draft.parts.Add(arena.New(ToDraft(part, arena)));
  }
  const std::span<const Symbol> disjuncts = test.disjuncts();
  Symbol* const copies = arena.NewArray<Symbol>(disjuncts.size());
  std::ranges::copy(disjuncts, copies);
  draft.disjuncts = copies;
  draft.disjunct_count = static_cast<std::uint32_t>(disjuncts.size());
  return draft;
}

ConditionDraft ToDraft(const Condition& condition, Arena& arena) {
  ConditionDraft draft;
  draft.kind = condition.kind;
  draft.tests_acceptable = condition.tests_acceptable;
  if (condition.kind == ConditionKind::kConjunctiveNegation) {
    for (const Condition& inner : condition.conditions()) {
      draft.conditions.Add(arena.New(ToDraft(inner, arena)));
    }
    return draft;
  }
  draft.id = ToDraft(condition.id, arena);
  draft.attribute = ToDraft(condition.attribute, arena);
  draft.value = ToDraft(condition.value, arena);
  return draft;
}

ValueDraft ToDraft(const RhsValue& value, Arena& arena) {
  ValueDraft draft;
  draft.kind = value.kind;
  draft.symbol = value.symbol();
  if (value.kind == RhsValueKind::kBound) {
    draft.site = value.site();
  } else {
    draft.index = value.new_index();
  }
  for (const RhsValue& argument : value.arguments()) {
    draft.arguments.Add(arena.New(ToDraft(argument, arena)));
  }
  return draft;
}

ActionDraft ToDraft(const Action& action, Arena& arena) {
  ActionDraft draft;
  draft.is_function_call = action.is_function_call;
  draft.preference = action.preference;
  draft.id = ToDraft(action.id, arena);
  draft.attribute = ToDraft(action.attribute, arena);
  draft.value = ToDraft(action.value, arena);
  draft.referent = ToDraft(action.referent, arena);
  return draft;
}

RuleDraft ToDraft(const Production& rule, Arena& arena) {
  RuleDraft draft;
  draft.name = rule.name;
  draft.documentation = rule.documentation;
  draft.has_documentation = rule.has_documentation;
  draft.type = rule.type;
  draft.declared_support = rule.declared_support;
  draft.interrupt = rule.interrupt;
  draft.explain = rule.explain;
  draft.is_rl = rule.is_rl;
  draft.file = rule.file_name();
  draft.line = rule.line;
  draft.column = rule.column;
  draft.new_identifiers.assign(rule.new_identifiers.begin(), rule.new_identifiers.end());
  for (const Condition& condition : rule.conditions) {
    draft.conditions.Add(arena.New(ToDraft(condition, arena)));
  }
  for (const Action& action : rule.actions) {
    draft.actions.Add(arena.New(ToDraft(action, arena)));
  }
  return draft;
}

Symbol EqualitySymbol(const Test& test) {
  if (test.kind == TestKind::kEqual) {
    return test.referent();
  }
  for (const Test& part : test.parts()) {
    if (part.kind == TestKind::kEqual) {
      return part.referent();
    }
  }
  return {};
}

}  // namespace soarbox::kernel
