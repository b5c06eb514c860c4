// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kernel/imagery/imagery_scene.h"

namespace soarbox::kernel::imagery {

/// Why a line was refused.
struct LineError {
  std::string line;
  int field = 0;     ///< Index of the wrong word; the keyword has index 0.
  std::string text;  ///< A description of the error and a hint.

  /// For example: "add x tower b 1", word 3: there is no node tower: add it first
  std::string ToString() const;
};

/// Executes one line of the scene graph edit language: add, change, delete or tag. Blank lines do nothing. A refused
/// line changes nothing, except that the parts of a `change` before the error take effect.
std::optional<LineError> ApplyLine(Scene& scene, std::string_view line);

/// The answers to queries, one per line: obj-info ID, list-all-objs, objs-with-flag NAME VALUE.
std::string AnswerQueries(const Scene& scene, std::string_view queries);

/// A number with 6 significant digits, the format of all texts about scenes.
std::string NumberText(double value);

}  // namespace soarbox::kernel::imagery
