// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "debugger/memory.h"
#include "mind/inspection_facts.h"
#include "workbench/document/document.h"

namespace soarbox::workbench::document {

/// An element of an object, with a mark if it changed in this tick: "+ ^io I1 input-link". `meaning` is the tooltip of
/// its attribute.
Spans ElementSpans(const debugger::MemoryRow& row, const std::string& unit = {}, std::string meaning = {});

/// Adds the origin of an element or a preference: a rule with the elements that it matched, the world or Soar.
void AddMaker(const mind::MakerFact& maker, Nodes& nodes);

}  // namespace soarbox::workbench::document
