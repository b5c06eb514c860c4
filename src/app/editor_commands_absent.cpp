// SPDX-License-Identifier: BSD-2-Clause
#include "app/editor_commands.h"
#include "app/refuse.h"

namespace soarbox::app {
namespace {

int RefuseEditors() {
  return Refuse("this build reads rules with an official Soar and serves no editors",
                "build without SOARBOX_SOAR_ROOT");
}

}  // namespace

int FormatFiles(const FormatOptions&) {
  return RefuseEditors();
}
int WriteDatamap(const DatamapOptions&) {
  return RefuseEditors();
}
std::vector<Diagnostic> DatamapProblems(const std::filesystem::path&) {
  return {};
}
int ServeLanguage() {
  return RefuseEditors();
}

int ServeDebugger() {
  return RefuseEditors();
}
int ServeAssistant(const std::filesystem::path&) {
  return RefuseEditors();
}

}  // namespace soarbox::app
