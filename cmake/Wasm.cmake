# SPDX-License-Identifier: BSD-2-Clause
# Compiles to WebAssembly (docs/dev/wasm.md; `./dev wasm` calls it): cmake --preset wasm -DSOARBOX_EMSCRIPTEN=FOLDER
# -DSOARBOX_WASM_SOURCES=FOLDER. The first folder contains em++, the second the sources of libraries (cmake/wasm/get).
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SOARBOX_EMSCRIPTEN)
if(NOT EXISTS "${SOARBOX_EMSCRIPTEN}/cmake/Modules/Platform/Emscripten.cmake")
  message(FATAL_ERROR "SOARBOX_EMSCRIPTEN is '${SOARBOX_EMSCRIPTEN}', which is not a folder of emscripten's; call ./dev wasm")
endif()
include("${SOARBOX_EMSCRIPTEN}/cmake/Modules/Platform/Emscripten.cmake")

# Uses WebAssembly's own exceptions; JavaScript's are slower.
set(CMAKE_C_FLAGS_INIT "-fwasm-exceptions")
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions")
# Memory grows as needed, up to 4 GB. The stack is as large as in native builds, because minds and scripts need it. Optimising in the linker takes
# two minutes for each program and makes none faster, only smaller (SOARBOX_SMALL_ENGINE).
set(CMAKE_EXE_LINKER_FLAGS_INIT
  "-O1 -fwasm-exceptions -sALLOW_MEMORY_GROWTH -sMAXIMUM_MEMORY=4GB -sSTACK_SIZE=8MB -sINITIAL_MEMORY=64MB -Wno-limited-postlink-optimizations")
