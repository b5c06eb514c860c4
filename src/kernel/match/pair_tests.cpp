// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/pair_tests.h"

#include <algorithm>
#include <compare>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

namespace {

std::strong_ordering CompareSymbols(const SymbolTable& symbols, std::uint32_t left, std::uint32_t right) {
  if (AreSmallIntegers(left, right)) {
    return static_cast<std::int32_t>(left << 3) <=> static_cast<std::int32_t>(right << 3);
  }
  return symbols.Compare(Symbol::FromBits(left), Symbol::FromBits(right));
}

}  // namespace

/// One test that Compare does not decide.
bool PairTests::PassesTest(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const {
  const std::uint32_t value = BitsOf(wme, test.field);
  std::uint32_t referent = test.referent;
  if (test.against_binding) {
    referent = test.levels == 0 ? BitsOf(wme, test.referent_field)
                                : BitsOf(wmes_.data()[ElementAt(tokens_.records(), parent, left, test.levels - 1u)],
                                         test.referent_field);
  }
  bool passed = false;
  switch (test.op) {
    case TestOp::kEqual:
    case TestOp::kNotEqual:
      break;  // Compare decides these.
    case TestOp::kLess:
      passed = CompareSymbols(symbols_, value, referent) < 0;
      break;
    case TestOp::kGreater:
      passed = CompareSymbols(symbols_, value, referent) > 0;
      break;
    case TestOp::kLessOrEqual:
      passed = CompareSymbols(symbols_, value, referent) <= 0;
      break;
    case TestOp::kGreaterOrEqual:
      passed = CompareSymbols(symbols_, value, referent) >= 0;
      break;
    case TestOp::kSameType:
      passed = Symbol::FromBits(value).kind() == Symbol::FromBits(referent).kind();
      break;
    case TestOp::kDisjunction: {
      const std::uint32_t* first = network_->disjuncts(test);
      passed = std::find(first, first + test.count, value) != first + test.count;
      break;
    }
    case TestOp::kIsGoal:
      passed = goals_.LevelOf(Symbol::FromBits(value)) != 0;
      break;
    case TestOp::kNever:
      passed = false;
      break;
    case TestOp::kSameLti:
    case TestOp::kNotSameLti: {
      const Symbol other = Symbol::FromBits(referent);
      const std::uint64_t lti = goals_.LtiOf(Symbol::FromBits(value));
      const std::uint64_t wanted =
          other.IsInteger() ? static_cast<std::uint64_t>(symbols_.IntegerValue(other)) : goals_.LtiOf(other);
      passed = (lti != 0 && lti == wanted) == (test.op == TestOp::kSameLti);
      break;
    }
    case TestOp::kIsLti:
      passed = goals_.LtiOf(Symbol::FromBits(value)) != 0;
      break;
    case TestOp::kIsNotLti:
      passed = goals_.LtiOf(Symbol::FromBits(value)) == 0;
      break;
  }
  return passed;
}

bool PairTests::PassesOne(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const {
  bool decided;
  return Compare(tokens_, wmes_, test, parent, left, wme, decided) || (!decided && PassesTest(test, parent, left, wme));
}

bool PairTests::Passes(const Node& node, std::uint32_t parent, std::uint32_t left, const Wme& wme) const {
  return std::ranges::all_of(network_->tests(node),
                             [&](const NodeTest& test) { return PassesOne(test, parent, left, wme); });
}

}  // namespace soarbox::kernel
