// SPDX-License-Identifier: BSD-2-Clause
//
// Writes the reference of Soar's commands for docs/.
//
//   command_reference                  prints it
//   command_reference --check FILE     fails if the file differs from it

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "cli/help.h"

int main(int argc, char** argv) {
  const std::string reference = soarbox::cli::CommandReference();
  if (argc == 1) {
    std::fwrite(reference.data(), 1, reference.size(), stdout);
    return 0;
  }
  if (argc != 3 || std::string_view(argv[1]) != "--check") {
    std::fputs("usage: command_reference [--check FILE]\n", stderr);
    return 2;
  }
  std::ifstream in(argv[2], std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (in && text.str() == reference) return 0;
  std::fprintf(stderr, "%s is out of date; write it again with: command_reference > %s\n", argv[2], argv[2]);
  return 1;
}
