// SPDX-License-Identifier: BSD-2-Clause
#include "script/failure_ledger.h"

#include <gtest/gtest.h>

namespace soarbox::script {
namespace {

using world::EntityId;
using Kind = ScriptTrouble::Kind;

ScriptError Error(const char* message) {
  ScriptError error;
  error.diagnostic.message = message;
  return error;
}

TEST(FailureLedger, OneErrorOfSeveralAgentsIsOneNews) {
  FailureLedger ledger;
  ledger.Failed(EntityId{3}, "Agent_Update", Error("a"));
  ledger.Failed(EntityId{1}, "Agent_Update", Error("a"));
  ledger.Failed(EntityId{2}, "Agent_Update", Error("b"));
  const auto news = ledger.TakeNews();
  ASSERT_EQ(news.size(), 2u);
  EXPECT_EQ(news[0].agents, (std::vector{EntityId{1}, EntityId{3}}));
  EXPECT_EQ(news[1].error.diagnostic.message, "b");
  // Later it is only counted.
  ledger.Failed(EntityId{7}, "Agent_Update", Error("a"));
  EXPECT_TRUE(ledger.TakeNews().empty());
  ASSERT_EQ(ledger.Untold().size(), 1u);
  EXPECT_EQ(ledger.Untold()[0].count, 3u);
  EXPECT_EQ(ledger.Untold()[0].agents.size(), 3u);
}

TEST(FailureLedger, WhatFailsTimeAfterTimeIsToldOnceAndWhenItWorksAgain) {
  FailureLedger ledger;
  std::vector<Kind> told;
  const auto take = [&] {
    for (const ScriptTrouble& news : ledger.TakeNews()) told.push_back(news.kind);
  };
  for (int i = 0; i < 100; ++i) {
    ledger.Failed(EntityId{1}, "Agent_Update", Error("a"));
    take();
  }
  EXPECT_EQ(told, (std::vector{Kind::kError, Kind::kKeepsFailing}));
  ledger.Succeeded(EntityId{1}, "Agent_Update");
  ledger.Succeeded(EntityId{1}, "Agent_Update");
  take();
  EXPECT_EQ(told, (std::vector{Kind::kError, Kind::kKeepsFailing, Kind::kWorksAgain}));
}

TEST(FailureLedger, ACallbackThatFailsAndRecoversForEverIsToldThreeTimes) {
  FailureLedger ledger;
  std::size_t told = 0;
  for (int round = 0; round < 50; ++round) {
    for (int i = 0; i < 5; ++i) ledger.Failed(EntityId{1}, "Agent_Update", Error("a"));
    ledger.Succeeded(EntityId{1}, "Agent_Update");
    told += ledger.TakeNews().size();
  }
  EXPECT_EQ(told, 1u + 3u + 3u);
}

TEST(FailureLedger, ErrorsWhoseTextChangesEachTimeDoNotPileUp) {
  FailureLedger ledger;
  std::size_t told = 0;
  for (int i = 0; i < 10'000; ++i) {
    ledger.Failed(EntityId{1}, "Agent_Update", Error(std::to_string(i).c_str()));
    told += ledger.TakeNews().size();
  }
  EXPECT_LT(told, 600u);
}

}  // namespace
}  // namespace soarbox::script
