// SPDX-License-Identifier: BSD-2-Clause
// Random agents. After every phase, the match must equal the result of an exhaustive search of working memory, and
// every invariant must hold. Meanwhile rules are excised and added, and commands add and remove elements.
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "kernel/agent.h"
#include "kernel/decide/random_agents_test_support.h"
#include "kernel/match/naive_matcher_test_support.h"

namespace soarbox::kernel {
namespace {

/// Totals of the cases, to detect a generator that produces nothing interesting.
struct Tally {
  std::uint64_t matches = 0, firings = 0, decisions = 0, substates = 0, justifications = 0, stopped_early = 0;
};

class RandomCase {
 public:
  RandomCase(std::uint32_t seed, bool change_rules, std::uint32_t rootless_percent)
      : draw_(seed, rootless_percent), seed_(seed), change_rules_(change_rules), agent_("random") {
    agent_.mutable_settings().max_elaborations = 8;
    agent_.mutable_settings().max_goal_depth = 5;
    agent_.random().Seed(seed);
  }

  void Run(int phases, Tally& tally) {
    Load("begin (state <s> ^superstate nil) --> (<s> ^a 1 ^b x ^part <p>) (<p> ^a 2 ^b y)");
    const std::uint32_t rules = 5 + draw_.Below(6);
    for (std::uint32_t n = 0; n < rules; ++n) Load(draw_.NextRule());
    for (phase_ = 0; phase_ < phases && !testing::Test::HasFatalFailure(); ++phase_) {
      agent_.Step(RunUnit::kPhase);
      Check();
      if (change_rules_) Change();
      if (agent_.goals().depth() > 1) ++tally.substates;
      // Stops agents with too many elements: their elements keep multiplying, and they test nothing more.
      if (agent_.memory().wme_count() > kMaxElements) {
        ++tally.stopped_early;
        break;
      }
    }
    tally.matches += matches_;
    tally.firings += agent_.counters().firings;
    tally.decisions += agent_.counters().decision_phases;
    tally.justifications += agent_.counters().justifications;
  }

 private:
  static constexpr std::uint32_t kMaxElements = 200;

  void Load(std::string rule) {
    if (agent_.LoadProduction(rule).loaded) bodies_.push_back(std::move(rule));
  }

  static std::string NameOf(const std::string& body) { return body.substr(0, body.find(' ')); }

  void Change() {
    // A rule is excised and immediately added again.
    const std::string body = bodies_[draw_.Below(static_cast<std::uint32_t>(bodies_.size()))];
    agent_.Excise(agent_.FindProduction(NameOf(body)));
    Check();
    agent_.LoadProduction(body);
    switch (draw_.Below(12)) {
      case 0:
        Load(draw_.NextRule());
        break;
      case 1:
      case 2:
        AddByHand();
        break;
      case 3:
        RemoveByHand();
        break;
      case 4:
        agent_.input().Add(InputObject::kInputLink, draw_.Attribute(), draw_.Constant());
        break;
      case 5:
        if (draw_.Below(10) == 0) agent_.InitSoar();
        break;
      default:
        break;
    }
    Check();
  }

  void AddByHand() {
    SymbolTable& symbols = agent_.mutable_symbols();
    const Symbol state =
        agent_.goals()
            .at(static_cast<GoalLevel>(1 + draw_.Below(static_cast<std::uint32_t>(agent_.goals().depth()))))
            .id;
    static_cast<void>(agent_.AddWme(state, symbols.String(draw_.Attribute()), symbols.String(draw_.Constant())));
  }

  void RemoveByHand() {
    const std::vector<WmeId> live = Live();
    const WmeId wme = live[draw_.Below(static_cast<std::uint32_t>(live.size()))];
    const std::string attribute = ToString(agent_.symbols(), agent_.memory().wme(wme).attribute);
    // Elements of the architecture are not removed.
    if (attribute.size() == 1) static_cast<void>(agent_.RemoveWme(wme));
  }

  std::vector<WmeId> Live() const {
    std::vector<WmeId> live;
    const WmeTable& wmes = agent_.memory().wmes();
    for (std::uint32_t index = 0; index < wmes.size(); ++index) {
      const WmeId wme = static_cast<WmeId>(index);
      if (wmes[index].live && agent_.memory().record(wme).in_match) live.push_back(wme);
    }
    return live;
  }

  std::multiset<std::vector<std::uint64_t>> MatchesOf(ProductionId id) const {
    const std::uint16_t last = static_cast<std::uint16_t>(agent_.production(id).conditions.size() - 1);
    std::multiset<std::vector<std::uint64_t>> found;
    for (const std::vector<WmeId>& match : agent_.rete().MatchesAfter(id, std::vector<std::uint16_t>{last})) {
      std::vector<std::uint64_t> tags;
      for (const WmeId wme : match) tags.push_back(agent_.memory().wme(wme).timetag);
      found.insert(std::move(tags));
    }
    return found;
  }

  void Check() {
    ASSERT_EQ(agent_.CheckInvariants(), "") << "seed " << seed_ << " phase " << phase_;
    const std::vector<WmeId> live = Live();
    const GoalView goals{agent_.memory().goal_levels(), agent_.memory().long_term_identifiers()};
    for (const ProductionId id : agent_.Productions()) {
      const auto wanted = MatchNaively(agent_.production(id), agent_.symbols(), agent_.memory().wmes(), live, goals);
      matches_ += wanted.size();
      ASSERT_EQ(MatchesOf(id), wanted) << agent_.production(id).name << ", seed " << seed_ << " phase " << phase_;
    }
  }

  RandomAgents draw_;
  std::uint32_t seed_;
  bool change_rules_;
  Agent agent_;
  std::vector<std::string> bodies_;
  int phase_ = 0;
  std::uint64_t matches_ = 0;
};

#ifdef SOARBOX_CHECK_INVARIANTS
constexpr std::uint32_t kSlowness = 10;  // Sanitizers, and the invariants are also checked after each phase.
#else
constexpr std::uint32_t kSlowness = 1;
#endif

void RunSeeds(std::uint32_t first, std::uint32_t count, bool change_rules, std::uint32_t rootless_percent = 0) {
  count /= kSlowness;
  Tally tally;
  for (std::uint32_t seed = first; seed < first + count && !testing::Test::HasFailure(); ++seed) {
    RandomCase(seed, change_rules, rootless_percent).Run(40, tally);
  }
  if (kSlowness > 1) return;  // There are too few cases for expectations about their totals.
  EXPECT_GT(tally.matches, count * 100u);
  EXPECT_GT(tally.firings, count * 10u);
  EXPECT_GT(tally.substates, count * 2u);
  EXPECT_GT(tally.justifications, count / 5u);
  EXPECT_LT(tally.stopped_early, count / 2u);
}

TEST(RandomAgents, MatchWhatASearchFindsAfterEveryPhase) {
  RunSeeds(1, 2000, false);
}
TEST(RandomAgents, MatchWhatASearchFindsWhileRulesGoAndComeA) {
  RunSeeds(10'000, 1000, true);
}
TEST(RandomAgents, MatchWhatASearchFindsWhileRulesGoAndComeB) {
  RunSeeds(20'000, 1000, true);
}
TEST(RandomAgents, MatchWhatASearchFindsWhereConditionsDoNotBeginAtAState) {
  RunSeeds(30'000, 300, false, 50);
}
TEST(RandomAgents, MatchWhatASearchFindsWithoutStatesWhileRulesGoAndCome) {
  RunSeeds(40'000, 60, true, 50);
}

}  // namespace
}  // namespace soarbox::kernel
