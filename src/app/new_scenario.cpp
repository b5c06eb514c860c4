// SPDX-License-Identifier: BSD-2-Clause
#include "app/new_scenario.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <system_error>

#include "app/exit_codes.h"
#include "app/refuse.h"
#include "app/starter_files.h"
#include "diagnostics/diagnostic.h"

namespace soarbox::app {
namespace {

namespace fs = std::filesystem;

bool IsGoodName(const std::string& name) {
  return !name.empty() && name.size() <= 60 && std::isalpha(static_cast<unsigned char>(name[0])) != 0 &&
         std::all_of(name.begin(), name.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

/// The text with the scenario's name instead of NAME.
std::string WithName(std::string_view text, const std::string& name) {
  std::string filled(text);
  for (std::size_t at = 0; (at = filled.find("NAME", at)) != std::string::npos; at += name.size())
    filled.replace(at, 4, name);
  return filled;
}

/// Prints the next commands; `dev` says how the program was called. A starter with checks is tested by `soarbox test`,
/// all others by their script.
void TellNextSteps(const fs::path& folder, bool has_checks) {
  const char* called = std::getenv("SOARBOX_CALLED_AS");
  const std::string command = called != nullptr && *called != '\0' ? called : "soarbox";
  std::string tester = "sh " + (folder / "test.sh").string();
  if (has_checks) {
    tester = command + " test " + folder.string();
  } else if (command != "soarbox") {
    std::error_code error;
    tester = "SOARBOX=" + fs::read_symlink("/proc/self/exe", error).string() + " " + tester;
  }
  std::cout << "\nrun it:   " << command << " run " << folder.string() << "\ncheck it: " << command << " check "
            << folder.string() << "\ntest it:  " << tester << '\n';
}

}  // namespace

int NewScenario(const NewOptions& options) {
  const fs::path folder(options.name);
  const std::string name = folder.filename().string();
  if (!IsGoodName(name))
    return Refuse("'" + name + "' is not a name for a scenario",
                  "use letters, digits, - and _, and begin with a letter");
  std::error_code error;
  if (fs::exists(folder, error)) return Refuse("this is there already", "choose another name", folder.string());
  fs::create_directories(folder, error);
  if (error) return Refuse("this folder cannot be made: " + error.message(), "check the path", folder.string());

  std::vector<StarterFile> files;
  if (options.lua) {
    files = LuaStarter();
  } else if (options.team) {
    files = TeamStarter();
  } else {
    files = SoarStarter();
  }
  for (const StarterFile& file : files) {
    const fs::path path = folder / WithName(file.name, name);
    std::ofstream out(path, std::ios::binary);
    out << WithName(file.text, name);
    if (!out) return Refuse("this file cannot be written", "check that the folder may be written to", path.string());
    std::cout << path.string() << ": " << file.meaning << '\n';
  }
  TellNextSteps(folder, std::ranges::any_of(files, [](const StarterFile& file) {
                  return file.text.find("[[check]]") != std::string::npos;
                }));
  return kOk;
}

}  // namespace soarbox::app
