# What `cmake --install` puts into a prefix: the command with its scenarios, media and documents, and the client library
# with its headers, a CMake package (find_package(Soarbox), target Soarbox::sml) and a pkg-config file (soarbox-sml).
# SoarboxPackage.cmake makes a Debian package of the same.
include(CMakePackageConfigHelpers)

install(TARGETS soarbox RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
if(TARGET soarbox_window)
  install(TARGETS soarbox_window RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
install(DIRECTORY media scenarios lessons DESTINATION ${CMAKE_INSTALL_DATADIR}/soarbox)
# The page for browsers, where npm has built it, and a service that serves it.
install(DIRECTORY web/dist/page DESTINATION ${CMAKE_INSTALL_DATADIR}/soarbox OPTIONAL)
configure_file(cmake/soarbox-serve.service.in "${PROJECT_BINARY_DIR}/soarbox-serve.service" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/soarbox-serve.service" DESTINATION lib/systemd/system)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/soarbox)
# What a user reads; the specification and the design stay with the source.
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/soarbox PATTERN spec EXCLUDE PATTERN design EXCLUDE)

if(TARGET soarbox_sml)
  install(TARGETS soarbox_sml EXPORT SoarboxTargets LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(FILES ${SOARBOX_SML_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/soarbox-sml)
  install(FILES ${SOARBOX_MIND_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/soarbox-sml/mind)
  install(EXPORT SoarboxTargets NAMESPACE Soarbox:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Soarbox)
  configure_package_config_file(
    "${CMAKE_CURRENT_SOURCE_DIR}/cmake/SoarboxConfig.cmake.in" "${PROJECT_BINARY_DIR}/SoarboxConfig.cmake"
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Soarbox)
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/SoarboxConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
  install(FILES "${PROJECT_BINARY_DIR}/SoarboxConfig.cmake" "${PROJECT_BINARY_DIR}/SoarboxConfigVersion.cmake"
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Soarbox)
  # The file finds its prefix from where it lies, so that an installed tree can be moved.
  file(RELATIVE_PATH SOARBOX_PC_TO_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  configure_file("${CMAKE_CURRENT_SOURCE_DIR}/cmake/soarbox-sml.pc.in" "${PROJECT_BINARY_DIR}/soarbox-sml.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/soarbox-sml.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()
include(SoarboxPackage)
