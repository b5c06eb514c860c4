// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/reinforcement.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "kernel/agent.h"
#include "kernel/decide/exploration.h"
#include "kernel/learn/rl_settings.h"
#include "kernel/rules/print_production.h"

namespace soarbox::kernel {
namespace {

constexpr const char* kCount = "init (state <s> ^superstate nil) --> (<s> ^turn 0)";
constexpr const char* kPropose =
    "propose (state <s> ^superstate nil ^turn <n>) --> (<s> ^operator <o> + =) (<o> ^name go ^turn <n>)";
constexpr const char* kApply = "apply (state <s> ^operator.name go ^turn <n>) --> (<s> ^turn <n> - (+ <n> 1))";
constexpr const char* kLearner = "learner (state <s> ^operator <o> +) (<o> ^name go) --> (<s> ^operator <o> = 0.5)";
constexpr const char* kReward = "reward (state <s> ^reward-link <r> ^turn > 0) --> (<r> ^reward.value 2)";

class ReinforcementTest : public testing::Test {
 protected:
  ~ReinforcementTest() override { EXPECT_EQ(agent.CheckInvariants(), ""); }

  static void Load(Agent& to, std::initializer_list<const char*> rules) {
    for (const char* const rule : rules) EXPECT_TRUE(to.LoadProduction(rule).loaded) << rule;
  }
  static void Learn(
      Agent& with, void (*change)(RlSettings&) = [](RlSettings&) {}) {
    RlSettings settings = with.reinforcement();
    settings.learning = true;
    change(settings);
    with.SetReinforcement(settings);
    with.mutable_exploration().policy = ExplorationPolicy::kFirst;
  }
  static double Number(const Agent& of, std::string_view rule) {
    const ProductionId id = of.FindProduction(rule);
    const RlValue* const learned = of.LearnedValue(id);
    const Symbol number = learned != nullptr ? learned->value : of.production(id).actions.front().referent.symbol();
    return of.symbols().NumberValue(number);
  }
  static double Updates(const Agent& of, std::string_view rule) {
    const RlValue* const learned = of.LearnedValue(of.FindProduction(rule));
    return learned != nullptr ? learned->updates : 0;
  }
  double Number(std::string_view rule) const { return Number(agent, rule); }
  std::string Printed(std::string_view rule) const {
    return PrintProduction(agent.symbols(), *agent.ProductionAsLearned(agent.FindProduction(rule)));
  }
  std::string Names() const {
    std::string names;
    for (const ProductionId id : agent.Productions()) names += std::string(agent.production(id).name) + " ";
    return names;
  }

  Agent agent{"learner"};
};

TEST_F(ReinforcementTest, ARuleMovesTowardsRewardAndTheValueOfTheNextOperator) {
  Load(agent, {kCount, kPropose, kApply, kLearner, kReward});
  Learn(agent);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_DOUBLE_EQ(Number("learner"), 0.5);
  agent.Run(RunUnit::kDecision, 1);  // 0.5 + 0.3 * (2 + 0.9 * 0.5 - 0.5)
  EXPECT_DOUBLE_EQ(Number("learner"), 1.085);
  EXPECT_EQ(Updates(agent, "learner"), 1);
  EXPECT_NE(Printed("learner").find("= 1.085000"), std::string::npos);
}

TEST_F(ReinforcementTest, ValuesOutliveInitSoarAndBeginAnewWithTheRule) {
  Load(agent, {kCount, kPropose, kApply, kLearner, kReward});
  Learn(agent);
  agent.Run(RunUnit::kDecision, 2);
  agent.InitSoar();
  EXPECT_DOUBLE_EQ(Number("learner"), 1.085);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Updates(agent, "learner"), 1) << "what was selected before init-soar is forgotten";
  Load(agent, {kLearner});
  EXPECT_DOUBLE_EQ(Number("learner"), 0.5);
  agent.Run(RunUnit::kDecision, 3);
  EXPECT_GT(Number("learner"), 0.5);
}

TEST_F(ReinforcementTest, ForetellingADecisionTeachesNothingAndChangesNoChoice) {
  Load(agent, {kCount, kPropose, kApply, kLearner, kReward});
  Learn(agent);
  agent.Run(RunUnit::kDecision, 2);
  agent.RunToPhase(Phase::kDecide);
  const double before = Number("learner");
  agent.PredictDecision();
  agent.PredictDecision();
  EXPECT_EQ(Number("learner"), before);
  EXPECT_EQ(agent.selected_operator(), "");
}

TEST_F(ReinforcementTest, AHaltIsTheEndOfTheEpisode) {
  Load(agent, {kCount, kPropose, kApply, kLearner, kReward, "stop (state <s> ^turn 1) --> (halt)"});
  Learn(agent);
  agent.Run(RunUnit::kForever);
  ASSERT_TRUE(agent.halted());
  EXPECT_DOUBLE_EQ(Number("learner"), 0.5 + 0.3 * (2 - 0.5));
}

TEST_F(ReinforcementTest, AThousandAgentsWithTheSameRulesLearnEachForThemselves) {
  constexpr int kAgents = 1000;
  std::vector<std::unique_ptr<Agent>> agents;
  for (int n = 0; n < kAgents; ++n) {
    agents.push_back(std::make_unique<Agent>("agent" + std::to_string(n)));
    Agent& one = *agents.back();
    Load(one, {kCount, kPropose, kApply, kLearner,
               "paid (state <s> ^reward-link <r> ^io.input-link.pay <p>) --> (<r> ^reward.value <p>)"});
    Learn(one, [](RlSettings& settings) { settings.discount_rate = 0; });
    SymbolTable& symbols = one.mutable_symbols();
    ASSERT_TRUE(one.AddWme(one.InputLinkIdentifier(), symbols.String("pay"), symbols.Integer(n)).ok());
    one.Run(RunUnit::kDecision, 1);
  }
  const Network* const shared = agents.back()->rete().network().get();
  for (const auto& one : agents) one->Run(RunUnit::kDecision, 2);
  for (int n = 0; n < kAgents; ++n) {
    const double first = 0.5 + 0.3 * (n - 0.5);
    EXPECT_DOUBLE_EQ(Number(*agents[static_cast<std::size_t>(n)], "learner"), first + 0.3 * (n - first));
    if (n == 0) continue;  // The first agent creates the data that the others share.
    EXPECT_EQ(agents[static_cast<std::size_t>(n)]->rete().network().get(), shared) << n;
  }
  EXPECT_EQ(agents.front()->production(agents.front()->FindProduction("learner")).actions.front().referent.symbol(),
            agents.front()->mutable_symbols().Float(0.5))
      << "the rule that they share says what it always said";
}

TEST_F(ReinforcementTest, LearnedNumbersOutliveTheSweepsOfManyOthers) {
  Load(agent, {kCount, kPropose, kApply, kLearner,
               "rest (state <s> ^operator <o> +) (<o> ^name nothing) --> (<s> ^operator <o> = 0.25)",
               "reward (state <s> ^reward-link <r> ^turn <n>) --> (<r> ^reward.value (sin <n>))"});
  Learn(agent);
  agent.Run(RunUnit::kDecision, 30000);
  const RlValue& learned = *agent.LearnedValue(agent.FindProduction("learner"));
  EXPECT_EQ(learned.updates, 29999);
  EXPECT_TRUE(agent.symbols().IsLive(learned.value));
  EXPECT_DOUBLE_EQ(agent.symbols().NumberValue(learned.value), learned.current + learned.future);
}

TEST_F(ReinforcementTest, ExcisingARuleInTheMiddleOfAnEpisodeTakesItOutOfTheNextUpdate) {
  Load(agent, {kCount, kPropose, kApply, kLearner, kReward,
               "other (state <s> ^operator <o> +) (<o> ^name <any>) --> (<s> ^operator <o> = 1.0)"});
  Learn(agent, [](RlSettings& settings) { settings.trace_decay = 0.9; });
  agent.Run(RunUnit::kDecision, 3);
  agent.Excise(agent.FindProduction("learner"));
  EXPECT_EQ(agent.CheckInvariants(), "");
  agent.Run(RunUnit::kDecision, 3);
  EXPECT_EQ(Updates(agent, "other"), 5);
}

TEST_F(ReinforcementTest, DocumentationKeepsTheNumberOfUpdates) {
  Load(agent, {kCount, kPropose, kApply, kLearner, kReward});
  Learn(agent, [](RlSettings& settings) { settings.meta = true; });
  agent.Run(RunUnit::kDecision, 3);
  const std::string text = Printed("learner");
  EXPECT_NE(text.find("\"rl-updates=2;delta-bar-delta-h=0;\""), std::string::npos) << text;
  const std::string body = text.substr(4, text.rfind('}') - 4);
  EXPECT_TRUE(agent.LoadProduction(body).loaded);
  EXPECT_EQ(Updates(agent, "learner"), 2);
}

// Templates -----------------------------------------------------------------------------------------------------------

constexpr const char* kThings =
    "things (state <s> ^superstate nil) --> (<s> ^thing <a> ^thing <b>) (<a> ^size 0.1234567 ^kind box) "
    "(<b> ^size 3 ^kind ball)";
constexpr const char* kTake =
    "take (state <s> ^superstate nil ^thing <t>) --> (<s> ^operator <o> + =) (<o> ^name take ^thing <t>)";

TEST_F(ReinforcementTest, ATemplateMakesARuleForEachCombinationOfConstantsOnce) {
  Load(agent, {kThings, kTake,
               "value :template (state <s> ^operator <o> +) (<o> ^name take ^thing <t>) (<t> ^size { <z> > 0 }) --> "
               "(<s> ^operator <o> = 1.5)"});
  Learn(agent);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Names(), "things take value rl*value*1 rl*value*2 ");
  agent.InitSoar();
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Names(), "things take value rl*value*1 rl*value*2 ");
  EXPECT_EQ(agent.production(agent.FindProduction("rl*value*1")).type, ProductionType::kUser);
  EXPECT_TRUE(agent.production(agent.FindProduction("rl*value*1")).is_rl);
  EXPECT_EQ(agent.FiringCount(agent.FindProduction("rl*value*2")), 1u) << "all digits of 0.1234567 are in it";
  agent.Excise(agent.FindProduction("rl*value*2"));
  agent.InitSoar();
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Names(), "things take value rl*value*1 rl*value*3 ");
}

TEST_F(ReinforcementTest, ATemplateSubstitutesInNegationsToo) {
  Load(agent, {kThings, kTake,
               "value :template (state <s> ^operator <o> +) (<o> ^thing <t>) (<t> ^kind <k> ^size <z>) "
               "-(<s> ^seen <k>) -{ (<s> ^thing <u>) (<u> ^kind <k> ^size { <> <z> <y> }) } --> "
               "(<s> ^operator <o> = <z>)"});
  Learn(agent);
  agent.Run(RunUnit::kDecision, 1);
  const std::string text = Printed("rl*value*1") + Printed("rl*value*2");
  EXPECT_NE(text.find("-^seen box"), std::string::npos) << text;
  EXPECT_NE(text.find("^kind ball ^size { <> 3 <v2> }"), std::string::npos) << text;
  EXPECT_NE(text.find("^operator <o1> = 3)"), std::string::npos) << text;
}

TEST_F(ReinforcementTest, RulesOfATemplateThatWereSavedMakeTheNumbersGoOn) {
  Load(agent, {kThings, kTake, "rl*value*7 (state <s> ^operator <o> +) (<o> ^name other) --> (<s> ^operator <o> = 4)",
               "value :template (state <s> ^operator <o> +) (<o> ^thing.kind <k>) --> (<s> ^operator <o> = 1)"});
  Learn(agent);
  agent.Run(RunUnit::kDecision, 1);
  EXPECT_EQ(Names(), "things take rl*value*7 value rl*value*8 rl*value*9 ");
}

// Apoptosis -----------------------------------------------------------------------------------------------------------

TEST(Apoptosis, ARuleIsDueWhenItsActivationFallsBelowTheThreshold) {
  RlSettings settings;
  settings.apoptosis = ApoptosisMode::kChunks;
  Apoptosis apoptosis;
  apoptosis.Set(settings);
  const auto once = static_cast<ProductionId>(1), often = static_cast<ProductionId>(2);
  apoptosis.Used(once);
  int once_due = 0, often_due = 0;
  for (int decision = 1; decision < 400; ++decision) {
    if (decision % 10 == 1 && decision < 100) apoptosis.Used(often);
    for (const ProductionId rule : apoptosis.EndDecision()) (rule == once ? once_due : often_due) = decision;
  }
  EXPECT_EQ(once_due, 56) << "t^-0.5 < e^-2 from t = 55 on";
  EXPECT_EQ(often_due, 0) << "ten uses keep it above e^-2 for more than 400 decisions";
}

TEST_F(ReinforcementTest, ALearnedRuleThatNobodyUsesGoesAndOneThatIsUsedStays) {
  Load(agent, {kCount, kPropose, kApply, "seldom :chunk (state <s> ^superstate nil ^turn 3) --> (<s> ^seen yes)",
               "always :chunk (state <s> ^superstate nil ^turn <n>) --> (<s> ^again <n>)",
               "user (state <s> ^superstate nil ^turn 3) --> (<s> ^user yes)"});
  Learn(agent, [](RlSettings& settings) { settings.apoptosis = ApoptosisMode::kChunks; });
  agent.Run(RunUnit::kDecision, 50);
  EXPECT_EQ(Names(), "init propose apply seldom always user ");
  agent.Run(RunUnit::kDecision, 20);
  EXPECT_EQ(Names(), "init propose apply always user ");
}

}  // namespace
}  // namespace soarbox::kernel
