// SPDX-License-Identifier: BSD-2-Clause
#include <iostream>

#include "app/exit_codes.h"
#include "app/soar_shell.h"

namespace soarbox::app {

int RunSoarShell(const SoarShellOptions&) {
  std::cerr << "soarbox: error: this build uses an official Soar, which brings its own shell\n";
  return kCannotStart;
}

}  // namespace soarbox::app
