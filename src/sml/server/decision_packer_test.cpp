// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/decision_packer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "kernel/decide/exploration.h"
#include "kernel/decide/random_agents_test_support.h"
#include "kernel/observer.h"
#include "mind/decision_codec.h"

namespace soarbox::server {
namespace {

/// Packs each decision of an agent in both ways.
class Comparison final : public kernel::Observer {
 public:
  explicit Comparison(kernel::Agent& agent) : agent_(agent) {
    agent_.AddObserver(*this, kernel::Event::kReason | kernel::Event::kPrint);
  }
  ~Comparison() override { agent_.RemoveObserver(*this); }

  void OnDecided(const kernel::Agent& agent, const kernel::DecisionReport& report) override {
    DecisionReader reader;
    const mind::DecisionView& wanted = reader.Read(agent, report);
    std::string bytes;
    mind::Pack(wanted, bytes);
    EXPECT_EQ(packer_.Pack(agent, report), bytes);
    for (const kernel::SlotPreference& preference : report.preferences) {
      const mind::DecisionView::Operator* const known = reader.Find(preference.value);
      ASSERT_NE(known, nullptr);
      EXPECT_EQ(packer_.Find(preference.value).id, known->id);
      EXPECT_EQ(packer_.Find(preference.value).name, known->name);
    }
    EXPECT_EQ(packer_.Find(report.goal).id, "");
    told.push_back(std::move(bytes));
  }

  std::vector<std::string> told;

 private:
  kernel::Agent& agent_;
  DecisionPacker packer_;
};

TEST(DecisionPacker, MakesTheBytesThatTheReaderMakesForAgentsDrawnAtRandom) {
  std::size_t told = 0;
  std::set<mind::Impasse> impasses;
  for (std::uint32_t seed = 1; seed <= 150; ++seed) {
    kernel::RandomAgents draw(seed);
    kernel::Agent agent("random");
    agent.mutable_settings().max_elaborations = 8;
    agent.mutable_settings().max_goal_depth = 5;
    agent.random().Seed(seed);
    Comparison comparison(agent);
    agent.LoadProduction("begin (state <s> ^superstate nil) --> (<s> ^a 1 ^b x ^part <p>) (<p> ^a 2 ^b y)");
    for (std::uint32_t n = 8 + draw.Below(8); n > 0; --n) agent.LoadProduction(draw.NextRule());
    for (int decision = 0; decision < 12 && agent.memory().wme_count() < 200; ++decision) {
      agent.Step(kernel::RunUnit::kDecision);
      kernel::ExplorationSettings& exploration = agent.mutable_exploration();
      if (draw.Below(6) == 0) exploration.policy = static_cast<kernel::ExplorationPolicy>(draw.Below(5));
      if (draw.Below(12) == 0) exploration.average_numbers = !exploration.average_numbers;
      if (draw.Below(12) == 0) exploration.SetTemperature(1 + draw.Below(5));
      if (draw.Below(12) == 0) agent.InitSoar();
    }
    told += comparison.told.size();
    for (const std::string& bytes : comparison.told) {
      const std::optional<mind::Decision> read = mind::Unpack(bytes);
      ASSERT_TRUE(read);
      impasses.insert(read->impasse);
    }
    if (HasFailure()) FAIL() << "seed " << seed;
  }
  EXPECT_GT(told, 150u);
  EXPECT_GE(impasses.size(), 2u);
}

TEST(DecisionPacker, TellsOperatorsOfOneShapeApart) {
  kernel::Agent agent("counting");
  Comparison comparison(agent);
  for (const char* rule :
       {"propose*begin (state <s> ^superstate nil -^count) --> (<s> ^operator <o> +) (<o> ^name begin)",
        "apply*begin (state <s> ^operator.name begin) --> (<s> ^count 0)",
        "propose*next (state <s> ^count <n>) --> (<s> ^operator <o> + ^operator <p> + ^operator <o> > <p>)"
        " (<o> ^name (+ <n> 1) ^next (+ <n> 1)) (<p> ^name |or not|)",
        "apply*next (state <s> ^operator.next <m> ^count <n>) --> (<s> ^count <m> ^count <n> -)"})
    ASSERT_TRUE(agent.LoadProduction(rule).loaded) << rule;
  for (int decision = 0; decision < 12; ++decision) agent.Step(kernel::RunUnit::kDecision);
  std::set<std::string> names, ids;
  for (const std::string& bytes : comparison.told) {
    const std::optional<mind::Decision> read = mind::Unpack(bytes);
    ASSERT_TRUE(read);
    ASSERT_LT(read->selected, read->operators.size());
    names.insert(read->operators[read->selected].name);
    ids.insert(read->operators[read->selected].id);
    EXPECT_EQ(read->drops.size(), read->operators.size() - 1);
  }
  EXPECT_GE(names.size(), 10u);
  EXPECT_EQ(ids.size(), names.size());
}

}  // namespace
}  // namespace soarbox::server
