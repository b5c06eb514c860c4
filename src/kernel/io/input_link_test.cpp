// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/io/input_link.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <string>
#include <vector>

#include "kernel/agent.h"

namespace soarbox::kernel {
namespace {

/// Records what rules print. If it observes elements, the input link cannot use the fast path.
class Witness : public Observer {
 public:
  void OnPrint(const Agent&, std::string_view text) override { printed += text; }
  std::string printed;
};

/// An agent with a few input objects. Two such agents get the same calls; one of them is observed.
class Twin {
 public:
  explicit Twin(EventMask observed) { agent.AddObserver(witness, observed | Mask(Event::kPrint)); }

  void Load(std::string_view rule) { EXPECT_TRUE(agent.LoadProduction(rule).loaded) << rule; }
  void Excise(std::string_view rule) { agent.Excise(agent.FindProduction(rule)); }
  /// Makes one call, selected by three numbers.
  void Call(std::uint32_t what, std::uint32_t which, std::uint32_t value) {
    constexpr std::array<std::string_view, 4> kAttributes{"speed", "range", "name", "seen"};
    InputLink& input = agent.input();
    const InputObject parent =
        which % 3 == 0 || objects.empty() ? InputObject::kInputLink : objects[which % objects.size()];
    const std::string text = "word" + std::to_string(value % 5);
    if (what < 2) {
      elements.push_back(input.Add(parent, kAttributes[which % 4], std::int64_t{value % 7}));
    } else if (what == 2) {
      objects.push_back(input.NewObject());
      elements.push_back(input.Add(parent, "object", objects.back()));
    } else if (what == 3 && !elements.empty()) {
      input.Remove(elements[which % elements.size()]);
    } else if (!elements.empty()) {
      const InputElement element = elements[which % elements.size()];
      if (value % 3 == 0) input.Update(element, std::string_view(text), 1);
      if (value % 3 == 1) input.Update(element, std::int64_t{value % 7}, 2);
      if (value % 3 == 2) input.Update(element, value % 7 + 0.5, 3);
    }
  }
  /// Everything in working memory, in order of addition and in order of the lists, and the counters.
  std::string State() {
    std::vector<std::pair<std::uint64_t, std::string>> found;
    const auto line = [&](WmeId id) {
      const Wme& wme = agent.memory().wme(id);
      return std::to_string(wme.timetag) + ":" + ToString(agent.symbols(), wme.id) + " " +
             ToString(agent.symbols(), wme.attribute) + " " + ToString(agent.symbols(), wme.value) + "\n";
    };
    for (std::uint32_t n = 0; n < agent.memory().wmes().size(); ++n)
      if (const Wme& wme = agent.memory().wmes()[n]; wme.live)
        found.emplace_back(wme.timetag, line(static_cast<WmeId>(n)));
    std::ranges::sort(found);
    std::string text;
    for (const auto& [tag, shown] : found) text += shown;
    for (const WmeId wme : agent.memory().WmesOf(agent.InputLinkIdentifier())) text += line(wme);
    for (const InputObject object : objects)
      for (const WmeId wme : agent.memory().WmesOf(std::as_const(agent).input().Identifier(object))) text += line(wme);
    const AgentCounters& counters = agent.counters();
    for (const std::uint64_t count :
         {counters.decision_phases, counters.decision_cycles, counters.elaborations, counters.inner_elaborations,
          counters.firings, counters.wme_additions, counters.wme_removals, counters.phases, counters.wm_size_sum,
          counters.wm_size_maximum, counters.max_wme_changes, counters.max_wme_changes_cycle})
      text += std::to_string(count) + " ";
    return text + witness.printed;
  }

  Agent agent{"twin"};
  Witness witness;
  std::vector<InputObject> objects;
  std::vector<InputElement> elements;
};

constexpr std::string_view kReader =
    "reader (state <s> ^io.input-link.object <o>) (<o> ^speed <v>) --> (write <o> <v>)";
constexpr std::string_view kLate = "late (state <s> ^io.input-link <i>) (<i> ^{<a> <> object} <v>) --> (write <a> <v>)";

TEST(InputLink, WhatNoRuleTestsChangesInItsPlaceAndNobodyCanTell) {
  for (std::uint32_t seed = 1; seed <= 40; ++seed) {
    Twin near(0), heard(Mask(Event::kWme));
    std::mt19937 random(seed);
    const auto both = [&](auto call) {
      call(near);
      call(heard);
    };
    both([](Twin& twin) {
      twin.agent.mutable_settings().wait_snc = true;
      twin.Load(kReader);
    });
    for (int phase = 0; phase < 60; ++phase) {
      for (std::uint32_t calls = random() % 12; calls > 0; --calls) {
        const auto what = static_cast<std::uint32_t>(random() % 9);
        const auto which = static_cast<std::uint32_t>(random()), value = static_cast<std::uint32_t>(random());
        both([&](Twin& twin) { twin.Call(what, which, value); });
      }
      if (phase == 30) both([](Twin& twin) { twin.Load(kLate); });
      if (phase == 45) both([](Twin& twin) { twin.Excise("late"); });
      if (phase == 50 && seed % 2 == 0) both([](Twin& twin) { twin.Excise("reader"); });
      both([](Twin& twin) { twin.agent.Run(RunUnit::kDecision, 1); });
      ASSERT_EQ(near.State(), heard.State()) << "seed " << seed << ", phase " << phase;
      ASSERT_EQ(near.agent.CheckInvariants(), "");
    }
  }
}

TEST(InputLink, DecisionsOfAnAgentAtRestAreCountedWithoutBeingMade) {
  Twin made(0), skipped(0);
  const auto both = [&](auto call) {
    call(made);
    call(skipped);
  };
  both([](Twin& twin) {
    twin.agent.mutable_settings().wait_snc = true;
    twin.Load("go (state <s> ^superstate nil ^io.input-link.object) --> (<s> ^operator <o> +) (<o> ^name go)");
    twin.Load("done (state <s> ^operator.name go ^io (^input-link.speed <v> ^output-link <out>)) --> (<out> ^at <v>)");
  });
  std::size_t count = 0;
  for (std::uint32_t tick = 0; tick < 20; ++tick) {
    both([&](Twin& twin) {
      if (tick == 3) twin.Call(2, 0, 0);
      if (tick == 6) twin.Call(0, 0, 1);
      if (tick > 6) twin.Call(5, tick % 2, tick);
    });
    for (int decision = 0; decision < 10; ++decision) made.agent.Step(RunUnit::kDecision);
    for (std::uint64_t left = 10; left > 0;) {
      const std::uint64_t done = skipped.agent.Step(RunUnit::kDecision, left).decisions;
      EXPECT_TRUE(done == 1 || done == left);
      left -= done;
      count += done - 1;
    }
    ASSERT_EQ(made.State(), skipped.State()) << tick;
  }
  EXPECT_GT(count, 100u);
  // An observer of kDecision is informed of the first idle decision; the others are still skipped. For an observer of
  // kDecisionTrace, each decision is executed.
  skipped.agent.AddObserver(skipped.witness, Event::kDecision | Event::kReason);
  EXPECT_EQ(skipped.agent.Step(RunUnit::kDecision, 5).decisions, 5u);
  skipped.agent.AddObserver(skipped.witness, Event::kDecision | Event::kDecisionTrace);
  EXPECT_EQ(skipped.agent.Step(RunUnit::kDecision, 5).decisions, 1u);
}

}  // namespace
}  // namespace soarbox::kernel
