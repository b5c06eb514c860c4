// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/longterm/semantic_query.h"

namespace soarbox::kernel {

class SemanticMemory;

/// The texts of `smem --add`, `--query` and `--remove`, without the outer braces:
///   (@12 ^name tank ^has @13 <part> ^engine.fuel diesel) (<part> ^name hatch) (@steel ^hardness 6)
/// An object is a number (@12), a name known in the whole memory (@steel), or a variable, which means a new object
/// within one text. Several values may follow an attribute; a path makes an object for each of its dots. A number in
/// parentheses after a link is its weight (link_weights.h).

/// Adds what the text says, up to the first wrong clause. Returns Soar's message about it, or an empty text; `notes`
/// gets harmless mistakes, one per line.
std::string AddKnowledge(SemanticMemory& memory, std::string_view text, std::string& notes);

/// Reads a query: (<q> ^kind tank ^weight <any> ^has @13). Variables, and words that look like identifiers, mean any
/// value; a minus before the arrow means that the object must not have it. Returns Soar's message about what is wrong,
/// or an empty text.
std::string ReadQuery(const SemanticMemory& memory, std::string_view text, Cue& cue);

/// Removes values (@12 ^name tank), attributes (@12 ^name) or all augmentations of an object (@12). A missing attribute
/// is a failure, unless `force` is set and another one follows; then nothing is removed. A missing value is only
/// reported. Returns what was wrong, one problem per line.
std::string RemoveKnowledge(SemanticMemory& memory, std::string_view text, bool force, bool& failed);

/// The number of an object as a user writes it: @12 or @name. 0 if there is no such object.
Lti ObjectNamed(const SemanticMemory& memory, std::string_view text);

}  // namespace soarbox::kernel
