// SPDX-License-Identifier: BSD-2-Clause
#include "app/command_line.h"

int main(int argc, char** argv) {
  return soarbox::app::CommandLine(argc, argv, nullptr, nullptr);
}
