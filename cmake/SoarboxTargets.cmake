# SPDX-License-Identifier: BSD-2-Clause
# How every target of the project is built: language level, warnings, sanitizers,
# and the two functions that the modules' CMakeLists.txt use.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT EMSCRIPTEN)
  set(CMAKE_POSITION_INDEPENDENT_CODE ON)
endif()
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")

# Code for sockets, processes and similar has a file without this suffix, and a replacement with it for platforms that lack them (WebAssembly).
set(SOARBOX_ABSENT "")
if(EMSCRIPTEN)
  set(SOARBOX_ABSENT _absent)
endif()

find_program(SOARBOX_CCACHE ccache)
# em++ calls the cache itself (cmake/wasm/get).
if(SOARBOX_CCACHE AND NOT EMSCRIPTEN)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${SOARBOX_CCACHE}")
  set(CMAKE_C_COMPILER_LAUNCHER "${SOARBOX_CCACHE}")
endif()
find_program(SOARBOX_MOLD mold)
if(SOARBOX_MOLD AND NOT EMSCRIPTEN)
  add_link_options(-fuse-ld=mold)
endif()

add_library(soarbox_options INTERFACE)
target_include_directories(soarbox_options INTERFACE "${PROJECT_SOURCE_DIR}/src")
# Builds for developers treat warnings as errors. Users compile releases with any compiler, and do not look for warnings in a first build. Searching
# for them would take a tenth of the time.
set(soarbox_warnings -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual -Werror)
if(NOT SOARBOX_CI AND NOT SOARBOX_SANITIZE AND (CMAKE_BUILD_TYPE STREQUAL "Release" OR SOARBOX_PRECOMPILE))
  set(soarbox_warnings -w)
endif()
target_compile_options(soarbox_options INTERFACE
  ${soarbox_warnings}
  # Large batches: GCC starts to free memory only when it has allocated half a gigabyte.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${SOARBOX_UNITY}>>:SHELL:--param ggc-min-heapsize=500000>
  # Determinism is a public contract: no fused multiply-add, no machine-specific code.
  -ffp-contract=off
  # GCC 12 reports false overlaps and sizes in std::string at -O3 (its bug 105651).
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>:-Wno-restrict;-Wno-stringop-overflow>)
# Functions that no shared library exports can be inlined across files; the client API marks what it exports.
target_compile_options(soarbox_options INTERFACE
  $<$<CONFIG:Release>:-fvisibility=hidden;-fvisibility-inlines-hidden;-fno-semantic-interposition>
  # False warnings of GCC 12 in optimised std::string and std::variant.
  $<$<AND:$<CONFIG:Release>,$<CXX_COMPILER_ID:GNU>>:-Wno-maybe-uninitialized>)
if(SOARBOX_SANITIZE STREQUAL "address")
  target_compile_options(soarbox_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(soarbox_options INTERFACE -fsanitize=address,undefined)
elseif(SOARBOX_SANITIZE STREQUAL "thread")
  # GCC's thread sanitizer does not support asio's fences and warns about this.
  target_compile_options(soarbox_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer
    $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
  target_link_options(soarbox_options INTERFACE -fsanitize=thread)
elseif(SOARBOX_SANITIZE STREQUAL "fuzzer")
  target_compile_options(soarbox_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all)
  target_link_options(soarbox_options INTERFACE -fsanitize=address,undefined)
endif()
if(SOARBOX_CHECK_INVARIANTS)
  target_compile_definitions(soarbox_options INTERFACE SOARBOX_CHECK_INVARIANTS)
endif()
find_package(Threads REQUIRED)
target_link_libraries(soarbox_options INTERFACE Threads::Threads)

# Parsing TOML: uses the compiled library if the package has it, because its headers alone take seconds per file. Builds with sanitizers and fuzzers
# compile the headers, so that their code is checked, too.
find_package(tomlplusplus REQUIRED)
find_library(SOARBOX_TOML_LIBRARY tomlplusplus)
add_library(soarbox_toml INTERFACE)
add_library(soarbox::toml ALIAS soarbox_toml)
target_link_libraries(soarbox_toml INTERFACE tomlplusplus::tomlplusplus)
if(SOARBOX_TOML_LIBRARY AND NOT SOARBOX_SANITIZE)
  target_compile_definitions(soarbox_toml INTERFACE TOML_HEADER_ONLY=0 TOML_SHARED_LIB=1)
  target_link_libraries(soarbox_toml INTERFACE "${SOARBOX_TOML_LIBRARY}")
endif()

# Compiles files of a target together, because reading headers takes half of the time of a full build. A batch has eight files, in order. File-local
# names should still differ between neighbouring files. ALWAYS: independent of the option. In libraries with LARGE_BATCHES, a batch has up to
# SOARBOX_BATCH_BYTES, and files that define the same name are put into different batches (soarbox_sort_into_batches).
option(SOARBOX_UNITY "Compile files in batches (the builds with sanitizers)" OFF)
set(SOARBOX_BATCH_BYTES 235000 CACHE STRING "Text of a large batch, at most, if it has more than one file")
function(soarbox_in_batches target)
  if(SOARBOX_UNITY OR "ALWAYS" IN_LIST ARGN)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    # GCC treats the files of a batch as headers, in which an unnamed namespace would be a mistake.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# The same with large batches.
function(soarbox_in_large_batches target)
  soarbox_in_batches(${target} ${ARGN})
  if(SOARBOX_UNITY OR "ALWAYS" IN_LIST ARGN)
    # Deferred until the folder has added all sources; the argument would be expanded too late without EVAL.
    cmake_language(EVAL CODE "cmake_language(DEFER CALL soarbox_sort_into_batches ${target})")
  endif()
endfunction()

# Finds the file-local names of a file, in its unnamed namespace: functions and constants at the beginning of a line.
function(soarbox_names_defined_in file result)
  file(READ "${file}" text)
  string(FIND "${text}" "\nnamespace {" begin)
  string(FIND "${text}" "\n}  // namespace\n" end REVERSE)
  math(EXPR length "${end} - ${begin}")
  if(begin LESS 0 OR length LESS 0)
    set(${result} "" PARENT_SCOPE)
    return()
  endif()
  string(SUBSTRING "${text}" ${begin} ${length} text)
  string(REGEX REPLACE "//[^\n]*" "" text "${text}")
  string(REGEX MATCHALL "\n[a-zA-Z][a-zA-Z0-9_:<>,&* ]*[ &*][a-zA-Z_0-9]+ *[({=]" functions "${text}")
  # Aliases may be repeated; a base class is not a name of the file.
  list(FILTER functions EXCLUDE REGEX "^\n(namespace|using|class|struct|enum) ")
  string(REGEX MATCHALL "\n(constexpr|const|static)[a-zA-Z0-9_:<>,&* ]*[ &*]k[a-zA-Z_0-9]+" constants "${text}")
  string(REGEX MATCHALL "\n(enum class|struct|class|enum) [a-zA-Z_0-9]+" types "${text}")
  set(names "")
  foreach(definition IN LISTS functions constants types)
    if(definition MATCHES "([a-zA-Z_0-9]+) *[({=]?$")
      list(APPEND names "${CMAKE_MATCH_1}")
    endif()
  endforeach()
  list(REMOVE_DUPLICATES names)
  set(${result} "${names}" PARENT_SCOPE)
endfunction()

# Puts each source of a target that is in no batch into the first batch that has space and none of its names. CMake compiles sources with their own
# options alone. A target with the property SOARBOX_HUGE_BATCHES gets as few batches as possible, of about the same size, because each batch reads
# the headers again. (In frequently executed code the compiler would inline less.)
function(soarbox_sort_into_batches target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(is_huge ${target} SOARBOX_HUGE_BATCHES)
  set(most ${SOARBOX_BATCH_BYTES})
  if(is_huge)
    set(total 0)
    foreach(source IN LISTS sources)
      if(source MATCHES "\\.cpp$")
        get_filename_component(path "${source}" ABSOLUTE)
        file(SIZE "${path}" bytes)
        math(EXPR total "${total} + ${bytes}")
      endif()
    endforeach()
    # Slightly larger than the average, because files do not fit exactly.
    math(EXPR most "${total} / (${total} / 280000 + 1) + 12000")
  endif()
  set(last -1)
  foreach(source IN LISTS sources)
    get_source_file_property(group "${source}" UNITY_GROUP)
    if(group OR NOT source MATCHES "\\.cpp$")
      continue()
    endif()
    get_filename_component(path "${source}" ABSOLUTE)
    file(SIZE "${path}" bytes)
    soarbox_names_defined_in("${path}" names)
    set(batch 0)
    while(batch LESS_EQUAL last)
      math(EXPR sum "${bytes_${batch}} + ${bytes}")
      set(common ${names})
      list(REMOVE_ITEM common ${names_${batch}} "")
      list(LENGTH names count)
      list(LENGTH common rest)
      if(sum LESS_EQUAL most AND count EQUAL rest)
        break()
      endif()
      math(EXPR batch "${batch} + 1")
    endwhile()
    if(batch GREATER last)
      set(last ${batch})
      set(bytes_${batch} 0)
      set(names_${batch} "")
    endif()
    math(EXPR bytes_${batch} "${bytes_${batch}} + ${bytes}")
    list(APPEND names_${batch} ${names})
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP batch_${batch} SKIP_UNITY_BUILD_INCLUSION OFF)
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
endfunction()

# All test programs share one precompiled header with GoogleTest and the most common standard headers, which saves a second and a half per program.
# It is off in developers' builds, because a file with a missing include must not compile. Libraries in large batches gain nothing. (GCC stores the
# optimisation level in a precompiled header and uses it, whatever the options of a file are.)
option(SOARBOX_PRECOMPILE "Precompile headers for tests (builds that nobody repeats)" OFF)
if(SOARBOX_PRECOMPILE AND SOARBOX_TESTS)
  # Without this option, a compiler cache does not cache files that read these headers.
  if(SOARBOX_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros "${SOARBOX_CCACHE}")
  endif()
  # GCC 12 does not treat a precompiled header as a system header, and then reports false bounds in std::string.
  target_compile_options(soarbox_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess;-Wno-array-bounds;-Wno-stringop-overread>)
  file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/headers/program.cpp" CONTENT "int main() {}\n")
  add_executable(soarbox_test_headers EXCLUDE_FROM_ALL "${PROJECT_BINARY_DIR}/headers/program.cpp")
  target_link_libraries(soarbox_test_headers PRIVATE soarbox_options GTest::gtest GTest::gmock)
  target_compile_options(soarbox_test_headers PRIVATE $<$<CONFIG:Release>:-O1>)
  target_precompile_headers(soarbox_test_headers PRIVATE <algorithm> <array> <charconv> <cmath> <deque> <filesystem> <fstream> <functional>
      <map> <memory> <optional> <set> <span> <sstream> <string> <string_view> <unordered_map> <utility> <variant> <vector>
      <gmock/gmock.h> <gtest/gtest.h>)
endif()
# Instructions of the kernel and of its callers are counted.
set(soarbox_counted "^soarbox_(diagnostics|kernel|mind|journal|sml|soar_client)")
# soarbox_is_fuzzed(TARGET): instruments a target for fuzzers, because it parses foreign text or bytes. Instrumented code takes a fifth longer to
# compile and runs slower, so only these targets are instrumented.
function(soarbox_is_fuzzed target)
  if(SOARBOX_SANITIZE STREQUAL "fuzzer")
    # The equivalent of -fsanitize=fuzzer-no-link, which would not permit precompiled headers.
    target_compile_options(${target} PRIVATE -fsanitize-coverage=inline-8bit-counters,pc-table,trace-cmp,indirect-calls)
  endif()
endfunction()

# soarbox_library(NAME [LARGE_BATCHES] [SELDOM_RUN | EACH_PICTURE] SOURCES file... [DEPENDS target...] [PRIVATE_DEPENDS target...])
# A static library soarbox_NAME (alias soarbox::NAME) of these sources. Releases compile libraries with EACH_PICTURE (executed for each picture, or
# to read many files) with -O1, which takes a quarter less time than -O3. They compile libraries with SELDOM_RUN (executed at the speed of a user)
# with -Og, which takes another fifth less. WebAssembly is loaded from a network: there they are compiled for size.
function(soarbox_library name)
  cmake_parse_arguments(arg "LARGE_BATCHES;SELDOM_RUN;EACH_PICTURE" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(soarbox_${name} STATIC ${arg_SOURCES})
  add_library(soarbox::${name} ALIAS soarbox_${name})
  target_link_libraries(soarbox_${name} PUBLIC soarbox_options ${arg_DEPENDS} PRIVATE ${arg_PRIVATE_DEPENDS})
  if(arg_LARGE_BATCHES)
    soarbox_in_large_batches(soarbox_${name})
  else()
    soarbox_in_batches(soarbox_${name})
  endif()
  if(arg_SELDOM_RUN OR arg_EACH_PICTURE)
    set_target_properties(soarbox_${name} PROPERTIES SOARBOX_HUGE_BATCHES ON)
  endif()
  if(arg_SELDOM_RUN AND EMSCRIPTEN)
    target_compile_options(soarbox_${name} PRIVATE -Os)
  elseif(arg_SELDOM_RUN)
    target_compile_options(soarbox_${name} PRIVATE $<$<CONFIG:Release>:-Og>)
  elseif(arg_EACH_PICTURE)
    target_compile_options(soarbox_${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  endif()
  # Assertions are left out where instructions are counted; sanitizers check them.
  if(SOARBOX_CI AND NOT soarbox_${name} MATCHES "${soarbox_counted}")
    target_compile_options(soarbox_${name} PRIVATE -UNDEBUG)
  endif()
endfunction()

# soarbox_paths_for(TARGET FILES regex definition...): defines paths of this machine for those files of a target whose text matches. All other files
# have the same command line in every checkout, so that a compiler cache recognises them. In batches, which are not cached, all files have the
# definitions, because CMake would take files with their own definitions out of batches.
function(soarbox_paths_for target files pattern)
  foreach(file ${files})
    file(STRINGS "${file}" uses REGEX "${pattern}" LIMIT_COUNT 1)
    if(uses AND SOARBOX_UNITY)
      target_compile_definitions(${target} PRIVATE ${ARGN})
      return()
    elseif(uses)
      set_property(SOURCE "${file}" APPEND PROPERTY COMPILE_DEFINITIONS ${ARGN})
    endif()
  endforeach()
endfunction()

# soarbox_test(NAME SOURCES file... [DEPENDS target...] [LABELS label...] [STAGES stage...])
# A GoogleTest program whose cases become tests of CTest. With SOARBOX_WHOLE_TESTS it is one test, for continuous integration, which saves a
# thousand processes. STAGES lists the stages of continuous integration that build and run it (tests/CMakeLists.txt): release, sanitized, threads;
# the default is sanitized.
function(soarbox_test name)
  cmake_parse_arguments(arg "" "" "SOURCES;DEPENDS;LABELS;STAGES" ${ARGN})
  if(NOT SOARBOX_TESTS)
    return()
  endif()
  # The stages and the name become labels, so that each stage runs the programs that it builds.
  if(NOT arg_STAGES)
    set(arg_STAGES sanitized)
  endif()
  list(TRANSFORM arg_STAGES PREPEND stage_ OUTPUT_VARIABLE stages)
  if(SOARBOX_CI AND NOT "stage_release" IN_LIST stages)
    return()
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_link_libraries(${name} PRIVATE soarbox_options ${arg_DEPENDS} GTest::gtest GTest::gmock GTest::gtest_main)
  soarbox_paths_for(${name} "${arg_SOURCES}" "SOARBOX_SOURCE_DIR|_fixture\\.h|_test_support\\.h" SOARBOX_SOURCE_DIR="${PROJECT_SOURCE_DIR}")
  soarbox_in_large_batches(${name})
  if(SOARBOX_PRECOMPILE)
    target_precompile_headers(${name} REUSE_FROM soarbox_test_headers)
  endif()
  target_compile_options(${name} PRIVATE $<$<CONFIG:Release>:-O1>)
  # Virtual displays that start at the same time may choose the same number.
  set(lock "")
  if("display" IN_LIST arg_LABELS)
    set(lock RESOURCE_LOCK display)
  endif()
  foreach(stage ${stages})
    set_property(GLOBAL APPEND PROPERTY soarbox_${stage} ${name})
  endforeach()
  # One label that contains all: CMake passes on only the first item of a list.
  set(labels "${name}" ${stages} ${arg_LABELS})
  list(JOIN labels "+" labels)
  if(SOARBOX_WHOLE_TESTS)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES LABELS "${labels}" TIMEOUT 900 COST 50 ${lock})
    return()
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES LABELS "${labels}" TIMEOUT 300 ${lock})
endfunction()
