// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/waiting_tests.h"

#include <algorithm>

namespace soarbox::kernel {
namespace {

/// Removes from a disjunction the values that are not in another one.
void KeepCommon(TestDraft& test, const TestDraft& other, Arena& arena) {
  Symbol* const common = arena.NewArray<Symbol>(test.disjunct_count);
  Symbol* const end = std::copy_if(test.disjuncts, test.disjuncts + test.disjunct_count, common, [&](Symbol symbol) {
    const Symbol* const last = other.disjuncts + other.disjunct_count;
    return std::find(other.disjuncts, last, symbol) != last;
  });
  test.disjuncts = common;
  test.disjunct_count = static_cast<std::uint32_t>(end - common);
}

}  // namespace

DraftList<TestDraft> PartsOf(const TestDraft& test, Arena& arena) {
  if (test.kind == TestKind::kConjunction) return test.parts;
  DraftList<TestDraft> parts;
  if (test.kind != TestKind::kBlank) parts.Add(arena.New(test));
  return parts;
}

TestDraft JoinParts(const DraftList<TestDraft>& parts) {
  TestDraft test;
  if (parts.first == parts.last) {
    if (parts.first != nullptr) test = *parts.first;
    return test;
  }
  test.kind = TestKind::kConjunction;
  test.parts = parts;
  return test;
}

void WaitingTests::Save(Symbol field, std::uint32_t field_variable, const TestDraft& test) {
  SavedTest saved;
  saved.field = field;
  saved.field_variable = field_variable;
  saved.test = test;
  saved_.Add(arena_.New(saved));
  ++unplaced_;
  ++count_;
}

WaitingTests::SavedTest* WaitingTests::FirstWith(Symbol symbol) {
  if (tests_of_.empty()) {
    std::uint32_t number = 0;
    for (SavedTest& saved : saved_) {
      tests_of_.emplace_back(saved.field.bits(), number, &saved);
      if (saved.test.referent != saved.field) tests_of_.emplace_back(saved.test.referent.bits(), number, &saved);
      ++number;
    }
    std::ranges::sort(tests_of_);
  }
  const std::tuple<std::uint32_t, std::uint32_t, SavedTest*> first{symbol.bits(), 0, nullptr};
  candidates_.clear();
  for (auto at = std::ranges::lower_bound(tests_of_, first); at != tests_of_.end(); ++at) {
    auto& [bits, number, saved] = *at;
    if (bits != symbol.bits()) break;
    if (saved != nullptr) candidates_.push_back(saved);
    saved = nullptr;
  }
  candidate_ = 0;
  return candidates_.empty() ? nullptr : candidates_.front();
}

/// The test with swapped sides.
TestDraft* WaitingTests::Turned(const SavedTest& saved) {
  TestDraft turned = saved.test;
  turned.kind = TurnedRound(turned.kind);
  turned.is_turned = true;
  turned.referent = saved.field;
  turned.variable = saved.field_variable;
  return arena_.New(turned);
}

void WaitingTests::AddPlaced(TestDraft& test) {
  DraftList<TestDraft> parts = PartsOf(test, arena_);
  for (std::size_t at = placed_.size(); at-- > 0;) {
    TestDraft& part = *placed_[at];
    TestDraft* known = parts.first;
    while (known != nullptr && !(*known == part) &&
           (known->kind != TestKind::kDisjunction || part.kind != TestKind::kDisjunction)) {
      known = known->next;
    }
    if (known == nullptr) {
      DraftList<TestDraft> front;
      front.Add(&part);
      front.Append(parts);
      parts = front;
    } else if (part.kind == TestKind::kDisjunction) {
      KeepCommon(*known, part, arena_);
    }
  }
  test = JoinParts(parts);
}

}  // namespace soarbox::kernel
