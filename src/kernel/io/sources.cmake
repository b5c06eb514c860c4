list(APPEND SOARBOX_KERNEL_SOURCES
  io/input_link.cpp
  io/output_link.cpp)
