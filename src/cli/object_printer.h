// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "cli/print_stream.h"
#include "cli/result_node.h"
#include "kernel/agent.h"

namespace soarbox::cli {

/// The format in which objects of working memory are printed.
struct ObjectStyle {
  int depth = 1;           ///< Number of levels of objects; at least 1.
  bool internal = false;   ///< One line per element, with its time tag.
  bool tree = false;       ///< One line per element; objects are below the element that leads to them.
  bool variables = false;  ///< Identifiers are printed as variables, in angle brackets.
};

/// Prints an object and those below it, each once, at its smallest depth. Attributes are sorted by their printed text.
/// An object without elements prints nothing. Also appends <id> and <wme> elements to `structured`.
void PrintObject(PrintStream& stream, const kernel::Agent& agent, kernel::Symbol id, const ObjectStyle& style,
                 ResultNode& structured);

/// "(12: S1 ^attribute value +)"; without the time tag if `timetag` is false.
std::string WmeText(const kernel::Agent& agent, kernel::WmeId wme, bool timetag = true, bool variables = false);
/// `is_new`: the element is being added to working memory.
std::string WmeText(const kernel::Agent& agent, const kernel::WmeInfo& wme, bool timetag = true, bool is_new = false);
/// A matched element of a firing at this level, as the trace shows it: in full only in substates.
std::string MatchedText(const kernel::Agent& agent, kernel::WmeId wme, kernel::GoalLevel level);

/// "string", "int", "double" or "id", as documents name the type of a value.
const char* ValueTypeName(kernel::Symbol value);

/// A symbol as rules and objects show it.
std::string SymbolText(const kernel::Agent& agent, kernel::Symbol symbol);

/// The elements of an identifier, sorted by the printed text of their attributes.
std::vector<kernel::WmeId> SortedWmes(const kernel::Agent& agent, kernel::Symbol id);

/// A <wme> element for structured results.
void AddWmeNode(ResultNode& parent, const kernel::Agent& agent, kernel::WmeId wme, bool with_tag = true);

}  // namespace soarbox::cli
