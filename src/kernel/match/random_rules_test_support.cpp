// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/match/random_rules_test_support.h"

namespace soarbox::kernel {

RandomRules::RandomRules(MatchFixture& fixture, std::uint32_t seed) : fixture_(fixture), random_(seed) {
  for (const char* id : {"S1", "S2", "A1", "B1"}) {
    ids_.push_back(fixture.Word(id));
  }
  fixture.SetGoal("S1", 1);
  fixture.SetGoal("S2", 2);
  fixture.SetLti("A1", 7);
  fixture.SetLti("B1", 3);
  for (const char* attribute : {"a", "b", "operator"}) {
    attributes_.push_back(fixture.Word(attribute));
  }
  for (const char* constant : {"1", "2", "3", "2.5", "x", "a"}) {
    constants_.push_back(fixture.Word(constant));
  }
  values_ = constants_;
  values_.insert(values_.end(), ids_.begin(), ids_.end());
}

RandomRules::Triple RandomRules::NextTriple() {
  return {Pick(ids_), Pick(attributes_), Below(2) == 0 ? Pick(ids_) : Pick(values_), Below(8) == 0};
}

Symbol RandomRules::NewVariable() {
  return fixture_.symbols.Variable("<v" + std::to_string(next_variable_++) + ">");
}

TestDraft RandomRules::NextRelation(const std::vector<Symbol>& bound, const std::vector<Symbol>& constants) {
  constexpr TestKind kKinds[] = {TestKind::kNotEqual,    TestKind::kLess,           TestKind::kGreater,
                                 TestKind::kLessOrEqual, TestKind::kGreaterOrEqual, TestKind::kSameType,
                                 TestKind::kNotEqual,    TestKind::kSameLti,        TestKind::kNotSameLti,
                                 TestKind::kIsLti,       TestKind::kIsNotLti,       TestKind::kDisjunction};
  TestDraft test;
  test.kind = kKinds[Below(std::size(kKinds))];
  if (test.kind == TestKind::kDisjunction) {
    test = OneOf({Pick(constants), Pick(constants)});
  } else if (test.kind == TestKind::kSameLti || test.kind == TestKind::kNotSameLti) {
    test.referent = bound.empty() || Below(2) == 0 ? fixture_.Word("7") : Pick(bound);
  } else if (test.kind != TestKind::kIsLti && test.kind != TestKind::kIsNotLti) {
    test.referent = bound.empty() || Below(2) == 0 ? Pick(constants) : Pick(bound);
  }
  return test;
}

TestDraft RandomRules::NextTest(std::vector<Symbol>& bound, std::vector<Symbol>& fresh,
                                const std::vector<Symbol>& constants, bool may_bind) {
  const auto equality = [&]() -> TestDraft {
    switch (Below(3)) {
      case 0:
        return Equal(Pick(constants));
      case 1:
        if (!bound.empty()) {
          return Equal(Pick(bound));
        }
        [[fallthrough]];
      default: {
        if (!may_bind) {
          return Equal(Pick(constants));
        }
        const Symbol variable = NewVariable();
        fresh.push_back(variable);
        bound.push_back(variable);
        return Equal(variable);
      }
    }
  };
  switch (Below(6)) {
    case 0:
      return TestDraft();
    case 1:
      return NextRelation(bound, constants);
    case 2: {
      TestDraft first = equality();
      return Both(first, NextRelation(bound, constants));
    }
    default:
      return equality();
  }
}

ConditionDraft RandomRules::NextCondition(std::vector<Symbol>& bound, int depth) {
  const std::uint32_t kind = Below(10);
  if (kind < 2 && depth < 3 && !bound.empty()) {
    std::vector<Symbol> inner = bound;
    std::vector<ConditionDraft> conditions;
    const std::uint32_t count = 1 + Below(3);
    for (std::uint32_t n = 0; n < count; ++n) {
      conditions.push_back(NextCondition(inner, depth + 1));
    }
    return Conjunction(conditions);
  }
  std::vector<Symbol> inner = bound;
  std::vector<Symbol> fresh;
  ConditionDraft condition;
  condition.kind = kind < 5 && !bound.empty() ? ConditionKind::kNegative : ConditionKind::kPositive;
  if (!inner.empty() && Below(8) != 0) {
    condition.id = Equal(Pick(inner));
  } else {
    condition.id = NextTest(inner, fresh, ids_, true);
  }
  if (Below(6) == 0) {
    condition.id =
        condition.id.kind == TestKind::kEqual ? Both(condition.id, Relation(TestKind::kState, Symbol())) : condition.id;
  }
  condition.attribute = Below(5) == 0 ? NextTest(inner, fresh, attributes_, true) : Equal(Pick(attributes_));
  condition.value = NextTest(inner, fresh, Below(2) == 0 ? values_ : constants_, true);
  condition.tests_acceptable = Below(8) == 0;
  if (condition.kind == ConditionKind::kPositive) {
    bound = std::move(inner);
  }
  return condition;
}

ProductionPtr RandomRules::NextRule(std::string name) {
  std::vector<Symbol> bound;
  std::vector<ConditionDraft> conditions;
  const std::uint32_t count = 1 + Below(6);
  for (std::uint32_t n = 0; n < count; ++n) {
    conditions.push_back(NextCondition(bound, 0));
  }
  return Rule(std::move(name), conditions);
}

}  // namespace soarbox::kernel
