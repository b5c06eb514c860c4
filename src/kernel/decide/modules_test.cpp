// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/modules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "kernel/agent.h"
#include "kernel/longterm/agent_parts.h"
#include "kernel/longterm/long_term.h"

namespace soarbox::kernel {
namespace {

/// Records the calls that it receives from the cycle.
class Witness final : public Module {
 public:
  Witness(std::string name, std::vector<std::string>& calls) : name_(std::move(name)), calls_(calls) {}

  void RulesFire() override { Add("rules fire"); }
  void Flushed(std::span<const WmeId>, std::span<const WmeId>) override { Add("flushed"); }
  void AfterElaboration() override { Add("elaborated"); }
  void MatchEnded(ProductionId) override { Add("match ended"); }
  void OperatorChosen(GoalLevel level, std::span<const Candidate>, const Candidate&) override { Add("chosen", level); }
  void OperatorInstalled(GoalLevel level, Symbol) override { Add("installed", level); }
  void AfterDecision() override { Add("decided"); }
  void Output(bool) override { Add("output"); }
  void OutputEnd() override { Add("output ended"); }
  void Halted() override { Add("halted"); }
  void StateMade(GoalLevel level) override { Add("made", level); }
  void StateEnds(GoalLevel level) override { Add("ends", level); }
  void StateRemoved(GoalLevel level) override { Add("removed", level); }
  void BeforeInit() override { Add("before init"); }
  void AfterInit() override { Add("after init"); }
  void RuleExcised(ProductionId) override { Add("excised"); }

 private:
  void Add(const std::string& call) { calls_.push_back(name_ + call); }
  void Add(const std::string& call, GoalLevel level) { Add(call + " " + std::to_string(level)); }

  std::string name_;
  std::vector<std::string>& calls_;
};

using Calls = std::vector<std::string>;

TEST(Modules, AreCalledInTheOrderOfTheirPlacesAndOnlyWhereTheyAsked) {
  Calls calls;
  Witness first("1 ", calls), second("2 ", calls), last("3 ", calls);
  Modules modules;
  modules.Attach(last, Modules::kLast);
  modules.Attach(second, 1);
  modules.Attach(first, 0);
  for (const ModuleHook hook : {ModuleHook::kRulesFire, ModuleHook::kFlush, ModuleHook::kHalt}) {
    EXPECT_FALSE(modules.Wants(hook));
  }
  modules.SetHooks(first, static_cast<ModuleHooks>(ModuleHook::kHalt));
  modules.SetHooks(last, ModuleHook::kHalt | ModuleHook::kRulesFire);
  EXPECT_TRUE(modules.Wants(ModuleHook::kRulesFire));
  EXPECT_TRUE(modules.Wants(ModuleHook::kHalt));
  EXPECT_FALSE(modules.Wants(ModuleHook::kFlush));
  modules.RulesFire();
  modules.Halted();
  modules.BeforeInit();
  EXPECT_EQ(calls, (Calls{"3 rules fire", "1 halted", "3 halted", "1 before init", "2 before init", "3 before init"}));
  modules.SetHooks(last, 0);
  EXPECT_FALSE(modules.Wants(ModuleHook::kRulesFire));
}

TEST(Modules, HearOfEachPlaceOfTheCycle) {
  Agent agent("host");
  for (const char* rule :
       {"go (state <s> ^superstate nil -^done) --> (<s> ^operator.name go)",
        "done (state <s> ^superstate <t> ^impasse no-change) (<t> ^operator.name go) --> (<t> ^done yes)",
        "end (state <s> ^done yes) --> (halt)"}) {
    ASSERT_TRUE(agent.LoadProduction(rule).loaded) << rule;
  }
  Calls calls;
  Witness witness("", calls);
  Modules& modules = agent.long_term().parts().modules;
  modules.Attach(witness, 3);
  const auto ask = [&](ModuleHooks hooks) {
    calls.clear();
    modules.SetHooks(witness, hooks);
  };

  ask(ModuleHook::kChoices | ModuleHook::kAfterDecision | ModuleHook::kOutput | ModuleHook::kOutputEnd);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(calls, (Calls{"chosen 1", "installed 1", "decided"}));
  ask(ModuleHook::kStates | ModuleHook::kOutput | ModuleHook::kOutputEnd);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(calls, (Calls{"output", "output ended", "made 2"}));
  ask(ModuleHook::kRulesFire | ModuleHook::kFlush | ModuleHook::kAfterElaboration | ModuleHook::kHalt);
  agent.Run(RunUnit::kForever, 1);
  EXPECT_EQ(calls.front(), "rules fire");
  EXPECT_EQ(calls.back(), "halted");
  EXPECT_EQ(std::ranges::count(calls, "rules fire"), std::ranges::count(calls, "elaborated"));
  EXPECT_GT(std::ranges::count(calls, "flushed"), 1);

  ask(ModuleHook::kStates | ModuleHook::kMatches);
  agent.InitSoar();
  EXPECT_EQ(calls, (Calls{"before init", "removed 1", "made 1", "after init"}));
  modules.SetHooks(witness, 0);
  calls.clear();
  agent.Run(RunUnit::kForever, 1);
  EXPECT_EQ(calls, Calls{});
}

TEST(Modules, HearWhenMatchesAndStatesEnd) {
  Agent agent("host");
  for (const char* rule :
       {"go (state <s> ^superstate nil -^done) --> (<s> ^operator.name go)",
        "done (state <s> ^superstate <t> ^impasse no-change) (<t> ^operator.name go) --> (<t> ^done yes)"}) {
    ASSERT_TRUE(agent.LoadProduction(rule).loaded) << rule;
  }
  Calls calls;
  Witness witness("", calls);
  Modules& modules = agent.long_term().parts().modules;
  modules.Attach(witness, 3);
  modules.SetHooks(witness, ModuleHook::kStates | ModuleHook::kMatches);
  agent.Run(RunUnit::kDecision, 4);
  const auto at = [&](const char* call) { return std::ranges::find(calls, call); };
  EXPECT_LT(at("made 2"), at("ends 2"));
  EXPECT_LT(at("ends 2"), at("removed 2"));
  EXPECT_NE(at("removed 2"), calls.end());
  EXPECT_NE(at("match ended"), calls.end());
  calls.clear();
  agent.Excise(agent.Productions().front());
  EXPECT_EQ(std::ranges::count(calls, "excised"), 1);
}

}  // namespace
}  // namespace soarbox::kernel
