# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES
  decide/agent_rules.cpp
  decide/decision.cpp
  decide/descriptions.cpp
  decide/elaboration.cpp
  decide/element_events.cpp
  decide/agent_core.cpp
  decide/exploration.cpp
  decide/firing.cpp
  decide/goal_changes.cpp
  decide/goal_dependency_set.cpp
  decide/goal_stack.cpp
  decide/handle_check.cpp
  decide/instantiation_table.cpp
  decide/invariants.cpp
  decide/modules.cpp
  decide/preference_changes.cpp
  decide/preference_semantics.cpp
  decide/rule_context.cpp
  decide/rule_directory.cpp
  decide/rule_sharing.cpp
  decide/run_control.cpp
  decide/slot_decision.cpp)
list(APPEND SOARBOX_KERNEL_TESTS
  decide/exploration_test.cpp
  decide/preference_semantics_test.cpp
  decide/decision_trace_test.cpp
  decide/modules_test.cpp)
# Looks at the memory of its process.
soarbox_kernel_test(kernel_agent_test SOURCES decide/agent_test.cpp decide/rule_sharing_test.cpp)
soarbox_kernel_test(kernel_allocation_test STAGES release sanitized SOURCES decide/allocation_test.cpp DEPENDS soarbox_counted_allocations)
soarbox_kernel_test(kernel_random_agents_test STAGES release sanitized SOURCES decide/random_agents_test_support.cpp decide/random_agents_test.cpp match/naive_matcher_test_support.cpp)
soarbox_kernel_test(kernel_failing_allocation_test SOURCES decide/failing_allocation_test.cpp DEPENDS soarbox_counted_allocations)
