# SPDX-License-Identifier: BSD-2-Clause
# Recast and Detour, which come without a CMake package: the targets RecastNavigation::Recast and
# RecastNavigation::Detour. RecastNavigation_ROOT names another prefix.
find_path(RecastNavigation_INCLUDE_DIR Recast.h PATH_SUFFIXES recastnavigation recast)
find_library(RecastNavigation_RECAST_LIBRARY Recast)
find_library(RecastNavigation_DETOUR_LIBRARY Detour)

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(RecastNavigation
  REQUIRED_VARS RecastNavigation_RECAST_LIBRARY RecastNavigation_DETOUR_LIBRARY RecastNavigation_INCLUDE_DIR)
mark_as_advanced(RecastNavigation_INCLUDE_DIR RecastNavigation_RECAST_LIBRARY RecastNavigation_DETOUR_LIBRARY)

if(RecastNavigation_FOUND)
  foreach(part Recast Detour)
    if(NOT TARGET RecastNavigation::${part})
      string(TOUPPER ${part} upper)
      add_library(RecastNavigation::${part} UNKNOWN IMPORTED)
      set_target_properties(RecastNavigation::${part} PROPERTIES
        IMPORTED_LOCATION "${RecastNavigation_${upper}_LIBRARY}"
        INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "${RecastNavigation_INCLUDE_DIR}"
        INTERFACE_INCLUDE_DIRECTORIES "${RecastNavigation_INCLUDE_DIR}")
    endif()
  endforeach()
endif()
