list(APPEND SOARBOX_KERNEL_SOURCES learn/justification.cpp
  learn/justification_duplicates.cpp)
