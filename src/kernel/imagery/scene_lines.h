// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "kernel/imagery/scene.h"

namespace soarbox::kernel::imagery {

/// Why a line was refused.
struct LineError {
  std::string line;
  int field = 0;     ///< The number of the word, the keyword being 0.
  std::string text;  ///< What is wrong and what to do.

  /// In one sentence: "add x nobody b 1: parent: ..."
  std::string ToString() const;
};

/// Carries out one line of the scene graph edit language: add, change, delete or tag. Blank lines do nothing. A refused
/// line changes nothing, except a `change` with correct parts before the error.
std::optional<LineError> ApplyLine(Scene& scene, std::string_view line);

/// The answers to queries, one per line: obj-info ID, list-all-objs, objs-with-flag NAME VALUE.
std::string AnswerQueries(const Scene& scene, std::string_view queries);

/// A number with 6 significant digits, as all texts of scenes show it.
std::string NumberText(double value);

}  // namespace soarbox::kernel::imagery
