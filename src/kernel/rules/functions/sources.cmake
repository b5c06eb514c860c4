# The functions of right-hand sides, and gp.
list(APPEND SOARBOX_KERNEL_SOURCES
  rules/functions/builtin_functions.cpp
  rules/functions/arithmetic_functions.cpp
  rules/functions/control_functions.cpp
  rules/functions/memory_functions.cpp
  rules/functions/space_functions.cpp
  rules/functions/text_functions.cpp)
