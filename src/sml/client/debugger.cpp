// SPDX-License-Identifier: BSD-2-Clause
#include <dlfcn.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "sml/client/agent_data.h"

extern char** environ;

std::string get_soarlib_path() {
  Dl_info info{};
  if (dladdr(reinterpret_cast<void*>(&get_soarlib_path), &info) == 0 || !info.dli_fname) return {};
  return std::filesystem::path(info.dli_fname).parent_path().string();
}

namespace sml {

namespace {

constexpr char const* kJar = "SoarJavaDebugger.jar";

/// The path of the debugger; empty if it is not found.
std::string FindJar(char const* jarpath) {
  std::error_code ignored;
  if (jarpath && *jarpath) {
    const std::filesystem::path given(jarpath);
    for (const std::filesystem::path& path : {given, given / kJar}) {
      if (std::filesystem::is_regular_file(path, ignored)) return path.string();
    }
  }
  std::vector<std::filesystem::path> folders{"."};
  if (char const* home = std::getenv("SOAR_HOME")) folders.emplace_back(home);
  folders.emplace_back(get_soarlib_path());
  for (const std::filesystem::path& folder : folders) {
    if (std::filesystem::is_regular_file(folder / kJar, ignored)) return (folder / kJar).string();
  }
  return {};
}

}  // namespace

bool Agent::SpawnDebugger(int port, char const* jarpath) {
  if (data_->debugger_process > 0) {
    SetDetailedError(kDetailedError, "A debugger of this agent is running already");
    return false;
  }
  if (!data_->Usable()) return false;
  const std::string jar = FindJar(jarpath);
  if (jar.empty()) {
    SetDetailedError(kDetailedError,
                     "SoarJavaDebugger.jar was not found: not in the path given, the working folder, $SOAR_HOME or the "
                     "library's folder");
    return false;
  }
  if (port < 0) port = data_->kernel.GetListenerPort();
  if (port <= 0) {
    SetDetailedError(kDetailedError, "The kernel listens on no port that a debugger could connect to");
    return false;
  }
  std::string port_text = std::to_string(port);
  std::vector<std::string> words{"java", "-jar", jar, "-remote", "-port", port_text, "-agent", data_->name};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_t process = 0;
  const int failure = posix_spawnp(&process, "java", nullptr, nullptr, arguments.data(), environ);
  if (failure != 0) {
    SetDetailedError(kDetailedError, ("java could not be started: " + std::string(std::strerror(failure))).c_str());
    return false;
  }
  data_->debugger_process = process;
  ClearError();
  return true;
}

bool Agent::KillDebugger(bool ignoreNonExistent) {
  if (data_->debugger_process <= 0) {
    if (!ignoreNonExistent) SetDetailedError(kDetailedError, "No debugger of this agent is running");
    return ignoreNonExistent;
  }
  const pid_t process = data_->debugger_process;
  data_->debugger_process = 0;
  const bool killed = kill(process, SIGTERM) == 0;
  waitpid(process, nullptr, 0);
  return killed || ignoreNonExistent;
}

}  // namespace sml
