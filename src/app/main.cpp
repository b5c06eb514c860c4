// SPDX-License-Identifier: BSD-2-Clause
#include "app/command_line.h"
#include "app/windowless_commands.h"

int main(int argc, char** argv) {
  return soarbox::app::CommandLine(argc, argv, {nullptr, nullptr, &soarbox::app::ExecuteWindowless});
}
