// SPDX-License-Identifier: BSD-2-Clause
// Checks that named reasons are true. Small agents with random preferences decide. For each dropped operator, a copy
// without the rules that were named as the reason decides again. The text must be "because" if and only if the outcome
// changes, and otherwise "without that it would still lose".
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "explain/inspector.h"
#include "explain/reasons.h"
#include "mind/decision_facts.h"
#include "sml_Client.h"
#include "wording/decision_text.h"

namespace soarbox::explain {
namespace {

struct NamedRule {
  std::string name, text;
};

/// Proposals of up to five operators, and rules with one random preference each.
std::vector<NamedRule> RandomRules(std::mt19937& random) {
  const auto below = [&](unsigned most) { return static_cast<unsigned>(random() % most); };
  std::vector<NamedRule> rules;
  const unsigned operators = 2 + below(4);
  for (unsigned i = 0; i < operators; ++i) {
    const std::string op(1, static_cast<char>('a' + i));
    rules.push_back(
        {"propose*" + op,
         "sp {propose*" + op + " (state <s> ^superstate nil) --> (<s> ^operator <o> +) (<o> ^name " + op + ")}"});
  }
  const unsigned preferences = 1 + below(8);
  std::set<std::string> bodies;
  for (unsigned i = 0; i < preferences; ++i) {
    const std::string name = "prefer*" + std::to_string(i);
    const std::string one(1, static_cast<char>('a' + below(operators)));
    const std::string two(1, static_cast<char>('a' + below(operators)));
    constexpr const char* kKinds[] = {"-", "~", ">", "<", ">", "<", "!", "-", ">", "<"};
    std::string kind = kKinds[below(std::size(kKinds))];
    if (kind == "!" && below(4) != 0) kind = "=";
    if (kind == "-" && below(2) == 0) kind = "=";
    const bool is_binary = (kind == ">" || kind == "<") && one != two && below(3) != 0;
    const std::string body = " (state <s> ^superstate nil ^operator <a> +" +
                             (is_binary ? " ^operator <b> +) (<b> ^name " + two + ")" : ")") + " (<a> ^name " + one +
                             ") --> (<s> ^operator <a> " + kind + (is_binary ? " <b>" : "") + ")}";
    // A kernel loads only the first of two rules with equal bodies.
    if (bodies.insert(body).second) rules.push_back({name, "sp {" + name + body});
  }
  return rules;
}

/// The outcome of a decision: the impasse and the names of the remaining operators.
struct TrialResult {
  mind::Impasse impasse = mind::Impasse::kNone;
  std::set<std::string> left;
  friend bool operator==(const TrialResult&, const TrialResult&) = default;
};

class ReasonsFuzz : public ::testing::Test {
 protected:
  ~ReasonsFuzz() override { kernel_->Shutdown(); }

  /// One decision of an agent with these rules except those in `without`. The agent exists until the next call.
  mind::Decision Decide(const std::vector<NamedRule>& rules, const std::set<std::string>& without = {}) {
    if (agent_ != nullptr) kernel_->DestroyAgent(agent_);
    agent_ = kernel_->CreateAgent("fuzz");
    agent_->ExecuteCommandLine("watch 0");
    agent_->ExecuteCommandLine("decide set-random-seed 7");
    for (const NamedRule& rule : rules)
      if (!without.contains(rule.name)) agent_->ExecuteCommandLine(rule.text.c_str());
    agent_->RunSelf(1);
    return MakeInspector(*agent_)->Operators("S1").decision.value_or(mind::Decision());
  }

  static TrialResult OutcomeOf(const mind::Decision& decision) {
    TrialResult outcome;
    outcome.impasse = decision.impasse;
    for (const mind::Decision::Chance& chance : decision.left) outcome.left.insert(decision.operators[chance.op].name);
    return outcome;
  }

  std::unique_ptr<sml::Kernel> kernel_{sml::Kernel::CreateKernelInCurrentThread(true, sml::Kernel::kSuppressListener)};
  sml::Agent* agent_ = nullptr;
};

TEST_F(ReasonsFuzz, RulesNamedAsTheReasonAreTheReason) {
  const char* wanted = std::getenv("SOARBOX_FUZZ_AGENTS");
  const int agents = wanted != nullptr ? std::atoi(wanted) : 400;
  int decisive = 0, idle = 0, impasses = 0;
  for (int i = 0; i < agents; ++i) {
    std::mt19937 random(static_cast<unsigned>(i));
    const std::vector<NamedRule> rules = RandomRules(random);
    const mind::Decision decision = Decide(rules);
    ASSERT_FALSE(decision.empty()) << i;
    std::string all;
    for (const NamedRule& rule : rules) all += rule.text + "\n";
    SCOPED_TRACE(std::to_string(i) + ":\n" + all);
    if (decision.impasse != mind::Impasse::kNone) {
      ++impasses;
      EXPECT_FALSE(wording::WhyNothing(decision).empty());
      // The report must name the same remaining operators as the decision procedure.
      const std::vector<Reason> reasons = MindReasons(*agent_).WhyIdle({});
      ASSERT_FALSE(reasons.empty());
      for (const mind::Decision::Chance& chance : decision.left)
        EXPECT_NE(reasons.front().text.find(decision.operators[chance.op].name), std::string::npos)
            << reasons.front().text;
    } else if (decision.selected != mind::Decision::kNoOperator) {
      EXPECT_FALSE(wording::WhySelected(decision).empty());
    }
    const TrialResult outcome = OutcomeOf(decision);
    for (const mind::Decision::Drop& drop : decision.drops) {
      std::set<std::string> named;
      for (std::uint32_t k = drop.first; k < drop.first + drop.count; ++k)
        named.insert(decision.preferences[decision.by[k]].rule);
      ASSERT_FALSE(named.empty());
      ASSERT_NE(drop.decisive, mind::Decisive::kUnknown);
      const std::string why = wording::WhyDropped(decision, drop.op);
      const bool says_because = why.find("would still lose") == std::string::npos;
      EXPECT_EQ(says_because, drop.decisive == mind::Decisive::kYes) << why;
      EXPECT_EQ(OutcomeOf(Decide(rules, named)) != outcome, says_because) << why;
      ++(says_because ? decisive : idle);
    }
  }
  // The generator must produce enough cases of each kind.
  EXPECT_GT(decisive, agents / 4);
  EXPECT_GT(idle, agents / 20);
  EXPECT_GT(impasses, agents / 20);
}

TEST_F(ReasonsFuzz, ThePreferencesNamedSufficeForTheOutcome) {
  for (int i = 0; i < 200; ++i) {
    std::mt19937 random(static_cast<unsigned>(10'000 + i));
    const std::vector<NamedRule> rules = RandomRules(random);
    const mind::Decision decision = Decide(rules);
    if (decision.impasse != mind::Impasse::kNone || decision.left.size() != 1) continue;
    std::set<std::string> named;
    for (const std::uint32_t place : decision.by) named.insert(decision.preferences[place].rule);
    std::set<std::string> others;
    for (const NamedRule& rule : rules) {
      // Require preferences are kept: they decide before anything is dropped.
      if (!rule.name.starts_with("propose*") && !named.contains(rule.name) &&
          rule.text.find(" !)") == std::string::npos)
        others.insert(rule.name);
    }
    EXPECT_EQ(OutcomeOf(Decide(rules, others)), OutcomeOf(decision)) << i;
  }
}

}  // namespace
}  // namespace soarbox::explain
