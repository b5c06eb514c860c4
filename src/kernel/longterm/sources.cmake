# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES
  longterm/activations.cpp
  longterm/episode_commands.cpp
  longterm/episode_cue.cpp
  longterm/episode_query.cpp
  longterm/episode_recorder.cpp
  longterm/episode_records.cpp
  longterm/episode_store.cpp
  longterm/episode_terms.cpp
  longterm/episodic_memory.cpp
  longterm/graph_match.cpp
  longterm/installer.cpp
  longterm/knowledge.cpp
  longterm/knowledge_reader.cpp
  longterm/link_weights.cpp
  longterm/long_term.cpp
  longterm/recall_words.cpp
  longterm/origins.cpp
  longterm/semantic_commands.cpp
  longterm/semantic_memory.cpp
  longterm/semantic_query.cpp
  longterm/semantic_records.cpp
  longterm/shared_knowledge.cpp
  longterm/spreading.cpp
  longterm/surface_match.cpp
  longterm/store_term.cpp
  longterm/wm_activation.cpp
  longterm/written_order.cpp)
list(APPEND SOARBOX_KERNEL_TESTS
  longterm/episode_store_test.cpp
  longterm/episodic_memory_test.cpp
  longterm/naive_episodes_test_support.cpp
  longterm/origins_test.cpp
  longterm/semantic_search_test.cpp)
