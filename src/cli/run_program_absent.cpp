// SPDX-License-Identifier: BSD-2-Clause
// For systems that cannot start other programs (WebAssembly): none is installed.
#include "cli/run_program.h"

namespace soarbox::cli {

bool IsInstalled(std::string_view) {
  return false;
}
bool RunProgram(const std::vector<std::string>&) {
  return false;
}
bool StartProgram(const std::vector<std::string>&) {
  return false;
}
bool HasDisplay() {
  return false;
}

}  // namespace soarbox::cli
