// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "kernel/match/match_test_support.h"
#include "kernel/match/naive_matcher_test_support.h"
#include "kernel/match/random_rules_test_support.h"

namespace soarbox::kernel {
namespace {

/// Random rules and random changes. After each step, the Rete must agree with the naive matcher, its conflict set with
/// the reported changes, and its structures with their invariants. Optionally, a rule is excised and added again before
/// each step. Memories park pairs much sooner than usual.
class RandomCase {
 public:
  RandomCase(std::uint32_t seed, bool swap_rules) : random_(fixture_, seed), seed_(seed), swap_rules_(swap_rules) {}

  void Run(int steps) {
    fixture_.rete.ParkAfter(1 + seed_ % 4);
    fixture_.rete.BusyFrom(1 + seed_ % 3);
    for (int n = 0; n < 3; ++n) {
      AddRule();
    }
    for (step_ = 0; step_ < steps && !testing::Test::HasFailure(); ++step_) {
      if (swap_rules_ && !rules_.empty()) SwapRule();
      Change();
      Check();
    }
  }

 private:
  void SwapRule() {
    const std::size_t n = random_.Below(static_cast<std::uint32_t>(rules_.size()));
    const ProductionPtr rule = fixture_.rete.production(rules_[n]);
    fixture_.rete.ExciseProduction(rules_[n]);
    rules_.erase(rules_.begin() + static_cast<std::ptrdiff_t>(n));
    Check();
    const Rete::Added added = fixture_.rete.AddProduction(rule, fixture_.Goals());
    if (added.result == Rete::AddResult::kAdded) rules_.push_back(added.production);
    Check();
  }

  void AddRule() {
    const Rete::Added added =
        fixture_.rete.AddProduction(random_.NextRule("rule" + std::to_string(next_rule_++)), fixture_.Goals());
    if (added.result == Rete::AddResult::kAdded) {
      rules_.push_back(added.production);
    }
  }

  void Change() {
    switch (random_.Below(20)) {
      case 0:
        AddRule();
        break;
      case 1:
        if (rules_.size() > 1) {
          const std::size_t n = random_.Below(static_cast<std::uint32_t>(rules_.size()));
          fixture_.rete.ExciseProduction(rules_[n]);
          rules_.erase(rules_.begin() + static_cast<std::ptrdiff_t>(n));
        }
        break;
      case 2:
        Fire();
        break;
      case 3:
        if (random_.Below(6) == 0) {
          fixture_.rete.Clear();
          fixture_.live.clear();
          fired_.clear();
        }
        break;
      default:
        if (fixture_.live.size() > 40 || (!fixture_.live.empty() && random_.Below(8) < 3)) {
          fixture_.Remove(fixture_.live[random_.Below(static_cast<std::uint32_t>(fixture_.live.size()))]);
        } else {
          const RandomRules::Triple t = random_.NextTriple();
          const bool present = std::ranges::any_of(fixture_.live, [&](WmeId wme) {
            const Wme& w = fixture_.wmes[Index(wme)];
            return w.id == t.id && w.attribute == t.attribute && w.value == t.value && w.acceptable == t.acceptable;
          });
          if (!present) {
            fixture_.Add(t.id, t.attribute, t.value, t.acceptable);
          }
        }
    }
  }

  std::vector<std::uint64_t> Tags(MatchId match) const {
    std::vector<std::uint64_t> tags;
    for (const WmeId wme : fixture_.rete.Wmes(match)) {
      tags.push_back(fixture_.wmes[Index(wme)].timetag);
    }
    return tags;
  }

  /// Processes the conflict set as the decision cycle does: fired matches are stored until they are retracted.
  void Fire() {
    MatchSet& set = fixture_.rete.matches();
    for (GoalLevel level = 0; level < 4; ++level) {
      while (set.HasRetractions(level)) {
        const MatchId match = set.TakeRetraction(level);
        ASSERT_EQ(fired_.erase(match), 1u) << "retraction of something that did not fire, seed " << seed_;
        set.Release(match);
      }
      while (const PendingMatch taken = set.TakeAssertion(level, false)) {
        set.MarkFired(taken.match, SomeInstantiation(0));
        fired_[taken.match] = {taken.production, Tags(taken.match)};
      }
    }
  }

  void Check() {
    ASSERT_EQ(fixture_.rete.CheckInvariants(), "") << "seed " << seed_ << " step " << step_;
    std::map<ProductionId, std::multiset<std::vector<std::uint64_t>>> in_set;
    for (const PendingMatch& pending : fixture_.rete.matches().Pending(MatchSet::List::kIAssertions)) {
      in_set[pending.production].insert(Tags(pending.match));
    }
    for (const auto& [match, fired] : fired_) {
      if (fixture_.rete.matches().StateOf(match) == MatchState::kFired) {
        in_set[fired.first].insert(fired.second);
      }
    }
    for (const ProductionId rule : rules_) {
      const auto wanted = MatchNaively(*fixture_.rete.production(rule), fixture_.symbols, fixture_.wmes, fixture_.live,
                                       fixture_.Goals());
      ASSERT_EQ(fixture_.MatchesOf(rule), wanted) << "seed " << seed_ << " step " << step_;
      ASSERT_EQ(in_set[rule], wanted) << "conflict set, seed " << seed_ << " step " << step_;
    }
  }

  MatchFixture fixture_;
  RandomRules random_;
  std::uint32_t seed_;
  bool swap_rules_;
  int step_ = 0;
  int next_rule_ = 0;
  std::vector<ProductionId> rules_;
  std::map<MatchId, std::pair<ProductionId, std::vector<std::uint64_t>>> fired_;
};

#ifdef SOARBOX_CHECK_INVARIANTS
constexpr std::uint32_t kSlowness = 10;  // Such builds also use sanitizers.
#else
constexpr std::uint32_t kSlowness = 1;
#endif

void RunSeeds(std::uint32_t first, std::uint32_t count, bool swap_rules) {
  count /= kSlowness;
  for (std::uint32_t seed = first; seed < first + count && !testing::Test::HasFailure(); ++seed) {
    RandomCase(seed, swap_rules).Run(150);
  }
}

TEST(ReteAgainstNaiveMatcher, AgreesOnRandomRulesAndChangesA) {
  RunSeeds(1, 1500, false);
}
TEST(ReteAgainstNaiveMatcher, AgreesOnRandomRulesAndChangesB) {
  RunSeeds(100'000, 1500, false);
}
TEST(ReteAgainstNaiveMatcher, AgreesOnRandomRulesAndChangesC) {
  RunSeeds(200'000, 1500, false);
}
TEST(ReteAgainstNaiveMatcher, AgreesWhileRulesGoAndComeAtEveryStep) {
  RunSeeds(300'000, 1000, true);
}

}  // namespace
}  // namespace soarbox::kernel
