// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/tidy_files.h"

#include <memory>

#include "diagnostics/problem.h"
#include "sweep/table_files.h"

namespace soarbox::sweep {
namespace {

Result<std::unique_ptr<record::TableSink>> SinkFor(const std::filesystem::path& output, record::Metadata metadata) {
  const std::filesystem::path ending = output.extension();
  if (ending == ".sqlite" || ending == ".db") return SqliteFile(output, std::move(metadata));
  if (ending.empty()) return CsvFolder(output, std::move(metadata));
  return ProblemIn(output, "tables are not written in this form", "name a .sqlite file, or a folder for .csv files");
}

}  // namespace

Result<TidyCounts> WriteTidy(record::Reader& recording, record::TickRange range, const std::filesystem::path& output) {
  Result<std::unique_ptr<record::TableSink>> sink = SinkFor(output, record::MetadataOf(recording));
  if (!sink) return sink.error();
  return record::TidyTables(recording, range, **sink);
}

}  // namespace soarbox::sweep
