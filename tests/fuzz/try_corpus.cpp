// SPDX-License-Identifier: BSD-2-Clause
// Passes every file of a folder and its subfolders once to a fuzzer's entry function: a regression test without
// libFuzzer.
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>

#define FUZZER(name) extern "C" int Try_##name(const std::uint8_t* data, std::size_t size);
#include "fuzzers.inc"
#undef FUZZER

int main(int argc, char** argv) {
  using Try = int (*)(const std::uint8_t*, std::size_t);
#define FUZZER(name) {#name, Try_##name},
  const std::map<std::string, Try> fuzzers{
#include "fuzzers.inc"
  };
#undef FUZZER
  const auto fuzzer = argc == 3 ? fuzzers.find(argv[1]) : fuzzers.end();
  if (fuzzer == fuzzers.end()) {
    std::cerr << "usage: " << argv[0] << " FUZZER FOLDER\n";
    return 2;
  }
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(argv[2])) {
    if (!entry.is_regular_file()) continue;
    std::ifstream file(entry.path(), std::ios::binary);
    const std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    fuzzer->second(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    ++count;
  }
  std::cout << count << " inputs tried\n";
  return count > 0 ? 0 : 1;
}
