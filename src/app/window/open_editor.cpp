// SPDX-License-Identifier: BSD-2-Clause
#include "app/window/open_editor.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <thread>

#include "diagnostics/problem.h"

extern char** environ;

namespace soarbox::app {
namespace {

std::string FirstSet(std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const char* value = std::getenv(name); value != nullptr && *value != '\0') return value;
  }
  return {};
}

/// Editors that need a terminal get a new one, because the window has none.
bool NeedsTerminal(const std::string& editor) {
  for (const char* name : {"vi", "vim", "nvim", "nano", "emacs -nw", "micro", "hx", "joe", "ed"}) {
    if (editor == name) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> EditorCommand(const std::string& file, int line) {
  const std::string editor = FirstSet({"VISUAL", "EDITOR"});
  if (editor.empty()) return {"xdg-open", file};
  std::vector<std::string> command;
  std::istringstream words(editor);
  for (std::string word; words >> word;) command.push_back(word);
  if (command.empty()) return {"xdg-open", file};
  const std::string name = std::filesystem::path(command.front()).filename().string();
  if (NeedsTerminal(name)) command.insert(command.begin(), {"x-terminal-emulator", "-e"});
  if (name == "code" || name == "codium") {
    command.push_back("--goto");
    command.push_back(line > 0 ? file + ":" + std::to_string(line) : file);
    return command;
  }
  if (name == "subl" || name == "hx" || name == "zed") {
    command.push_back(line > 0 ? file + ":" + std::to_string(line) : file);
    return command;
  }
  if (line > 0 && name != "gnome-text-editor") command.push_back("+" + std::to_string(line));
  command.push_back(file);
  return command;
}

Result<void> OpenInEditor(const std::string& file, int line) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return ProblemIn(file, "there is no such file to open");
  const std::vector<std::string> command = EditorCommand(std::filesystem::absolute(file, error).string(), line);
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  pid_t child = 0;
  if (const int failed = posix_spawnp(&child, arguments[0], nullptr, nullptr, arguments.data(), environ); failed != 0) {
    return ProblemIn(file, "the editor '" + command.front() + "' cannot be started: " + std::strerror(failed),
                     "set the environment variable VISUAL to your editor");
  }
  // Waits for the child process, so that it does not stay a zombie.
  std::thread([child] { waitpid(child, nullptr, 0); }).detach();
  return {};
}

}  // namespace soarbox::app
