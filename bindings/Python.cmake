# SPDX-License-Identifier: BSD-2-Clause
# The distribution's Python: the one whose headers the distribution has. SOARBOX_PYTHON_EXECUTABLE names another one.
set(SOARBOX_PYTHON_EXECUTABLE "" CACHE FILEPATH "The Python that the binding is for")
if(SOARBOX_PYTHON_EXECUTABLE)
  set(Python_EXECUTABLE "${SOARBOX_PYTHON_EXECUTABLE}")
elseif(EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)
endif()
find_package(Python QUIET COMPONENTS Interpreter Development.Module)
soarbox_choose_binding(PYTHON Python "Python's headers" "${Python_FOUND}" "install python3-dev")
set(SOARBOX_BINDING_PYTHON "${Python_EXECUTABLE}" CACHE INTERNAL "The Python that the binding is for")
set(SOARBOX_PYTHON_MINOR "${Python_VERSION_MINOR}" CACHE INTERNAL "Its version: 3.this")
