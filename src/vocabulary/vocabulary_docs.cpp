// SPDX-License-Identifier: BSD-2-Clause
//
// Writes the reference of percepts and commands for docs/.
//
//   vocabulary_docs percepts|commands                  prints it
//   vocabulary_docs percepts|commands --check FILE     fails if the file differs from it

#include <cstdio>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "vocabulary/vocabulary.h"

int main(int argc, char** argv) {
  const std::string_view which = argc > 1 ? argv[1] : "";
  if ((argc != 2 && argc != 4) || (which != "percepts" && which != "commands")) {
    std::fputs("usage: vocabulary_docs percepts|commands [--check FILE]\n", stderr);
    return 2;
  }
  const std::string reference =
      which == "percepts" ? soarbox::vocabulary::PerceptReference() : soarbox::vocabulary::CommandReference();
  if (argc == 2) {
    std::fwrite(reference.data(), 1, reference.size(), stdout);
    return 0;
  }
  std::ifstream in(argv[3], std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (in && text.str() == reference) return 0;
  std::fprintf(stderr, "%s is out of date; write it again with: vocabulary_docs %s > %s\n", argv[3], argv[1], argv[3]);
  return 1;
}
