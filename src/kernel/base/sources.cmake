# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES base/forkable_room.cpp base/random.cpp base/symbol_table.cpp base/symbol_text.cpp)
list(APPEND SOARBOX_KERNEL_TESTS
  base/forkable_room_test.cpp
  base/random_test.cpp
  base/symbol_table_test.cpp)
