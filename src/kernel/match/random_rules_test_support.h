// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <random>
#include <vector>

#include "kernel/match/match_test_support.h"

namespace soarbox::kernel {

/// Generates random rules and elements with few identifiers, attributes and values. Therefore many rules match, and an
/// element often matches twice in a rule. Equal seeds give equal results.
class RandomRules {
 public:
  RandomRules(MatchFixture& fixture, std::uint32_t seed);

  ProductionPtr NextRule(std::string name);
  struct Triple {
    Symbol id, attribute, value;
    bool acceptable = false;
  };
  Triple NextTriple();
  std::uint32_t Below(std::uint32_t limit) { return random_() % limit; }

 private:
  ConditionDraft NextCondition(std::vector<Symbol>& bound, int depth);
  TestDraft NextTest(std::vector<Symbol>& bound, std::vector<Symbol>& fresh, const std::vector<Symbol>& constants,
                     bool may_bind);
  TestDraft NextRelation(const std::vector<Symbol>& bound, const std::vector<Symbol>& constants);
  Symbol Pick(const std::vector<Symbol>& from) { return from[Below(static_cast<std::uint32_t>(from.size()))]; }
  Symbol NewVariable();

  MatchFixture& fixture_;
  std::mt19937 random_;
  std::vector<Symbol> ids_, attributes_, constants_, values_;
  std::uint32_t next_variable_ = 0;
};

}  // namespace soarbox::kernel
