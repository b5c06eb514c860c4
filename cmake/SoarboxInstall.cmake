# SPDX-License-Identifier: BSD-2-Clause
# The files that `cmake --install` installs. Each component becomes a Debian package (packaging/debian, packaging/make_debs):
#
# command        the command and the server, with its scenarios, lessons, media, the page for browsers, manual pages and completion
# window         the program with the window, which needs Ogre and SDL
# library        the client library; development: its headers, a CMake package (find_package(Soarbox), target
#                Soarbox::sml) and a pkg-config file (soarbox-sml)
# documentation  what a user reads
# python, java   the library for other languages (bindings)
include(CMakePackageConfigHelpers)

install(TARGETS soarbox soarbox_server RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT command)
if(TARGET soarbox_window)
  install(TARGETS soarbox_window RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT window)
endif()
install(DIRECTORY media scenarios lessons DESTINATION ${CMAKE_INSTALL_DATADIR}/soarbox COMPONENT command)
install(FILES "${PROJECT_BINARY_DIR}/share/soarbox/commit" DESTINATION ${CMAKE_INSTALL_DATADIR}/soarbox COMPONENT command OPTIONAL)
# The page for browsers, if npm has built it, and a service that serves it.
install(DIRECTORY web/dist/page DESTINATION ${CMAKE_INSTALL_DATADIR}/soarbox COMPONENT command OPTIONAL)
install(CODE "set(SOARBOX_BINDIR \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_BINDIR}\")
  configure_file(\"${PROJECT_SOURCE_DIR}/cmake/soarbox-serve.service.in\"
    \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/systemd/system/soarbox-serve.service\" @ONLY)" COMPONENT command)
# The manual pages: the command prints its own help and that of each sub-command.
set(manual "${PROJECT_BINARY_DIR}/man/man1")
add_custom_command(OUTPUT "${manual}/soarbox.1" COMMAND soarbox help --pages "${manual}" DEPENDS soarbox
  COMMENT "Writing the manual" VERBATIM)
add_custom_target(manual ALL DEPENDS "${manual}/soarbox.1")
install(DIRECTORY "${manual}" DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT command OPTIONAL)
install(FILES packaging/completion/soarbox.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME soarbox
        COMPONENT command)
install(FILES packaging/completion/_soarbox DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT command)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/soarbox COMPONENT licence)
# The pages for users, with the description of Soar 9.6.3 and of the client interface. Pages for maintainers are not installed: links to them become
# plain text.
install(FILES README.md CHANGELOG.md CITATION.cff SECURITY.md CODE_OF_CONDUCT.md DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/soarbox
        COMPONENT documentation)
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/soarbox COMPONENT documentation PATTERN docs/dev EXCLUDE)
install(CODE "set(pages \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_DATADIR}/doc/soarbox\")
  include(\"${CMAKE_CURRENT_SOURCE_DIR}/cmake/CutLinks.cmake\")" COMPONENT documentation)

if(TARGET soarbox_sml)
  install(TARGETS soarbox_sml EXPORT SoarboxTargets
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
  install(FILES ${SOARBOX_SML_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/soarbox-sml COMPONENT development)
  install(FILES ${SOARBOX_MIND_HEADERS} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/soarbox-sml/mind COMPONENT development)
  install(EXPORT SoarboxTargets NAMESPACE Soarbox:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Soarbox COMPONENT development)
  configure_package_config_file(
    "${CMAKE_CURRENT_SOURCE_DIR}/cmake/SoarboxConfig.cmake.in" "${PROJECT_BINARY_DIR}/SoarboxConfig.cmake"
    INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Soarbox)
  write_basic_package_version_file("${PROJECT_BINARY_DIR}/SoarboxConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
  install(FILES "${PROJECT_BINARY_DIR}/SoarboxConfig.cmake" "${PROJECT_BINARY_DIR}/SoarboxConfigVersion.cmake"
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/Soarbox COMPONENT development)
  # The file determines its prefix from its own path, so that an installed tree can be moved.
  file(RELATIVE_PATH SOARBOX_PC_TO_PREFIX "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
  configure_file("${CMAKE_CURRENT_SOURCE_DIR}/cmake/soarbox-sml.pc.in" "${PROJECT_BINARY_DIR}/soarbox-sml.pc" @ONLY)
  install(FILES "${PROJECT_BINARY_DIR}/soarbox-sml.pc" DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
endif()
