// SPDX-License-Identifier: BSD-2-Clause
// WebAssembly has no linker's note. The id is the first 160 bits of the module's SHA-256, if the JavaScript code
// provides them (cmake/wasm/node.js).
#include <emscripten.h>

#include <cstdlib>

#include "record/linkers_id.h"

// clang-format off
EM_JS(char*, soarbox_module_id, (), {
  return stringToNewUTF8(Module["soarboxModuleId"] ? Module["soarboxModuleId"]() : "");
});
// clang-format on

namespace soarbox::record {

std::string LinkersId() {
  char* const text = soarbox_module_id();
  std::string id = text;
  std::free(text);
  return id;
}

}  // namespace soarbox::record
