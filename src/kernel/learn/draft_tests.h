// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/bump_arena.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/learn/identity_plan.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/production.h"

/// Functions that read the tests of rules and build those of learned rules.
namespace soarbox::kernel {

/// Calls visit(part) for each elementary test of a field.
template <typename Visit>
void ForEachTest(const Test& test, Visit&& visit) {
  if (test.kind != TestKind::kConjunction) {
    visit(test);
    return;
  }
  for (const Test& part : test.parts()) visit(part);
}

/// Calls visit(test) for each elementary test of a condition, in an order that is the same for all its instances.
template <typename Visit>
void ForEachTest(TestDraft& test, Visit&& visit) {
  if (test.kind != TestKind::kConjunction) visit(test);
  for (TestDraft& part : test.parts) ForEachTest(part, visit);
}
template <typename Visit>
void ForEachTest(ConditionDraft& condition, Visit&& visit) {
  for (TestDraft* test : {&condition.id, &condition.attribute, &condition.value}) ForEachTest(*test, visit);
  for (ConditionDraft& inner : condition.conditions) ForEachTest(inner, visit);
}

/// Returns true for tests other than equality: comparisons, types, disjunctions, long-term links.
constexpr bool IsCarried(TestKind kind) {
  return kind != TestKind::kBlank && kind != TestKind::kEqual && kind != TestKind::kConjunction &&
         kind != TestKind::kState && kind != TestKind::kImpasse && kind != TestKind::kLiteral;
}

inline bool Contains(const std::vector<Symbol>& symbols, Symbol symbol) {
  return std::ranges::find(symbols, symbol) != symbols.end();
}
/// The value of a class of conditions in the firing that matched `matched`.
Symbol ValueOfClass(const IdentityPlan& plan, std::uint16_t identity_class, std::span<const ConditionTrace> matched,
                    const WorkingMemory& memory);
void AppendPart(TestDraft& test, TestDraft* part, Arena& arena);
void PrependPart(TestDraft& test, TestDraft* part, Arena& arena);
/// If `other` is a disjunction and `kept` contains one, reduces that of `kept` to the common values and returns true.
/// Else returns false.
bool UniteDisjunctions(TestDraft& kept, const TestDraft& other, Arena& arena);
/// Adds the tests of `other` to those of `kept`, which tests the same value. Returns the number of disjunctions that
/// were merged.
std::uint32_t UniteTests(TestDraft& kept, TestDraft& other, Arena& arena);

}  // namespace soarbox::kernel
