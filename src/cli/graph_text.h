// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <string>

#include "kernel/agent.h"

namespace soarbox::cli {

/// The format of a graph of working memory (`visualize`).
struct GraphStyle {
  bool records = true;          ///< An object is a table of its values; otherwise each value is a node.
  bool separate_states = true;  ///< Links to states are omitted.
  bool architecture = false;    ///< Elements of the architecture are shown (superstate, type, impasse, ...).
  std::string line_style = "polyline";
};

/// The objects that can be reached from `roots` in at most `depth` links, in the language of Graphviz.
std::string WorkingMemoryGraph(const kernel::Agent& agent, std::span<const kernel::Symbol> roots, int depth,
                               const GraphStyle& style);

/// Quotes a text for Graphviz.
std::string GraphQuoted(std::string_view text);
/// Escapes special characters of a text in a record's label, which is in quotes.
std::string GraphRecordText(std::string_view text);

}  // namespace soarbox::cli
