// SPDX-License-Identifier: BSD-2-Clause
#include "sml/client/library.h"

#include <dlfcn.h>

#include <sstream>
#include <vector>

namespace sml {

namespace {

using InitFunction = char* (*)(Kernel*, int, char**);

/// The possible file names of a library.
std::vector<std::string> Candidates(const std::string& name) {
  return {name, "lib" + name + ".so", "./lib" + name + ".so", name + ".so"};
}

}  // namespace

std::string LoadSmlLibrary(Kernel& kernel, const std::string& command) {
  std::istringstream stream(command);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  if (words.empty()) return "Library name missing.";
  void* library = nullptr;
  for (const std::string& name : Candidates(words[0])) {
    library = dlopen(name.c_str(), RTLD_NOW);
    if (library) break;
  }
  if (!library) {
    const char* why = dlerror();
    return "Library not found." + (why ? " " + std::string(why) : std::string());
  }
  const auto init = reinterpret_cast<InitFunction>(dlsym(library, "sml_InitLibrary"));
  if (!init) {
    dlclose(library);
    return "The library " + words[0] + " does not export sml_InitLibrary.";
  }
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  const char* answer = init(&kernel, static_cast<int>(arguments.size()), arguments.data());
  return answer ? answer : "";
}

}  // namespace sml
