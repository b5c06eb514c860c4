// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

#include "record/tidy_tables.h"

namespace soarbox::sweep {

using record::TidyCounts;

/// Writes a recording as tables in long form (record::TidyTables). The extension of `output` selects the format:
/// `.sqlite` or `.db` for a database, none for a folder of CSV files. Other extensions are refused.
Result<TidyCounts> WriteTidy(record::Reader& recording, record::TickRange range, const std::filesystem::path& output);

}  // namespace soarbox::sweep
