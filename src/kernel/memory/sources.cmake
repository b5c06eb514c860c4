# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES
  memory/links.cpp
  memory/slot_index.cpp
  memory/wme_changes.cpp
  memory/working_memory.cpp)
