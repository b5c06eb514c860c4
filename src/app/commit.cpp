// SPDX-License-Identifier: BSD-2-Clause
#include "app/commit.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "diagnostics/read_text.h"
#include "record/header.h"

namespace soarbox::app {

std::string Commit() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return {};
  std::string text = ReadText(program.parent_path().parent_path() / "share" / "soarbox" / "commit").value_or("");
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
  return text;
}

std::string Version() {
  const std::string build = record::BuildId();
  return build.substr(0, build.find(' '));
}

std::string VersionText() {
  const std::string build = record::BuildId(), commit = Commit();
  std::string text = Version();
  if (!commit.empty()) text += "\ncommit " + commit;
  if (const std::size_t space = build.find(' '); space != std::string::npos && space + 1 < build.size())
    text += "\nbuild " + build.substr(space + 1);
  return text;
}

}  // namespace soarbox::app
