// SPDX-License-Identifier: BSD-2-Clause
// For systems without libedit (WebAssembly): reads lines without history and completion.
#include <iostream>

#include "app/line_editor.h"

namespace soarbox::app {

struct LineEditor::Impl {};

LineEditor::LineEditor(Completer) {}
LineEditor::~LineEditor() = default;

std::optional<std::string> LineEditor::Read(std::string_view prompt) {
  std::cout << prompt << std::flush;
  std::string line;
  if (!std::getline(std::cin, line)) return std::nullopt;
  return line;
}

void LineEditor::Remember(const std::string&) {}

}  // namespace soarbox::app
