// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>

#include "debugger/memory.h"
#include "mind/facts.h"
#include "workbench/document/document.h"

namespace soarbox::workbench::document {

/// "+ ^io I1 input-link": an element of an object, with what changed in this tick. `meaning` of its attribute is a
/// hint.
Spans ElementSpans(const debugger::MemoryRow& row, const std::string& unit = {}, std::string meaning = {});

/// Adds what put an element or a preference there: a rule with the elements that it matched, the world or Soar.
void AddMaker(const mind::MakerFact& maker, Nodes& nodes);

}  // namespace soarbox::workbench::document
