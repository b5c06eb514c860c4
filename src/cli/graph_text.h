// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>

#include "kernel/agent.h"

namespace soarbox::cli {

/// How a drawing of working memory looks (`visualize`).
struct GraphStyle {
  bool records = true;          ///< An object is a table of its values; otherwise each value is a node.
  bool separate_states = true;  ///< Links between states are left out.
  bool architecture = false;    ///< Elements that the architecture made are shown (superstate, type, impasse, ...).
  std::string line_style = "polyline";
};

/// The objects that can be reached from `roots` in at most `depth` links, in the language of Graphviz.
std::string WorkingMemoryGraph(const kernel::Agent& agent, std::span<const kernel::Symbol> roots, int depth,
                               const GraphStyle& style);

/// A text between quotes, as Graphviz reads it.
std::string GraphQuoted(std::string_view text);
/// A text within a record's label, with special characters escaped. Goes between quotes as it is.
std::string GraphRecordText(std::string_view text);

}  // namespace soarbox::cli
