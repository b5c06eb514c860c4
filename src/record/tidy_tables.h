// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "record/export.h"
#include "record/table.h"

namespace soarbox::record {

/// Number of rows in each table of TidyTables.
struct TidyCounts {
  std::size_t agents = 0, events = 0, percepts = 0;
};

/// Writes a recording as three tables in long form:
///
/// * `agents`: a row per agent and tick: position, speed, health, command, operator, depth of its goal stack
/// * `events`: a row per event, of the world and of minds
/// * `percepts`: a row for each change of a percept; a percept keeps its value until its next row
Result<TidyCounts> TidyTables(Reader& recording, TickRange range, TableSink& sink);

/// The data of the recording's header and of its manifest.
Metadata MetadataOf(const Reader& recording);

}  // namespace soarbox::record
