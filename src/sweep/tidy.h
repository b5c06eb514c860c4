// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>

#include "record/tidy.h"

namespace soarbox::sweep {

using record::TidyCounts;

/// Writes a recording as tables in long form (record::TidyTables). The ending of `output` says how: `.sqlite` or `.db`
/// a database, `.jsonl` lines of JSON, none a folder of comma-separated values. Other endings are refused.
Result<TidyCounts> WriteTidy(record::Reader& recording, record::TickRange range, const std::filesystem::path& output);

}  // namespace soarbox::sweep
