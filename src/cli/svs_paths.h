// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "kernel/imagery/imagery.h"

namespace soarbox::cli {

/// All commands of the spatial visual system, then all filters, with their parameters, one per line: `command NAME:
/// MEANING` or `filter NAME: MEANING`, then `  ^PARAMETER FORM: MEANING`. An optional parameter is in brackets,
/// [^PARAMETER]. The form is nodes, number, object, word, or the allowed words with | between them.
std::string AllSceneKinds();

/// `svs PATH [ARGUMENTS]`: shows or executes what is at a path of the spatial visual system. Paths have dots. They name
/// the lists of filters and commands, the viewer's connection, and the scene of each state with its nodes.
class SvsPaths {
 public:
  explicit SvsPaths(kernel::Imagery& imagery) : imagery_(imagery) {}

  /// Returns the output, with a newline after each line.
  std::string Use(std::string_view path, std::span<const std::string> arguments);
  /// Whether the path was refused or failed; the output then says why.
  bool failed() const { return failed_; }

 private:
  using Arguments = std::span<const std::string>;

  std::string Fail(std::string text);
  std::string UseRoot(Arguments arguments);
  std::string UseState(kernel::imagery::StateScene& state, std::string_view rest, Arguments arguments);
  std::string UseScene(kernel::imagery::StateScene& state, std::string_view rest, Arguments arguments);
  std::string UseNode(const kernel::imagery::Node& node, Arguments arguments);
  std::string Connect(Arguments arguments);

  kernel::Imagery& imagery_;
  bool failed_ = false;
};

}  // namespace soarbox::cli
