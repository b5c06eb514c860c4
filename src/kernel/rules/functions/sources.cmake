# SPDX-License-Identifier: BSD-2-Clause
# The functions of right-hand sides.
list(APPEND SOARBOX_KERNEL_SOURCES
  rules/functions/arithmetic_functions.cpp
  rules/functions/builtin_functions.cpp
  rules/functions/control_functions.cpp
  rules/functions/copy_functions.cpp
  rules/functions/dice_functions.cpp
  rules/functions/memory_functions.cpp
  rules/functions/random_functions.cpp
  rules/functions/rounding_functions.cpp
  rules/functions/space_functions.cpp
  rules/functions/text_functions.cpp
  rules/functions/xml_functions.cpp)
list(APPEND SOARBOX_KERNEL_TESTS rules/functions/functions_test.cpp)
