// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "record/table.h"

namespace soarbox::sweep {

/// Tables as files of comma-separated values in a folder (RFC 4180): TABLE.csv; the metadata become manifest.json. Each
/// file is written beside its place and moved there by Finish.
Result<std::unique_ptr<record::TableSink>> CsvFolder(const std::filesystem::path& folder, record::Metadata metadata);

/// Tables of one SQLite database, which Finish puts into its place; the metadata are its table `metadata`.
Result<std::unique_ptr<record::TableSink>> SqliteFile(const std::filesystem::path& file, record::Metadata metadata);

/// A line of JSON for each row, with the name of its table as `table`; the first line has the metadata.
Result<std::unique_ptr<record::TableSink>> JsonLinesFile(const std::filesystem::path& file, record::Metadata metadata);

/// A cell as JSON (null: empty), or as a field of comma-separated values.
std::string JsonOf(const record::Cell& cell);
std::string CsvOf(const record::Cell& cell);

}  // namespace soarbox::sweep
