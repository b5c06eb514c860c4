// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/longterm/semantic_query.h"

namespace soarbox::kernel {

class SemanticMemory;

/// The texts of `smem --add`, `--query` and `--remove`, without the outer braces:
///   (@12 ^name tank ^has @13 <part> ^engine.fuel diesel) (<part> ^name hatch) (@steel ^hardness 6)
/// An object is a number (@12), a name that holds for the whole memory (@steel), or a variable, which stands for a new
/// object within one text. Several values may follow an attribute; a path makes an object for each of its dots. A
/// number in parentheses behind a link is its weight (link_weights.h).

/// Adds what the text says, up to the first clause that is wrong. Gives Soar's message of what is wrong, or an empty
/// text; `notes` gets what is wrong and does no harm, in lines.
std::string AddKnowledge(SemanticMemory& memory, std::string_view text, std::string& notes);

/// Reads a query: (<q> ^kind tank ^weight <any> ^has @13). Variables, and words that look like identifiers, stand for
/// any value; a minus before the arrow for what must not be there. Gives Soar's message of what is wrong, or an empty
/// text.
std::string ReadQuery(const SemanticMemory& memory, std::string_view text, Cue& cue);

/// Removes values (@12 ^name tank), attributes (@12 ^name) or all augmentations of an object (@12). An attribute that
/// is not there is a failure, unless `force` is set and another one follows; then nothing is removed. A value that is
/// not there is told only. Gives what was wrong, one a line.
std::string RemoveKnowledge(SemanticMemory& memory, std::string_view text, bool force, bool& failed);

/// The number of an object as a user writes it: @12 or @name. 0 if it names none.
Lti ObjectNamed(const SemanticMemory& memory, std::string_view text);

}  // namespace soarbox::kernel
