// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "kernel/match/match_test_support.h"
#include "kernel/match/naive_matcher_test_support.h"

namespace soarbox::kernel {
namespace {

/// Random rules with conjunctive negations that are paths, in two Retes: one shares the conjunctions, the other does
/// not. Both must report the same matches in the same order.
class TwoWays {
 public:
  explicit TwoWays(std::uint32_t seed) : seed_(seed), random_(seed) {
    alone_.rete.ShareConjunctions(false);
    for (MatchFixture* fixture : {&shared_, &alone_}) {
      fixture->rete.ParkAfter(1 + seed % 5);
      fixture->rete.BusyFrom(1 + seed % 3);
      fixture->SetGoal("S1", 1);
    }
  }

  /// Returns the number of shared conjunctions.
  std::size_t Run(int steps) {
    const int rules = 1 + Below(4);
    for (int n = 0; n < rules; ++n) AddRule();
    for (step_ = 0; step_ < steps && !failed_; ++step_) {
      if (Below(60) == 0) AddRule();
      if (Below(60) == 0 && rules_.size() > 1) ExciseRule();
      const int changes = 1 + Below(3);
      changed_.clear();
      for (int n = 0; n < changes; ++n) Change();
      Check();
    }
    return shared_.rete.statistics().shared_conjunctions;
  }

 private:
  int Below(int limit) { return static_cast<int>(random_() % static_cast<std::uint32_t>(limit)); }

  // Rules -----------------------------------------------------------------------------------------------------------

  struct Reach {
    std::string variable;
    char kind;  ///< s state, b board, x item, r number.
  };
  TestDraft V(MatchFixture& f, const std::string& word) { return Equal(f.Word(word)); }

  /// The attributes that link one kind of object to another.
  static std::pair<const char*, char> Step(char from, int pick) {
    if (from == 's') return {"board", 'b'};
    if (from == 'b') return {pick % 2 == 0 ? "slot" : "spare", 'x'};
    constexpr const char* kOfItem[] = {"rank", "zone", "used"};
    if (pick % 4 == 3) return {"next", 'x'};
    return {kOfItem[pick % 4], 'r'};
  }

  /// A positive condition on an object in scope; adds its value to the scope. The value may be a constant.
  struct Plan {
    std::string id, attribute, value;
    TestKind relation = TestKind::kEqual;
    bool negative = false;
  };
  Plan NextStep(std::vector<Reach>& reached, const Reach& from, int number, bool may_compare) {
    const auto [attribute, kind] = Step(from.kind, Below(8));
    Plan plan{from.variable, attribute, "<v" + std::to_string(number) + ">", TestKind::kEqual, false};
    if (kind == 'r' && may_compare && Below(8) != 0) {
      std::vector<std::string> numbers;
      for (const Reach& other : reached) {
        if (other.kind == 'r') numbers.push_back(other.variable);
      }
      plan.value = numbers.empty() || Below(8) == 0 ? std::to_string(Below(4)) : numbers[Below(numbers.size())];
      constexpr TestKind kKinds[] = {TestKind::kEqual, TestKind::kGreater, TestKind::kLess, TestKind::kNotEqual};
      plan.relation = kKinds[Below(4)];
    } else {
      reached.push_back({plan.value, kind});
    }
    return plan;
  }

  static ConditionDraft Draft(MatchFixture& f, const Plan& plan) {
    const TestDraft id = Equal(f.Word(plan.id)), attribute = Equal(f.Word(plan.attribute));
    const TestDraft value = Relation(plan.relation, f.Word(plan.value));
    return plan.negative ? Negative(id, attribute, value) : Positive(id, attribute, value);
  }

  void AddRule() {
    std::vector<Reach> reached = {{"<s>", 's'}};
    std::vector<std::vector<Plan>> plan;  // One condition, or the conditions of a conjunction.
    int number = 0;
    const int conditions = 3 + Below(5);
    bool negated = false;
    for (int n = 0; n < conditions; ++n) {
      const bool last = n + 1 == conditions;
      if (n > 1 && (Below(3) == 0 || (last && !negated))) {
        negated = true;
        std::vector<Reach> inside = reached;
        std::vector<Plan> path;
        Reach from = reached[Below(static_cast<int>(reached.size()))];
        while (from.kind == 'r') from = reached[Below(static_cast<int>(reached.size()))];
        if (Below(2) == 0 && reached[1].kind == 'b') from = reached[1];
        const int length = Below(6) == 0 ? 1 : 2 + Below(3);
        for (int k = 0; k < length && from.kind != 'r'; ++k) {
          const std::size_t before = inside.size();
          path.push_back(NextStep(inside, from, 100 * (n + 1) + k, true));
          if (inside.size() > before && inside.back().kind != 'r' && Below(5) != 0) from = inside.back();
        }
        if (path.size() == 1) path[0].negative = true;
        plan.push_back(path);
        continue;
      }
      Reach from = n == 0          ? reached[0]
                   : Below(2) == 0 ? reached.back()
                                   : reached[Below(static_cast<int>(reached.size()))];
      while (from.kind == 'r') from = reached[Below(static_cast<int>(reached.size()))];
      plan.push_back({NextStep(reached, from, number++, Below(8) == 0)});
    }
    const std::string name = "rule" + std::to_string(next_rule_++);
    Rete::Added added[2];
    for (int way = 0; way < 2; ++way) {
      MatchFixture& f = way == 0 ? shared_ : alone_;
      std::vector<ConditionDraft> drafts;
      for (const std::vector<Plan>& part : plan) {
        std::vector<ConditionDraft> inner;
        for (const Plan& condition : part) inner.push_back(Draft(f, condition));
        drafts.push_back(inner.size() == 1 ? inner[0] : Conjunction(inner));
      }
      drafts[0].id = Both(drafts[0].id, Relation(TestKind::kState, Symbol()));
      added[way] = f.rete.AddProduction(Rule(name, drafts), f.Goals());
    }
    ASSERT_EQ(added[0].result, added[1].result) << "seed " << seed_;
    if (added[0].result == Rete::AddResult::kAdded) rules_.push_back({added[0].production, added[1].production, plan});
  }

  void ExciseRule() {
    const std::size_t n = static_cast<std::size_t>(Below(static_cast<int>(rules_.size())));
    shared_.rete.ExciseProduction(rules_[n].in_shared);
    alone_.rete.ExciseProduction(rules_[n].in_alone);
    rules_.erase(rules_.begin() + static_cast<std::ptrdiff_t>(n));
  }

  // Elements --------------------------------------------------------------------------------------------------------

  void Change() {
    if (!shared_.live.empty() && (shared_.live.size() > 34 || Below(8) < 3)) {
      const auto n = static_cast<std::size_t>(Below(static_cast<int>(shared_.live.size())));
      changed_ += " -" + std::to_string(shared_.wmes[Index(shared_.live[n])].timetag);
      shared_.Remove(shared_.live[n]);
      alone_.Remove(alone_.live[n]);
      return;
    }
    constexpr const char* kBoards[] = {"B1", "B2"};
    constexpr const char* kItems[] = {"X1", "X2", "X3", "X4", "X5", "X6"};
    std::string id, attribute, value;
    switch (Below(10)) {
      case 0:
        id = "S1", attribute = "board", value = kBoards[Below(2)];
        break;
      case 1:
      case 2:
      case 3:
        id = kBoards[Below(2)], attribute = Below(4) == 0 ? "spare" : "slot", value = kItems[Below(6)];
        break;
      case 4:
        id = kItems[Below(6)], attribute = "next", value = kItems[Below(6)];
        break;
      default:
        id = kItems[Below(6)], attribute = Below(2) == 0 ? "rank" : Below(2) == 0 ? "zone" : "used";
        value = std::to_string(Below(4));
    }
    for (const WmeId wme : shared_.live) {
      const Wme& w = shared_.wmes[Index(wme)];
      if (w.id == shared_.Word(id) && w.attribute == shared_.Word(attribute) && w.value == shared_.Word(value)) return;
    }
    const WmeId made = shared_.Add(id, attribute, value);
    changed_ += " +" + std::to_string(shared_.wmes[Index(made)].timetag);
    alone_.Add(id, attribute, value);
  }

  // Comparing -------------------------------------------------------------------------------------------------------

  /// Takes the pending matches and describes them, in order.
  static std::vector<std::string> Take(MatchFixture& f) {
    std::vector<std::string> told;
    MatchSet& set = f.rete.matches();
    const auto tell = [&](const char* what, ProductionId rule, std::span<const WmeId> wmes) {
      std::string text = what + std::string(f.rete.production(rule)->name);
      for (const WmeId wme : wmes) text += " " + std::to_string(f.wmes[Index(wme)].timetag);
      told.push_back(text);
    };
    for (GoalLevel level = 0; level < 3; ++level) {
      while (const PendingMatch taken = set.TakeAssertion(level, false)) {
        tell("+", taken.production, set.Wmes(taken.match));
        set.MarkFired(taken.match, SomeInstantiation(0));
      }
      while (set.HasRetractions(level)) {
        const MatchId match = set.TakeRetraction(level);
        tell("-", set.Describe(match).production, set.Wmes(match));
        set.Release(match);
      }
    }
    return told;
  }

  void Check() {
    ASSERT_EQ(shared_.rete.CheckInvariants(), "") << "seed " << seed_ << " step " << step_;
    const std::vector<std::string> told = Take(shared_), wanted = Take(alone_);
    EXPECT_EQ(told, wanted) << "seed " << seed_ << " step " << step_ << "\n" << Story();
    if (told != wanted) failed_ = true;
    for (const Pair& rule : rules_) {
      ASSERT_EQ(shared_.MatchesOf(rule.in_shared),
                MatchNaively(*shared_.rete.production(rule.in_shared), shared_.symbols, shared_.wmes, shared_.live,
                             shared_.Goals()))
          << "seed " << seed_ << " step " << step_;
      for (std::uint16_t n = 0; n < rule.plan.size(); ++n) {
        for (std::uint16_t k = 0; rule.plan[n].size() > 1 && k < rule.plan[n].size(); ++k) {
          const std::vector<std::uint16_t> path = {n, k};
          ASSERT_EQ(Sorted(shared_.rete.MatchesAfter(rule.in_shared, path)),
                    Sorted(alone_.rete.MatchesAfter(rule.in_alone, path)))
              << "seed " << seed_ << " step " << step_;
          ASSERT_EQ(Sorted(shared_.rete.MatchesBefore(rule.in_shared, path)),
                    Sorted(alone_.rete.MatchesBefore(rule.in_alone, path)))
              << "seed " << seed_ << " step " << step_;
          ASSERT_EQ(shared_.rete.CountAfter(rule.in_shared, path), alone_.rete.CountAfter(rule.in_alone, path));
        }
      }
    }
  }

  /// The rules and elements, for the analysis of failures.
  std::string Story() {
    std::string text = "changes:" + changed_ + "\n";
    for (const Pair& rule : rules_) {
      text += std::string(shared_.rete.production(rule.in_shared)->name) + "\n";
      for (const std::vector<Plan>& part : rule.plan) {
        text += part.size() > 1 ? " -{" : part[0].negative ? " -" : " ";
        for (const Plan& c : part) {
          constexpr const char* kRelations[] = {"", "<> ", "< ", "> "};
          const std::size_t relation = c.relation == TestKind::kNotEqual  ? 1
                                       : c.relation == TestKind::kLess    ? 2
                                       : c.relation == TestKind::kGreater ? 3
                                                                          : 0;
          text += " (" + c.id + " ^" + c.attribute + " " + kRelations[relation] + c.value + ")";
        }
        text += "\n";
      }
    }
    for (const WmeId wme : shared_.live) {
      const Wme& w = shared_.wmes[Index(wme)];
      text += std::to_string(w.timetag) + ": " + ToString(shared_.symbols, w.id) + " " +
              ToString(shared_.symbols, w.attribute) + " " + ToString(shared_.symbols, w.value) + "\n";
    }
    return text;
  }

  static Rete::PartialMatches Sorted(Rete::PartialMatches matches) {
    std::sort(matches.begin(), matches.end());
    return matches;
  }

  struct Pair {
    ProductionId in_shared, in_alone;
    std::vector<std::vector<Plan>> plan;
  };
  std::uint32_t seed_;
  std::mt19937 random_;
  MatchFixture shared_, alone_;
  std::vector<Pair> rules_;
  int next_rule_ = 0, step_ = 0;
  bool failed_ = false;
  std::string changed_;
};

#ifdef SOARBOX_CHECK_INVARIANTS
constexpr std::uint32_t kCases = 60;  // Such builds also use sanitizers.
#else
constexpr std::uint32_t kCases = 600;
#endif

TEST(SharedConjunctions, ReportWhatOthersReportInTheSameOrder) {
  std::size_t shared = 0;
  for (std::uint32_t seed = 1; seed <= kCases; ++seed) shared += TwoWays(seed).Run(120);
  EXPECT_GT(shared, kCases / 4) << "too few conjunctions were shared for this to say much";
}

}  // namespace
}  // namespace soarbox::kernel
