// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "kernel/base/bump_arena.h"
#include "kernel/rules/production.h"

/// Rules as mutable trees, while they are read, checked, reordered or derived from others. They are allocated in an
/// arena. Production::Make converts a draft to a finished rule.
namespace soarbox::kernel {

/// A list of items, linked through their `next`. Copies of a list share the items.
template <typename T>
struct DraftList {
  T* first = nullptr;
  T* last = nullptr;

  class Iterator {
   public:
    explicit Iterator(T* item) : item_(item) {}
    T& operator*() const { return *item_; }
    Iterator& operator++() {
      item_ = item_->next;
      return *this;
    }
    bool operator!=(const Iterator& other) const { return item_ != other.item_; }

   private:
    T* item_;
  };
  Iterator begin() const { return Iterator(first); }
  Iterator end() const { return Iterator(nullptr); }
  bool empty() const { return first == nullptr; }
  std::uint32_t Count() const {
    std::uint32_t count = 0;
    for (const T* item = first; item != nullptr; item = item->next) {
      ++count;
    }
    return count;
  }
  /// The item must not be in another list.
  void Add(T* item) {
    item->next = nullptr;
    (first == nullptr ? first : last->next) = item;
    last = item;
  }
  void Append(const DraftList& other) {
    if (other.first == nullptr) {
      return;
    }
    (first == nullptr ? first : last->next) = other.first;
    last = other.last;
  }
};

/// The variables of a rule are numbered from 0 (VariableIndex). This value means "a constant or nothing".
inline constexpr std::uint32_t kNoVariable = 0xFFFFFFFFu;

/// A constant or variable as a rule names it.
struct Term {
  Symbol symbol;
  std::uint32_t variable = kNoVariable;  ///< Its number, if it is a variable.

  Term() = default;
  Term(Symbol term, std::uint32_t number = kNoVariable) : symbol(term), variable(number) {}
};

struct TestDraft {
  TestKind kind = TestKind::kBlank;
  std::uint32_t disjunct_count = 0;
  std::uint32_t variable = kNoVariable;  ///< The referent's number.
  bool is_turned = false;  ///< Reordering moved this test to the field of its referent. Equality ignores this flag.
  Symbol referent;         ///< Constant or variable, for the relational kinds and @.
  const Symbol* disjuncts = nullptr;  ///< kDisjunction.
  DraftList<TestDraft> parts;         ///< kConjunction; never nested, at most one part is kEqual.
  TestDraft* next = nullptr;
};
bool operator==(const TestDraft& a, const TestDraft& b);

struct ConditionDraft {
  ConditionKind kind = ConditionKind::kPositive;
  bool tests_acceptable = false;
  TestDraft id, attribute, value;
  DraftList<ConditionDraft> conditions;  ///< kConjunctiveNegation.
  ConditionDraft* next = nullptr;
};
bool operator==(const ConditionDraft& a, const ConditionDraft& b);

struct ValueDraft {
  RhsValueKind kind = RhsValueKind::kConstant;
  BindingSite site;                      ///< kBound.
  std::uint16_t index = 0;               ///< kNew: of the new identifier; kFunction: of the function.
  std::uint32_t variable = kNoVariable;  ///< The symbol's number.
  Symbol symbol;
  DraftList<ValueDraft> arguments;  ///< kFunction.
  ValueDraft* next = nullptr;
};

struct ActionDraft {
  bool is_function_call = false;
  PreferenceType preference = PreferenceType::kAcceptable;
  ValueDraft id, attribute, value;
  ValueDraft referent;
  ActionDraft* next = nullptr;

  bool HasReferent() const { return kernel::HasReferent(preference); }
};

struct RuleDraft {
  std::string_view name;  ///< Valid as long as the arena.
  std::string_view documentation;
  bool has_documentation = false;
  ProductionType type = ProductionType::kUser;
  DeclaredSupport declared_support = DeclaredSupport::kUndeclared;
  bool interrupt = false;
  bool explain = false;
  bool is_rl = false;
  bool keeps_order = false;  ///< The conditions are in match order already; reordering only moves their tests.
  DraftList<ConditionDraft> conditions;
  DraftList<ActionDraft> actions;
  std::vector<Symbol> new_identifiers;
  FileName file;
  int line = 0, column = 0;
};

/// A test of one symbol.
inline TestDraft MakeTest(TestKind kind, Term referent = {}) {
  TestDraft test;
  test.kind = kind;
  test.referent = referent.symbol;
  test.variable = referent.variable;
  return test;
}

/// Deep copies.
TestDraft Copy(const TestDraft& test, Arena& arena);
ConditionDraft Copy(const ConditionDraft& condition, Arena& arena);
ValueDraft Copy(const ValueDraft& value, Arena& arena);
TestDraft ToDraft(const Test& test, Arena& arena);
ConditionDraft ToDraft(const Condition& condition, Arena& arena);
ValueDraft ToDraft(const RhsValue& value, Arena& arena);
ActionDraft ToDraft(const Action& action, Arena& arena);
/// Converts a complete rule. The draft refers to the rule's texts, so the rule must outlive it. Its variables have no
/// numbers.
RuleDraft ToDraft(const Production& rule, Arena& arena);

/// The equality part of a test, or null.
inline const TestDraft* EqualityIn(const TestDraft& test) {
  if (test.kind == TestKind::kEqual) {
    return &test;
  }
  for (const TestDraft& part : test.parts) {
    if (part.kind == TestKind::kEqual) {
      return &part;
    }
  }
  return nullptr;
}
/// The variable or constant in the equality part of a test; none without such a part.
inline Symbol EqualitySymbol(const TestDraft& test) {
  const TestDraft* const equality = EqualityIn(test);
  return equality != nullptr ? equality->referent : Symbol();
}
/// The number of that variable; kNoVariable if there is none.
inline std::uint32_t EqualityVariable(const TestDraft& test) {
  const TestDraft* const equality = EqualityIn(test);
  return equality != nullptr ? equality->variable : kNoVariable;
}
Symbol EqualitySymbol(const Test& test);

}  // namespace soarbox::kernel
