// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "cli/command.h"
#include "cli/interpreter.h"

namespace soarbox::cli {

bool CommandPwd(CommandCall& call) {
  if (call.words.size() > 1) return call.Fail("Syntax: pwd");
  const std::string directory = call.interpreter.directory().string();
  call.Out(directory);
  call.AddArgument("directory", "string", directory);
  return true;
}

bool CommandCd(CommandCall& call) {
  if (call.words.size() > 2)
    return call.Fail("Only one argument (a directory) is allowed. Paths with spaces should be enclosed in quotes.");
  std::string target;
  if (call.words.size() == 2) {
    target = call.words[1].text;
  } else if (const char* home = std::getenv("HOME")) {
    target = home;
  }
  if (target.empty() || !call.interpreter.ChangeDirectory(target)) return call.Fail("Error changing to " + target);
  return true;
}

bool CommandPushd(CommandCall& call) {
  if (call.words.size() < 2) return call.Fail("Syntax: pushd directory");
  if (call.words.size() > 2) {
    return call.Fail("Expected on argument (directory). Enclose directory in quotes if there are spaces in the path.");
  }
  const std::filesystem::path before = call.interpreter.directory();
  if (!call.interpreter.ChangeDirectory(call.words[1].text)) {
    return call.Fail("Error changing to " + call.words[1].text);
  }
  call.interpreter.directory_stack().push_back(before);
  return true;
}

bool CommandPopd(CommandCall& call) {
  if (call.words.size() > 1) return call.Fail("Syntax: popd");
  std::vector<std::filesystem::path>& stack = call.interpreter.directory_stack();
  if (stack.empty()) return call.Fail("Directory stack is empty.");
  const std::string target = stack.back().string();
  stack.pop_back();
  if (!call.interpreter.ChangeDirectory(target)) return call.Fail("Error changing to " + target);
  return true;
}

bool CommandDirs(CommandCall& call) {
  std::string text = call.interpreter.directory().string();
  const std::vector<std::filesystem::path>& stack = call.interpreter.directory_stack();
  for (auto entry = stack.rbegin(); entry != stack.rend(); ++entry) text += " " + entry->string();
  call.Out(text);
  return true;
}

bool CommandLs(CommandCall& call) {
  if (call.words.size() > 1) return call.Fail("Syntax: ls");
  std::string text = "\n[.]\n[..]";
  std::error_code error;
  std::vector<std::string> names;
  for (std::filesystem::directory_iterator entry(call.interpreter.directory(), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    names.push_back(entry->is_directory(ignored) ? "[" + name + "]" : name);
  }
  if (error) return call.Fail("Cannot list " + call.interpreter.directory().string() + ": " + error.message());
  std::sort(names.begin(), names.end());
  for (const std::string& name : names) text += "\n" + name;
  call.Out(text);
  return true;
}

}  // namespace soarbox::cli
