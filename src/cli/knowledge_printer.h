// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "kernel/longterm/knowledge.h"

namespace soarbox::kernel {
class Agent;
class SemanticMemory;
}  // namespace soarbox::kernel

namespace soarbox::cli {

/// An object as `print @12` shows it: (@12 ^name tank ^has @13 @14 [+0.000]), with its line end. Attributes by name,
/// the values of one in the order in which they were made, links behind constants by number. `activation`: what to show
/// in the brackets in place of the object's own.
std::string ObjectLine(const kernel::SemanticMemory& memory, std::uint32_t object,
                       std::optional<double> activation = {});

/// The object and what it links to, down to `depth` levels, each object once and indented by its level.
std::string ObjectTree(const kernel::SemanticMemory& memory, std::uint32_t object, int depth);

/// All objects by number, a line each.
std::string AllObjects(const kernel::SemanticMemory& memory);

/// What `smem --export` writes: a command that adds all objects, or one and all that it leads to.
std::string ExportText(const kernel::SemanticMemory& memory, std::optional<std::uint32_t> root);

/// Objects in the language of Graphviz: all, or one and what it leads to in at most `depth` links.
std::string KnowledgeGraph(const kernel::SemanticMemory& memory, std::optional<std::uint32_t> root, int depth);

/// `print @`, `print @12 --depth 2`, `print @steel`.
std::string PrintedKnowledge(kernel::Agent& agent, const std::string& word, int depth);

}  // namespace soarbox::cli
