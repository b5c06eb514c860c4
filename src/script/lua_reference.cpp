// SPDX-License-Identifier: BSD-2-Clause
//
// Writes the reference of the Lua API for docs/lua/.
//
//   lua_reference FOLDER           writes its pages into the folder
//   lua_reference --check FOLDER   fails if the folder's pages differ

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "script/api_reference.h"

namespace {

std::string Read(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

}  // namespace

int main(int argc, char** argv) {
  const bool checks = argc == 3 && std::string_view(argv[1]) == "--check";
  if (argc != 2 && !checks) {
    std::fputs("usage: lua_reference [--check] FOLDER\n", stderr);
    return 2;
  }
  const std::filesystem::path folder = argv[argc - 1];
  int status = 0;
  for (const soarbox::script::ReferencePage& page : soarbox::script::ApiReference()) {
    const std::filesystem::path file = folder / page.file;
    if (checks) {
      if (Read(file) == page.text) continue;
      std::fprintf(stderr, "%s is out of date; write it again with: lua_reference %s\n", file.c_str(), folder.c_str());
      status = 1;
      continue;
    }
    std::ofstream out(file, std::ios::binary);
    out << page.text;
    if (!out.flush()) {
      std::fprintf(stderr, "cannot write %s\n", file.c_str());
      status = 1;
    }
  }
  return status;
}
