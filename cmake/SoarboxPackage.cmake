# What `cpack` makes of an installation: one Debian package with the command, its scenarios, media and documents, and the
# client library with its headers. `./dev package` builds it from the release.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME soarbox)
set(CPACK_PACKAGE_VENDOR "The Soarbox authors")
set(CPACK_PACKAGE_CONTACT "The Soarbox authors <soarbox@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "3D sandbox in which people learn and develop Soar agents")
set(CPACK_PACKAGE_DESCRIPTION "Minds are written as Soar rules, as Lua scripts, or both; bodies walk, follow, avoid and fight in a
physical world. Comes with scenarios, a Soar kernel that behaves as Soar 9.6.3, and its client library
(sml_Client.h).")
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
# What is to be packed has been built; tests need not be.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
# Libraries that the programs are linked with are found by dpkg-shlibdeps. Ogre's plugins are loaded when they are
# needed; they come with its library. The window's texts want the fonts.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS OFF)
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/PackageDependencies.cmake")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-dejavu-core, libgl1-mesa-dri")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "g++, pkg-config, xvfb")
# The dynamic linker learns of the client library.
file(WRITE "${PROJECT_BINARY_DIR}/package/triggers" "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/package/triggers")
# Debian looks for the licence under this name.
configure_file("${PROJECT_SOURCE_DIR}/LICENSE" "${PROJECT_BINARY_DIR}/package/copyright" COPYONLY)
install(FILES "${PROJECT_BINARY_DIR}/package/copyright" DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/soarbox)
include(CPack)
