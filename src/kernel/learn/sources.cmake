list(APPEND SOARBOX_KERNEL_SOURCES learn/justification.cpp)
