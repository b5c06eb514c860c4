# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES learn/apoptosis.cpp
  learn/backtrace.cpp
  learn/carried_tests.cpp
  learn/choice_graph.cpp
  learn/chunker.cpp
  learn/draft_tests.cpp
  learn/explained_rule.cpp
  learn/explanation_log.cpp
  learn/firing_reader.cpp
  learn/identity_analysis.cpp
  learn/identity_graph.cpp
  learn/identity_plan.cpp
  learn/justification.cpp
  learn/justification_duplicates.cpp
  learn/justification_plan.cpp
  learn/reinforcement.cpp
  learn/repair.cpp
  learn/results.cpp
  learn/rl_template.cpp
  learn/rl_values.cpp
  learn/rule_builder.cpp
  learn/selection_knowledge.cpp
  learn/singletons.cpp)
list(APPEND SOARBOX_KERNEL_TESTS learn/reinforcement_test.cpp)
soarbox_kernel_test(kernel_chunking_test STAGES release sanitized SOURCES learn/chunking_test.cpp learn/soundness_test.cpp)
