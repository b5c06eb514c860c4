# What `cpack` makes of an installation: a Debian package with the command, its scenarios, media and documents, and the
# client library with its headers; and python3-soarbox, if the binding for Python was built. `./dev package` builds them
# from the release.
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
if(SOARBOX_HAS_PYTHON)
  set(CPACK_DEB_COMPONENT_INSTALL ON)
  set(CPACK_COMPONENTS_GROUPING IGNORE)
  set(CPACK_COMPONENTS_ALL Unspecified python)
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_NAME soarbox)
  set(CPACK_COMPONENT_UNSPECIFIED_DESCRIPTION "${CPACK_PACKAGE_DESCRIPTION}")
  set(CPACK_DEBIAN_UNSPECIFIED_PACKAGE_CONTROL_EXTRA "${CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA}")
  unset(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-soarbox)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "Soar agents and Soarbox's worlds from Python
Modules soar_sml and Python_sml_ClientInterface (the client interface of Soar 9.6), and the package soarbox, which
runs worlds tick by tick.")
  # The module is for one version of Python.
  math(EXPR next "${SOARBOX_PYTHON_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "soarbox (= ${PROJECT_VERSION}), python3 (>= 3.${SOARBOX_PYTHON_MINOR}), python3 (<< 3.${next}), libc6, libstdc++6")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "")
endif()
include(CPack)
