// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/draft_tests.h"

#include <algorithm>

namespace soarbox::kernel {

Symbol ValueOfClass(const IdentityPlan& plan, std::uint16_t identity_class, std::span<const ConditionTrace> matched,
                    const WorkingMemory& memory) {
  const std::uint16_t place = plan.first[identity_class];
  return FieldOf(memory.wme(matched[place / 3u].wme), static_cast<Field>(place % 3u));
}

namespace {

void MakeConjunction(TestDraft& test, Arena& arena) {
  if (test.kind == TestKind::kConjunction) return;
  TestDraft* const single = arena.New(test);
  test = MakeTest(TestKind::kConjunction);
  test.parts.Add(single);
}

}  // namespace

void AppendPart(TestDraft& test, TestDraft* part, Arena& arena) {
  MakeConjunction(test, arena);
  test.parts.Add(part);
}

void PrependPart(TestDraft& test, TestDraft* part, Arena& arena) {
  MakeConjunction(test, arena);
  part->next = test.parts.first;
  test.parts.first = part;
}

bool UniteDisjunctions(TestDraft& kept, const TestDraft& other, Arena& arena) {
  if (other.kind != TestKind::kDisjunction) return false;
  for (TestDraft& mine : kept.parts) {
    if (mine.kind != TestKind::kDisjunction) continue;
    Symbol* const common = arena.NewArray<Symbol>(mine.disjunct_count);
    std::uint32_t count = 0;
    for (std::uint32_t n = 0; n < mine.disjunct_count; ++n) {
      if (std::find(other.disjuncts, other.disjuncts + other.disjunct_count, mine.disjuncts[n]) !=
          other.disjuncts + other.disjunct_count) {
        common[count++] = mine.disjuncts[n];
      }
    }
    mine.disjuncts = common;
    mine.disjunct_count = count;
    return true;
  }
  return false;
}

std::uint32_t UniteTests(TestDraft& kept, TestDraft& other, Arena& arena) {
  std::uint32_t merged = 0;
  if (other.kind != TestKind::kConjunction) return merged;
  for (TestDraft* part = other.parts.first; part != nullptr;) {
    TestDraft* const next = part->next;
    bool known = part->kind == TestKind::kEqual;
    for (const TestDraft& mine : kept.parts) known = known || mine == *part;
    if (!known) {
      if (UniteDisjunctions(kept, *part, arena)) {
        ++merged;
      } else {
        PrependPart(kept, part, arena);
      }
    }
    part = next;
  }
  return merged;
}

}  // namespace soarbox::kernel
