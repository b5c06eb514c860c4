# SPDX-License-Identifier: BSD-2-Clause
# The matcher: topology, memories and the conflict set.
list(APPEND SOARBOX_KERNEL_SOURCES
  match/alpha_memories.cpp
  match/emissions.cpp
  match/fixed_match.cpp
  match/join_links.cpp
  match/match_set.cpp
  match/match_support.cpp
  match/meeting_order.cpp
  match/network.cpp
  match/node_states.cpp
  match/pair_tests.cpp
  match/rete.cpp
  match/rete_builder.cpp
  match/rete_builder_shared.cpp
  match/rete_check.cpp
  match/rete_guard.cpp
  match/rete_join.cpp
  match/rete_join_sparse.cpp
  match/rete_match.cpp
  match/rete_nodes.cpp
  match/rete_query.cpp
  match/rete_remove.cpp
  match/rete_rules.cpp
  match/rete_shared.cpp
  match/rete_sparse.cpp
  match/rule_info.cpp
  match/shared_conjunctions.cpp
  match/sparse_memories.cpp
  match/token_pool.cpp)
soarbox_kernel_test(kernel_match_test STAGES release sanitized SOURCES match/match_test_support.cpp match/naive_matcher_test_support.cpp match/random_rules_test_support.cpp match/match_parts_test.cpp match/rete_test.cpp match/rete_random_test.cpp match/rete_shared_test.cpp match/rete_guard_test.cpp)
