// SPDX-License-Identifier: BSD-2-Clause
//
// Writes the reference of contents and requests, docs/workbench.md.
//
//   workbench_docs                 prints it
//   workbench_docs --check FILE    fails if the file differs from it

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "workbench/contents_json.h"

int main(int argc, char** argv) {
  if (argc != 1 && (argc != 3 || std::string_view(argv[1]) != "--check")) {
    std::fputs("usage: workbench_docs [--check FILE]\n", stderr);
    return 2;
  }
  const std::string reference = soarbox::workbench::WorkbenchReference();
  if (argc == 1) {
    std::fwrite(reference.data(), 1, reference.size(), stdout);
    return 0;
  }
  std::ifstream in(argv[2], std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (in && text.str() == reference) return 0;
  std::fprintf(stderr, "%s is out of date; write it again with: workbench_docs > %s\n", argv[2], argv[2]);
  return 1;
}
