# How every target of the project is built: language level, warnings, sanitizers,
# and the two functions that the modules' CMakeLists.txt use.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

find_program(SOARBOX_CCACHE ccache)
if(SOARBOX_CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${SOARBOX_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${SOARBOX_CCACHE}")
endif()
find_program(SOARBOX_MOLD mold)
if(SOARBOX_MOLD)
  add_link_options(-fuse-ld=mold)
endif()

add_library(soarbox_options INTERFACE)
target_include_directories(soarbox_options INTERFACE "${PROJECT_SOURCE_DIR}/src")
target_compile_options(soarbox_options INTERFACE
  -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual -Werror
  # Determinism is a public contract: no fused multiply-add, no machine-specific code.
  -ffp-contract=off
  # GCC 12 warns of impossible overlaps in std::string at -O3 (its bug 105651).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict>)
# Functions that no shared library exports can be inlined across files; the client API marks what it exports.
target_compile_options(soarbox_options INTERFACE
  $<$<CONFIG:Release>:-fvisibility=hidden;-fvisibility-inlines-hidden;-fno-semantic-interposition>
  # False alarms of GCC 12 in optimised std::string and std::variant.
  $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
if(SOARBOX_SANITIZE STREQUAL "address")
  target_compile_options(soarbox_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(soarbox_options INTERFACE -fsanitize=address,undefined)
elseif(SOARBOX_SANITIZE STREQUAL "thread")
  # asio's fences are unknown to GCC's thread sanitizer; it says so as a warning.
  target_compile_options(soarbox_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
  target_link_options(soarbox_options INTERFACE -fsanitize=thread)
elseif(SOARBOX_SANITIZE STREQUAL "fuzzer")
  target_compile_options(soarbox_options INTERFACE -fsanitize=address,undefined,fuzzer-no-link -fno-sanitize-recover=all)
  target_link_options(soarbox_options INTERFACE -fsanitize=address,undefined)
endif()
if(SOARBOX_CHECK_INVARIANTS)
  target_compile_definitions(soarbox_options INTERFACE SOARBOX_CHECK_INVARIANTS)
endif()
find_package(Threads REQUIRED)
target_link_libraries(soarbox_options INTERFACE Threads::Threads)

# Eight files of a target at a time as one: reading headers is half of a build that nobody repeats for one changed file.
# So names that only one file uses differ from those of its neighbours all the same.
option(SOARBOX_UNITY "Compile files in batches (the builds with sanitizers)" OFF)
function(soarbox_in_batches target)
  if(SOARBOX_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    # GCC takes the files of a batch for headers, in which an unnamed namespace would be a slip.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# soarbox_library(NAME [ONE_BY_ONE] SOURCES file... [DEPENDS target...] [PRIVATE_DEPENDS target...])
# A static library soarbox_NAME (alias soarbox::NAME) of the sources listed. ONE_BY_ONE: its files are never compiled in
# batches, as each has a table of the same name.
function(soarbox_library name)
  cmake_parse_arguments(arg "ONE_BY_ONE" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(soarbox_${name} STATIC ${arg_SOURCES})
  add_library(soarbox::${name} ALIAS soarbox_${name})
  target_link_libraries(soarbox_${name} PUBLIC soarbox_options ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})
  if(NOT arg_ONE_BY_ONE)
    soarbox_in_batches(soarbox_${name})
  endif()
endfunction()

# soarbox_test(NAME SOURCES file... [DEPENDS target...] [LABELS label...])
# A GoogleTest program whose cases become tests of CTest.
function(soarbox_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;LABELS" ${ARGN})
  if(NOT SOARBOX_TESTS)
    return()
  endif()
  set_property(GLOBAL APPEND PROPERTY soarbox_test_programs ${name})
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE soarbox_options ${arg_DEPENDS} GTest::gtest GTest::gmock GTest::gtest_main)
  target_compile_definitions(${name} PRIVATE SOARBOX_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  soarbox_in_batches(${name})
  # Virtual displays that start at the same moment may pick the same number.
  set(lock "")
  if("display" IN_LIST arg_LABELS)
    set(lock RESOURCE_LOCK display)
  endif()
  # The program's name is a label, so that the tests of some programs can be picked (ctest -L).
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${name};${arg_LABELS}" TIMEOUT 300 ${lock})
endfunction()
