// SPDX-License-Identifier: BSD-2-Clause
#include "app/editor_commands.h"
#include "app/refuse.h"

namespace soarbox::app {
namespace {

int RefuseEditors() {
  Diagnostic problem;
  problem.message = "this build reads rules with an official Soar and serves no editors";
  problem.hint = "build without SOARBOX_SOAR_ROOT";
  return Refuse(problem);
}

}  // namespace

int FormatFiles(const FormatOptions&) {
  return RefuseEditors();
}
int WriteDatamap(const DatamapOptions&) {
  return RefuseEditors();
}
int ServeLanguage() {
  return RefuseEditors();
}

}  // namespace soarbox::app
