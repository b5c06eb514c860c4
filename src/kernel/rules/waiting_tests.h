// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

/// The parts of a test as a list; a single test is a list of one.
DraftList<TestDraft> PartsOf(const TestDraft& test, Arena& arena);
/// Builds a test from parts: blank if there are none, the part itself if there is one, else a conjunction.
TestDraft JoinParts(const DraftList<TestDraft>& parts);

/// Tests that were removed from conditions and wait until both sides are bound: the symbol of their field, and their
/// referent. PutBack adds them to the field that is bound last. If that is the referent's field, their sides are
/// swapped.
class WaitingTests {
 public:
  explicit WaitingTests(Arena& arena) : arena_(arena) {}

  /// The caller must have removed the test from a field that equals `field`.
  void Save(Symbol field, std::uint32_t field_variable, const TestDraft& test);

  bool empty() const { return unplaced_ == 0; }

  /// The field of `test` has just been bound. Adds to it, in text order, all waiting tests that can now be decided.
  /// Equal tests are added once. Several disjunctions are replaced by one with their common values. `bound` is the set
  /// of bound variables; it must contain kNoVariable.
  template <typename Set>
  void PutBack(TestDraft& test, const Set& bound) {
    const Symbol symbol = EqualitySymbol(test);
    placed_.clear();
    for (SavedTest* saved = FirstThatMayBe(symbol); saved != nullptr; saved = NextThatMayBe(*saved)) {
      if (saved->placed) continue;
      const Symbol referent = saved->test.referent;
      if (saved->field == symbol && bound.Has(saved->test.variable)) {
        placed_.push_back(arena_.New(saved->test));
      } else if (referent == symbol && referent.IsVariable() && bound.Has(saved->field_variable)) {
        placed_.push_back(Turned(*saved));
      } else {
        continue;
      }
      saved->placed = true;
      --unplaced_;
    }
    if (!placed_.empty()) AddPlaced(test);
  }

 private:
  struct SavedTest {
    Symbol field;  ///< The symbol that the test's field equals.
    std::uint32_t field_variable = kNoVariable;
    TestDraft test;
    bool placed = false;
    SavedTest* next = nullptr;
  };

  /// With this number of tests or more, tests are looked up by symbol.
  static constexpr std::size_t kFew = 32;

  /// Iterates over the saved tests that a field with this symbol may decide, in text order. If there are few tests,
  /// iterates over all of them. Else only over those that name the symbol, and only for the first field with it: a test
  /// is decided as soon as both sides are bound.
  SavedTest* FirstThatMayBe(Symbol symbol) { return count_ < kFew ? saved_.first : FirstWith(symbol); }
  SavedTest* NextThatMayBe(const SavedTest& saved) {
    if (count_ < kFew) return saved.next;
    return ++candidate_ < candidates_.size() ? candidates_[candidate_] : nullptr;
  }
  SavedTest* FirstWith(Symbol symbol);
  TestDraft* Turned(const SavedTest& saved);
  void AddPlaced(TestDraft& test);

  Arena& arena_;
  DraftList<SavedTest> saved_;
  std::size_t count_ = 0;
  std::size_t unplaced_ = 0;
  /// If there are many saved tests: those that name a symbol, by symbol and text order. Null after they were tried.
  std::vector<std::tuple<std::uint32_t, std::uint32_t, SavedTest*>> tests_of_;
  std::vector<SavedTest*> candidates_;  ///< Scratch of FirstWith.
  std::size_t candidate_ = 0;
  std::vector<TestDraft*> placed_;  ///< Scratch of PutBack.
};

}  // namespace soarbox::kernel
