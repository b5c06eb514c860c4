// SPDX-License-Identifier: BSD-2-Clause
// Memory runs out at every moment of an agent's short life in turn: what throws is std::bad_alloc and nothing worse,
// and the agent, in whatever state it was left, can be destroyed and gives back all that it held.
#include <gtest/gtest.h>

#include <cstdint>
#include <new>
#include <string_view>

#include "diagnostics/counted_allocations.h"
#include "kernel/agent.h"
#include "kernel/io/input_link.h"

namespace soarbox::kernel {
namespace {

/// Operators, a tie, a substate with a result that a justification supports, input, output, and a rule that goes.
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

/// False if the agent ran out of memory and says so.
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
    // The next agent works as ever, and drops what only the store of shared rules still held of the last.
    Live();
    ASSERT_EQ(allocations::Live(), live_before) << "after the failure of allocation " << n;
  }
  EXPECT_GT(failures, count / kStride / 2);
}

}  // namespace
}  // namespace soarbox::kernel
