// SPDX-License-Identifier: BSD-2-Clause
// Memory runs out at every moment of an agent's short life in turn: what throws is std::bad_alloc and nothing worse,
// and the agent, in whatever state it was left, can be destroyed and gives back all that it held.
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <new>
#include <string_view>

#include "kernel/agent.h"
#include "kernel/io/input_link.h"

// This program counts what it allocates, and refuses when it is told to.
namespace {
constexpr std::int64_t kNever = -1;
std::int64_t allocations_left = kNever;
std::int64_t allocations = 0;
std::int64_t live = 0;
}  // namespace

// GCC 12 sees the inlined std::free, but not that this program's own operator new used std::malloc.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

void* operator new(std::size_t size) {
  if (allocations_left == 0) throw std::bad_alloc();
  if (allocations_left > 0) --allocations_left;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (!memory) throw std::bad_alloc();
  ++allocations;
  ++live;
  return memory;
}
void operator delete(void* memory) noexcept {
  if (memory) --live;
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  operator delete(memory);
}

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
  const std::int64_t live_before = live, allocations_before = allocations;
  Live();
  const std::int64_t count = allocations - allocations_before;
  ASSERT_EQ(live, live_before);
  ASSERT_GT(count, 100);
  std::int64_t failures = 0;
  for (std::int64_t n = 0; n < count; n += kStride) {
    allocations_left = n;
    try {
      if (!Live()) ++failures;
    } catch (const std::bad_alloc&) {
      ++failures;
    }
    allocations_left = kNever;
    // The next agent works as ever, and drops what only the store of shared rules still held of the last.
    Live();
    ASSERT_EQ(live, live_before) << "after the failure of allocation " << n;
  }
  EXPECT_GT(failures, count / kStride / 2);
}

}  // namespace
}  // namespace soarbox::kernel
