// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "kernel/base/symbol.h"
#include "kernel/longterm/knowledge.h"
#include "kernel/longterm/semantic_query.h"

namespace soarbox::kernel {

class SymbolTable;
class WorkingMemory;

/// Descriptions of commands to long-term memory, their results and the reasons, for observers of Event::kRecall. Called
/// only if there is such an observer; changes nothing.

/// The elements of a cue: "^kind ammo ^site @3 ^room <any>". `depth`: maximum number of levels of objects that are
/// expanded, as paths: "^enemy.name bob".
std::string CueWords(const WorkingMemory& memory, const SymbolTable& symbols, Symbol cue, int depth);

/// The first constants of an object: "^kind ammo ^name crate".
std::string ObjectWords(const Knowledge& knowledge, std::uint32_t object);

/// Why a query returned this object: "the only one that fits", "the most active of those that fit: 3.000, then @4 with
/// 2.000". `others`: the best of the objects that fit, the returned one first; empty if there were too many to compare.
std::string WhyFound(const Knowledge& knowledge, const Activations& activations, const Cue& cue,
                     std::span<const std::uint32_t> others);

/// Why a query returned nothing: "no known object has ^kind mortar". `prohibited_fits`: a prohibited object fits.
std::string WhyNotFound(const Knowledge& knowledge, const WorkingMemory& memory, const SymbolTable& symbols, Symbol cue,
                        bool prohibited_fits);

}  // namespace soarbox::kernel
