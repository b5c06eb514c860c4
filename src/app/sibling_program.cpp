// SPDX-License-Identifier: BSD-2-Clause
#include "app/sibling_program.h"

#include <unistd.h>

namespace soarbox::app {

std::filesystem::path BesideThisProgram(const char* name, std::error_code& error) {
  return std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / name;
}

void GoOnAs(const char* name, char** argv) {
  std::error_code error;
  const std::filesystem::path program = BesideThisProgram(name, error);
  if (!error) execv(program.c_str(), argv);
}

}  // namespace soarbox::app
