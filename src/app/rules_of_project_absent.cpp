// SPDX-License-Identifier: BSD-2-Clause
#include "app/rules_of_project.h"

namespace soarbox::app {

Result<std::filesystem::path> RulesOfProject(const std::filesystem::path& file) {
  return file;
}

}  // namespace soarbox::app
