// SPDX-License-Identifier: BSD-2-Clause
#pragma once

// Debian's luaconf.h names a folder of modules by the machine. Scripts load none.
#define DEB_HOST_MULTIARCH "wasm32-emscripten"
