# SPDX-License-Identifier: BSD-2-Clause
list(APPEND SOARBOX_KERNEL_SOURCES
  imagery/computed_filter.cpp
  imagery/convex.cpp
  imagery/extract.cpp
  imagery/filter.cpp
  imagery/filter_inputs.cpp
  imagery/filter_kinds.cpp
  imagery/filter_pool.cpp
  imagery/imagery.cpp
  imagery/measure_filters.cpp
  imagery/measures.cpp
  imagery/memory_writer.cpp
  imagery/node_filters.cpp
  imagery/other_filters.cpp
  imagery/imagery_scene.cpp
  imagery/scene_command.cpp
  imagery/scene_feed.cpp
  imagery/scene_lines.cpp
  imagery/scene_in_memory.cpp
  imagery/space.cpp
  imagery/state_scene.cpp)
list(APPEND SOARBOX_KERNEL_TESTS imagery/geometry_test.cpp imagery/imagery_test.cpp)
