// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "record/table.h"

namespace soarbox::sweep {

/// Writes tables as CSV files (RFC 4180) in a folder: TABLE.csv. The metadata become manifest.json. Finish replaces old
/// files atomically.
Result<std::unique_ptr<record::TableSink>> CsvFolder(const std::filesystem::path& folder, record::Metadata metadata);

/// Writes tables to an SQLite database, which Finish moves to its final place. The metadata are in the table
/// `metadata`.
Result<std::unique_ptr<record::TableSink>> SqliteFile(const std::filesystem::path& file, record::Metadata metadata);

/// Formats a cell as a CSV field.
std::string CsvOf(const record::Cell& cell);

}  // namespace soarbox::sweep
