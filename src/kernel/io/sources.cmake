# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES
  io/input_link.cpp
  io/output_link.cpp)
list(APPEND SOARBOX_KERNEL_TESTS
  io/input_link_test.cpp)
