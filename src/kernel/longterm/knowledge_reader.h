// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/longterm/semantic_query.h"

namespace soarbox::kernel {

class SemanticMemory;

/// The texts of `smem --add`, `--query` and `--remove`, without the outer braces:
///   (@12 ^name tank ^has @13 <part> ^core.fuel diesel) (<part> ^name hatch) (@steel ^hardness 6)
/// An object is a number (@12), an alias (@steel), or a variable. An alias is valid in the entire memory; a variable
/// represents a new object within one text. Several values may follow an attribute. A path creates an object for each
/// of its dots. A number in parentheses after a link is its weight (link_weights.h).

/// Adds the knowledge in the text, up to the first incorrect clause. Returns Soar's message about it, or an empty text.
/// Sets `notes` to the mistakes that have no effect, one per line.
std::string AddKnowledge(SemanticMemory& memory, std::string_view text, std::string& notes);

/// Parses a query: (<q> ^kind tank ^weight <any> ^has @13). Variables, and words that look like identifiers, match any
/// value. A minus before the arrow means that the object must not have the augmentation. Returns Soar's error message,
/// or an empty text.
std::string ReadQuery(const SemanticMemory& memory, std::string_view text, Cue& cue);

/// Removes values (@12 ^name tank), attributes (@12 ^name) or all augmentations of an object (@12). Sets `failed`, and
/// removes nothing, if the text is incorrect or if the object or an attribute does not exist. An attribute without
/// values may be missing if the agent knows its name, or if `force` is set and another attribute follows. A missing
/// value is only reported. Returns the problems, one per line.
std::string RemoveKnowledge(SemanticMemory& memory, std::string_view text, bool force, bool& failed);

/// Finds an object by the user's notation: @12 or @name. Returns 0 if there is none.
Lti ObjectNamed(const SemanticMemory& memory, std::string_view text);

}  // namespace soarbox::kernel
