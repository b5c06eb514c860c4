# SPDX-License-Identifier: BSD-2-Clause
# The target soarbox::soar_client from an installed official Soar (SOARBOX_SOAR_ROOT), instead of our own kernel. Such a build leaves out what only
# our kernel offers (the `soarbox soar` shell).
find_path(SOARBOX_SOAR_INCLUDE sml_Client.h HINTS "${SOARBOX_SOAR_ROOT}" PATH_SUFFIXES include out/include NO_DEFAULT_PATH)
find_library(SOARBOX_SOAR_LIBRARY Soar HINTS "${SOARBOX_SOAR_ROOT}" PATH_SUFFIXES lib out bin NO_DEFAULT_PATH)
if(NOT SOARBOX_SOAR_INCLUDE OR NOT SOARBOX_SOAR_LIBRARY)
  message(FATAL_ERROR "SOARBOX_SOAR_ROOT is ${SOARBOX_SOAR_ROOT}, but sml_Client.h and libSoar are not both there "
                      "(looked in it and in its include, out/include, lib, out, bin)")
endif()
message(STATUS "Soar: the official library ${SOARBOX_SOAR_LIBRARY}")

add_library(soarbox_soar_client INTERFACE)
add_library(soarbox::soar_client ALIAS soarbox_soar_client)
# SYSTEM: warnings in headers of others are not errors.
target_include_directories(soarbox_soar_client SYSTEM INTERFACE "${SOARBOX_SOAR_INCLUDE}")
target_link_libraries(soarbox_soar_client INTERFACE "${SOARBOX_SOAR_LIBRARY}" ${CMAKE_DL_LIBS})
