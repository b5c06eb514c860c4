// SPDX-License-Identifier: BSD-2-Clause
// Checks that the reasons in decision traces are true. With only the named preferences, the decision is the same;
// without those of a drop, the candidate is not dropped at that stage. Uses random slots (SOARBOX_FUZZ_SLOTS is their
// number; a full test needs a million) and random agents, from rules to reasons.
#include "kernel/decide/decision_trace.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::kernel {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr Symbol Op(std::uint32_t n) {
  return {Symbol::Tag::kIdentifier, n};
}
std::uint32_t NumberOf(Symbol op) {
  return op.index();
}

struct Outcome {
  ImpasseType impasse = ImpasseType::kNone;
  std::vector<std::uint32_t> left;
  std::vector<double> numbers;
  bool operator==(const Outcome&) const = default;
};

Outcome Copy(const PreferenceSemantics::Outcome& from) {
  Outcome outcome{from.impasse, {}, {}};
  for (const Candidate& candidate : from.candidates) {
    outcome.left.push_back(NumberOf(candidate.value));
    // Numbers have no effect if one candidate is left or a tie remains.
    const bool counts = from.candidates.size() > 1 && from.impasse == ImpasseType::kNone;
    outcome.numbers.push_back(counts ? candidate.number_sum : 0);
  }
  return outcome;
}

/// A slot with its decision and the decision's trace.
struct TracedSlot {
  std::vector<SlotPreference> list;
  Outcome outcome;
  DecisionTrace trace;

  explicit TracedSlot(std::vector<SlotPreference> preferences, Symbol forced = {}) : list(std::move(preferences)) {
    PreferenceSemantics semantics;
    outcome = Copy(semantics.Decide(list, forced, &trace));
  }
  /// Prohibits and rejects count as one step.
  static DecisionStage Step(DecisionStage stage) {
    return stage == DecisionStage::kProhibit ? DecisionStage::kReject : stage;
  }
  bool Drops(Symbol op, DecisionStage stage) const {
    for (const DecisionTrace::Drop& drop : trace.drops)
      if (drop.value == op && Step(drop.stage) == Step(stage)) return true;
    return false;
  }
  std::vector<SlotPreference> Without(const std::set<std::uint32_t>& places) const {
    std::vector<SlotPreference> rest;
    for (std::uint32_t i = 0; i < list.size(); ++i)
      if (!places.contains(i)) rest.push_back(list[i]);
    return rest;
  }
};

std::vector<SlotPreference> RandomSlot(std::mt19937& random) {
  const auto below = [&](std::uint32_t limit) { return random() % limit; };
  const std::uint32_t operators = 1 + below(5);
  std::vector<SlotPreference> list;
  for (std::uint32_t op = 1; op <= operators; ++op)
    if (below(10) > 0) list.push_back({PreferenceType::kAcceptable, Op(op), {}, 0, {}});
  // Slots with few kinds of preferences reach the later stages; a require ends most decisions early.
  std::vector<PreferenceType> kinds;
  for (const PreferenceType type :
       {PreferenceType::kReject, PreferenceType::kProhibit, PreferenceType::kBest, PreferenceType::kWorst,
        PreferenceType::kBetter, PreferenceType::kWorse, PreferenceType::kUnaryIndifferent,
        PreferenceType::kNumericIndifferent, PreferenceType::kBinaryIndifferent})
    if (below(3) == 0) kinds.push_back(type);
  if (below(12) == 0) kinds.push_back(PreferenceType::kRequire);
  for (std::uint32_t n = kinds.empty() ? 0 : below(9); n > 0; --n) {
    SlotPreference preference{
        kinds[below(static_cast<std::uint32_t>(kinds.size()))], Op(1 + below(operators + 1)), {}, 0, {}};
    if (preference.type == PreferenceType::kBetter || preference.type == PreferenceType::kWorse ||
        preference.type == PreferenceType::kBinaryIndifferent)
      preference.referent = Op(1 + below(operators + 1));
    if (preference.type == PreferenceType::kNumericIndifferent) preference.number = below(4);
    list.push_back(preference);
  }
  return list;
}

/// Describes the first false statement in a slot's reasons; empty if there is none.
std::string Violation(const TracedSlot& slot, bool is_forced) {
  std::set<std::uint32_t> left(slot.outcome.left.begin(), slot.outcome.left.end()), candidates, dropped;
  for (const SlotPreference& p : slot.list)
    if (p.type == PreferenceType::kAcceptable) candidates.insert(NumberOf(p.value));
  for (const DecisionTrace::Drop& drop : slot.trace.drops) {
    if (!dropped.insert(NumberOf(drop.value)).second) return "dropped twice";
    if (!candidates.contains(NumberOf(drop.value))) return "dropped, and never a candidate";
    if (slot.outcome.impasse != ImpasseType::kConflict && left.contains(NumberOf(drop.value)))
      return "dropped and left";
  }
  for (const std::uint32_t candidate : candidates)
    if (!left.contains(candidate) && !dropped.contains(candidate)) return "neither dropped nor left";
  if (is_forced) return {};

  // Sufficiency: keeps only proposals and named preferences.
  std::set<std::uint32_t> unnamed;
  for (std::uint32_t i = 0; i < slot.list.size(); ++i)
    if (slot.list[i].type != PreferenceType::kAcceptable) unnamed.insert(i);
  for (const std::uint32_t place : slot.trace.by) unnamed.erase(place);
  for (const std::uint32_t place : slot.trace.settling) unnamed.erase(place);
  if (!unnamed.empty() && TracedSlot(slot.Without(unnamed)).outcome != slot.outcome)
    return "what is named does not suffice";

  for (const DecisionTrace::Drop& drop : slot.trace.drops) {
    const std::span<const std::uint32_t> by = slot.trace.By(drop);
    if (by.empty()) return "dropped by nothing";
    const std::set<std::uint32_t> all(by.begin(), by.end());
    const TracedSlot without(slot.Without(all));
    if (without.Drops(drop.value, drop.stage)) return "dropped without what is named";
    if (IsDecisive(slot.list, slot.trace, drop) !=
        (without.outcome.impasse != slot.outcome.impasse || without.outcome.left != slot.outcome.left))
      return "not what decided it";
    // Each one alone.
    for (const std::uint32_t kept : by) {
      if (by.size() == 1) break;
      std::set<std::uint32_t> others = all;
      others.erase(kept);
      if (!TracedSlot(slot.Without(others)).Drops(drop.value, drop.stage)) return "one of those named is not enough";
    }
  }
  return {};
}

std::string Shown(const std::vector<SlotPreference>& list) {
  std::string text;
  for (const SlotPreference& p : list) {
    text += "O" + std::to_string(NumberOf(p.value)) + " type " + std::to_string(static_cast<int>(p.type));
    if (p.referent) text += " O" + std::to_string(NumberOf(p.referent));
    text += "; ";
  }
  return text;
}

TEST(DecisionTrace, NamesPreferencesThatAreSufficientAndNecessary) {
  const char* const wanted = std::getenv("SOARBOX_FUZZ_SLOTS");
  const long slots = wanted == nullptr ? 20'000 : std::atol(wanted);
  ASSERT_GT(slots, 0) << "SOARBOX_FUZZ_SLOTS";
  std::mt19937 random(20);
  std::map<DecisionStage, long> stages;
  long decisive = 0, idle = 0;
  for (long n = 0; n < slots; ++n) {
    const std::vector<SlotPreference> list = RandomSlot(random);
    const bool is_forced = !list.empty() && random() % 16 == 0 && list.front().type == PreferenceType::kAcceptable;
    const TracedSlot slot(list, is_forced ? list.front().value : Symbol());
    PreferenceSemantics untraced;
    ASSERT_EQ(Copy(untraced.Decide(list, is_forced ? list.front().value : Symbol())), slot.outcome) << Shown(list);
    ASSERT_EQ(Violation(slot, is_forced), "") << Shown(list) << "slot " << n;
    for (const DecisionTrace::Drop& drop : slot.trace.drops) {
      ++stages[drop.stage];
      ++(IsDecisive(slot.list, slot.trace, drop) ? decisive : idle);
    }
  }
  // The generator must reach every stage, with both kinds of drops.
  EXPECT_EQ(stages.size(), 7u);
  for (const auto& [stage, count] : stages) EXPECT_GT(count, slots / 1000) << static_cast<int>(stage);
  EXPECT_GT(decisive, idle);
  EXPECT_GT(idle, slots / 100);
}

TEST(DecisionTrace, TwoThatDominateEachOtherLeaveTheThird) {
  const auto propose = [](std::uint32_t op) { return SlotPreference{PreferenceType::kAcceptable, Op(op), {}, 0, {}}; };
  const auto better = [](std::uint32_t a, std::uint32_t b) {
    return SlotPreference{PreferenceType::kBetter, Op(a), Op(b), 0, {}};
  };
  const TracedSlot slot({propose(1), propose(2), propose(3), better(1, 2), better(2, 1)});
  EXPECT_EQ(slot.outcome.impasse, ImpasseType::kNone);
  EXPECT_THAT(slot.outcome.left, ElementsAre(3u));
  ASSERT_EQ(slot.trace.drops.size(), 2u);
  for (const DecisionTrace::Drop& drop : slot.trace.drops) {
    EXPECT_EQ(drop.stage, DecisionStage::kDominated);
    EXPECT_TRUE(IsDecisive(slot.list, slot.trace, drop));
  }
  EXPECT_THAT(slot.trace.settling, IsEmpty());
}

// From rules to reasons -----------------------------------------------------------------------------------------------

/// An agent that decides once among operators for which its own rules have preferences.
class DecidingAgent : public Observer {
 public:
  explicit DecidingAgent(const std::vector<std::string>& rules, bool is_watched = true) : agent_("deciding") {
    if (is_watched) agent_.AddObserver(*this, Mask(Event::kReason));
    agent_.random().Seed(7);
    for (const std::string& rule : rules) EXPECT_TRUE(agent_.LoadProduction(rule).loaded) << rule;
    agent_.Run(RunUnit::kDecision, 1);
    selected = agent_.OperatorOf(agent_.goals().top()) ? Name(agent_.OperatorOf(agent_.goals().top())) : "";
  }
  ~DecidingAgent() override { agent_.RemoveObserver(*this); }

  void OnDecided(const Agent&, const DecisionReport& report) override {
    if (report.level != 1) return;
    ++told;
    impasse = report.impasse;
    for (const Candidate& candidate : report.candidates) left.insert(Name(candidate.value));
    for (const DecisionTrace::Drop& drop : report.trace.drops) {
      Drop& noted = drops[Name(drop.value)];
      noted.stage = TracedSlot::Step(drop.stage);
      noted.is_decisive = IsDecisive(report.preferences, report.trace, drop);
      for (const std::uint32_t place : report.trace.By(drop)) {
        const Preference& preference = agent_.memory().preference(report.preferences[place].preference);
        EXPECT_TRUE(preference.live && preference.in_slot);
        EXPECT_EQ(preference.type, report.preferences[place].type);
        noted.rules.insert(std::string(agent_.ProductionName(preference.instantiation)));
      }
    }
  }

  struct Drop {
    DecisionStage stage = DecisionStage::kForced;
    bool is_decisive = false;
    std::set<std::string> rules;
  };
  int told = 0;
  ImpasseType impasse = ImpasseType::kNone;
  std::string selected;
  std::set<std::string> left;
  std::map<std::string, Drop> drops;

 private:
  std::string Name(Symbol op) {
    const Symbol name = agent_.memory().ValueOf(op, agent_.mutable_symbols().String("name"));
    return name ? ToString(agent_.symbols(), name) : std::string();
  }
  Agent agent_;
};

std::vector<std::string> RandomRules(std::mt19937& random) {
  const auto below = [&](std::uint32_t limit) { return random() % limit; };
  std::vector<std::string> rules;
  std::set<std::string> bodies;  // Two rules with equal contents are one.
  const auto add = [&](const std::string& name, const std::string& body) {
    if (bodies.insert(body).second) rules.push_back(name + body);
  };
  const std::uint32_t operators = 2 + below(3);
  for (std::uint32_t op = 0; op < operators; ++op) {
    const std::string n = std::to_string(op);
    add("propose*" + n, " (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name n" + n + ")");
  }
  constexpr const char* kUnary[] = {"-", "~", ">", "<", "=", "!"};
  constexpr const char* kBinary[] = {">", "<", ">", "="};
  for (std::uint32_t rule = 1 + below(7); rule > 0; --rule) {
    const std::string name = "prefer*" + std::to_string(rule), a = std::to_string(below(operators));
    const std::string first = " (state <s> ^superstate nil ^operator <a> +) (<a> ^name n" + a + ")";
    if (below(2) == 0) {
      // (A require ends most decisions early, so it is rare.)
      const std::uint32_t sign = below(10) == 0 ? 5 : below(5);
      add(name, first + " --> (<s> ^operator <a> " + kUnary[sign] + ")");
    } else {
      const std::string b = std::to_string(below(operators));
      if (a == b) continue;
      add(name, first + " (<s> ^operator <b> +) (<b> ^name n" + b + ") --> (<s> ^operator <a> " + kBinary[below(4)] +
                    " <b>)");
    }
  }
  return rules;
}

TEST(DecisionTrace, RulesNamedAsReasonsAreTheReasonsOfRandomAgents) {
  std::mt19937 random(4);
  int drops = 0, decisive = 0, impasses = 0;
  for (int n = 0; n < 300; ++n) {
    const std::vector<std::string> rules = RandomRules(random);
    const DecidingAgent agent(rules), unwatched(rules, false);
    SCOPED_TRACE(testing::PrintToString(rules));
    ASSERT_EQ(agent.told, 1);
    ASSERT_EQ(agent.selected, unwatched.selected) << "being watched changes nothing";
    if (agent.impasse != ImpasseType::kNone) ++impasses;
    for (const auto& [op, drop] : agent.drops) {
      ASSERT_FALSE(drop.rules.empty());
      std::vector<std::string> rest;
      for (const std::string& rule : rules)
        if (!drop.rules.contains(rule.substr(0, rule.find(' ')))) rest.push_back(rule);
      const DecidingAgent without(rest);
      const auto still = without.drops.find(op);
      EXPECT_FALSE(still != without.drops.end() && still->second.stage == drop.stage) << op;
      EXPECT_EQ(drop.is_decisive, without.impasse != agent.impasse || without.left != agent.left) << op;
      ++drops;
      if (drop.is_decisive) ++decisive;
    }
  }
  EXPECT_GT(drops, 200);
  EXPECT_GT(decisive, 150);
  EXPECT_LT(decisive, drops);
  EXPECT_GT(impasses, 30);
}

}  // namespace
}  // namespace soarbox::kernel
