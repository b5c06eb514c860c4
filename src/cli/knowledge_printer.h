// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "kernel/longterm/knowledge.h"
#include "kernel/rules/soar_version.h"

namespace soarbox::kernel {
class Agent;
class SemanticMemory;
}  // namespace soarbox::kernel

namespace soarbox::cli {

/// An object as `print @12` shows it: (@12 ^name tank ^has @13 @14 [+0.000]), with its line end. Attributes are sorted
/// by name. Of the values of one attribute, links come first, by number; constants follow in order of their first use.
/// `activation`: the number in the brackets; nothing: that of the object. `like`: for Soar 9.6.5, an object with an
/// alias is shown by it: @steel.
std::string ObjectLine(const kernel::SemanticMemory& memory, std::uint32_t object, kernel::SoarVersion like,
                       std::optional<double> activation = {});

/// The object and the objects that it links to, down to `depth` levels. Each object is printed once, indented by its
/// level.
std::string ObjectTree(const kernel::SemanticMemory& memory, std::uint32_t object, int depth, kernel::SoarVersion like);

/// All objects by number, one per line.
std::string AllObjects(const kernel::SemanticMemory& memory, kernel::SoarVersion like);

/// The output of `smem --export`: a command that adds all objects, or one object and all objects reachable from it.
std::string ExportText(const kernel::SemanticMemory& memory, std::optional<std::uint32_t> root,
                       kernel::SoarVersion like);

/// Objects in the language of Graphviz: all, or one and those reachable from it by at most `depth` links.
std::string KnowledgeGraph(const kernel::SemanticMemory& memory, std::optional<std::uint32_t> root, int depth,
                           kernel::SoarVersion like);

/// The output of `print @` (all objects), `print @12 --depth 2` and `print @steel`, or that there is no such object.
std::string PrintedKnowledge(kernel::Agent& agent, const std::string& word, int depth);

}  // namespace soarbox::cli
