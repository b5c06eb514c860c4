// SPDX-License-Identifier: BSD-2-Clause
// Fails each allocation in the life of an agent in turn. The only exception thrown must be std::bad_alloc. The agent
// can then be destroyed, in whatever state it is, and must free all its memory.
#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <string_view>

#include "diagnostics/counted_allocations.h"
#include "kernel/agent.h"
#include "kernel/io/input_link.h"

namespace soarbox::kernel {
namespace {

/// Rules with operators, a tie, a substate with a result that a justification supports, input, output, and an excised
/// rule.
constexpr std::string_view kRules[] = {
    "begin (state <s> ^superstate nil -^block) --> (<s> ^operator <o> +) (<o> ^name begin)",
    "began (state <s> ^operator.name begin) --> (<s> ^block <x> <y>) (<x> ^size 3) (<y> ^size 1)",
    "propose (state <s> ^superstate nil ^block <b>) (<b> -^done yes) --> (<s> ^operator <o> +) (<o> ^name take ^block "
    "<b>)",
    "compare (state <s> ^impasse tie ^item <a> ^item <b> ^superstate <ss>) (<a> ^block.size <m>) "
    "(<b> ^block.size {<n> > <m>}) --> (<ss> ^operator <b> > <a>)",
    "take (state <s> ^operator <o> ^io.output-link <out>) (<o> ^name take ^block <b>) --> (<b> ^done yes) (<out> ^took "
    "<t>) "
    "(<t> ^text (concat |a block of size | 3))",
    "absent (state <s> ^superstate nil ^block <b>) -{ (<s> ^block <c>) (<c> ^done yes) } --> (<s> ^all-there yes)",
};

/// Returns false if the agent ran out of memory and reported it.
bool Live() {
  Agent agent("short-lived");
  for (const std::string_view rule : kRules) agent.LoadProduction(rule);
  agent.input().Add(InputObject::kInputLink, "range", 0.5);
  agent.Run(RunUnit::kDecision, 4);
  agent.Excise(agent.FindProduction("compare"));
  agent.Run(RunUnit::kDecision, 4);
  agent.InitSoar();
  const RunResult last = agent.Run(RunUnit::kDecision, 2);
  if (!agent.out_of_memory()) return true;
  EXPECT_EQ(last.reason, StopReason::kHalted);
  EXPECT_TRUE(agent.halted());
  return false;
}

TEST(FailingAllocation, LeavesAnAgentThatCanBeDestroyed) {
#ifdef SOARBOX_CHECK_INVARIANTS
  constexpr std::int64_t kStride = 25;
#else
  constexpr std::int64_t kStride = 1;
#endif
  Live();
  const std::int64_t live_before = allocations::Live(), allocations_before = allocations::Count();
  Live();
  const std::int64_t count = allocations::Count() - allocations_before;
  ASSERT_EQ(allocations::Live(), live_before);
  ASSERT_GT(count, 100);
  std::int64_t failures = 0;
  for (std::int64_t n = 0; n < count; n += kStride) {
    allocations::RefuseAfter(n, allocations::Refusal::kFromThenOn);
    try {
      if (!Live()) ++failures;
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    allocations::Allow();
    // The next agent works as usual. It also frees what only the store of shared rules still held for the failed agent.
    Live();
    ASSERT_EQ(allocations::Live(), live_before) << "after the failure of allocation " << n;
  }
  EXPECT_GT(failures, count / kStride / 2);
}

}  // namespace
}  // namespace soarbox::kernel
