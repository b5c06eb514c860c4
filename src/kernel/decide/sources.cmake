list(APPEND SOARBOX_KERNEL_SOURCES
  decide/exploration.cpp
  decide/preference_semantics.cpp)
soarbox_kernel_test(kernel_decide_test SOURCES decide/exploration_test.cpp decide/preference_semantics_test.cpp)
