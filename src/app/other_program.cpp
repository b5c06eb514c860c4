// SPDX-License-Identifier: BSD-2-Clause
#include "app/other_program.h"

#include <unistd.h>

#include <filesystem>
#include <system_error>

namespace soarbox::app {

void GoOnAs(const char* name, char** argv) {
  std::error_code error;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", error);
  if (!error) execv((self.parent_path() / name).c_str(), argv);
}

}  // namespace soarbox::app
