// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

/// The parts of a test as a list, whatever its form.
DraftList<TestDraft> PartsOf(const TestDraft& test, Arena& arena);
/// The test with these parts: blank, the part itself, or a conjunction.
TestDraft JoinParts(const DraftList<TestDraft>& parts);

/// Tests that were removed from the fields of a list of conditions and wait until both their sides are bound: the
/// symbol that their field equals, and their referent. PutBack then adds them to the field that was bound last, turned
/// round if that is the referent's.
class WaitingTests {
 public:
  explicit WaitingTests(Arena& arena) : arena_(arena) {}

  /// Removes nothing: the caller has removed the test from a field that equals `field`.
  void Save(Symbol field, std::uint32_t field_variable, const TestDraft& test);

  bool empty() const { return unplaced_ == 0; }

  /// Adds to `test` all waiting tests that are decided now that its field is bound, in text order. Equal tests are
  /// added once; disjunctions are replaced by one of their common values. `bound`: the set of bound variables, which
  /// contains kNoVariable.
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

  /// Above this number, tests are looked up by symbol.
  static constexpr std::size_t kFew = 32;

  /// The saved tests that a field with this symbol may decide, in text order: all if there are few. Of many, only those
  /// that name the symbol, and only for its first field, because a test is decided as soon as both sides are bound.
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
  /// If there are many saved tests: by symbol and in text order those that name it; null once they were tried.
  std::vector<std::tuple<std::uint32_t, std::uint32_t, SavedTest*>> tests_of_;
  std::vector<SavedTest*> candidates_;  ///< Scratch of FirstWith.
  std::size_t candidate_ = 0;
  std::vector<TestDraft*> placed_;  ///< Scratch of PutBack.
};

}  // namespace soarbox::kernel
