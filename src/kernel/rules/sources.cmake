# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES
  rules/lexer.cpp rules/parser.cpp rules/read_conditions.cpp rules/read_actions.cpp rules/finish_rule.cpp
  rules/reorder.cpp rules/waiting_tests.cpp rules/condition_queue.cpp rules/variable_index.cpp rules/draft.cpp rules/production.cpp rules/chunk_variables.cpp rules/print_production.cpp rules/rule_gaps.cpp
  rules/syntax_help.cpp)
list(APPEND SOARBOX_KERNEL_TESTS
  rules/lexer_test.cpp
  rules/parser_test.cpp
  rules/condition_queue_test.cpp
  rules/rule_gaps_test.cpp)
