// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "mission/run_mission.h"
#include "sweep/plan.h"

namespace soarbox::sweep {

/// Text after a number of runs.
inline constexpr std::string_view kCrashedOrHung = " crashed or hung";

/// The result of one run.
struct Row {
  std::string key;  ///< Identifies the run: the variant with its digest, and the seed.
  std::string build, host;
  std::size_t variant = 0;
  std::uint64_t seed = 0;
  int tries = 1;
  mission::RunResult result;
  std::vector<std::optional<double>> metrics;  ///< In the order of Spec::metrics.
};

/// Writes rows of a sweep: files of lines, each with a checksum. Several processes on several machines can write at the
/// same time, each to its own file. Incomplete lines, after a kill or a full disk, are ignored. Everything else about a
/// sweep is computed from these files.
class RowWriter {
 public:
  /// Creates a new file in the folder, and the folder if necessary. The file's name contains host and process.
  static Result<std::unique_ptr<RowWriter>> Create(const std::filesystem::path& folder);
  ~RowWriter();
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  /// Adds a row and passes it to the system. If the last Flush was more than 5 s ago, also calls Flush. Fails if the
  /// disk is full.
  Result<void> Add(const Row& row);
  /// Waits until all rows are on the disk.
  Result<void> Flush();

 private:
  RowWriter(std::FILE* file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}
  std::FILE* file_;
  std::filesystem::path path_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

/// Reads the files *.rows in the folder and returns one row for each key: the first whose run succeeded, else the last.
/// If that row has no recording, it gets the recording of a later row of the key. Adds a problem, which names both
/// hosts, if two successful runs of a key with the same build have different state hashes.
std::map<std::string, Row> ReadRows(const std::filesystem::path& folder, std::vector<Diagnostic>& problems);

std::string KeyOf(const Plan& plan, std::size_t variant, std::uint64_t seed);

/// Writes the tables of a sweep: results.csv with a row for each run, numbers.csv with a row for each number of each
/// run, and results.sqlite with both (`runs`, `numbers`) and the entries of the manifest (`metadata`). manifest.json is
/// the manifest. Each file replaces the old one atomically.
Result<void> WriteTables(const std::filesystem::path& folder, const Spec& spec, const Plan& plan,
                         const std::vector<Row>& rows, const std::string& manifest);
/// One line of JSON for each run, with the columns of results.csv.
std::string JsonLines(const Spec& spec, const Plan& plan, const std::vector<Row>& rows);

/// Whether a column is one of those that each table has, not a parameter, check or metric.
bool IsOwnColumn(std::string_view name);

/// The results as text: rates and means with confidence intervals, and differences of variants for equal seeds.
std::string Summary(const Spec& spec, const Plan& plan, const std::vector<Row>& rows);

}  // namespace soarbox::sweep
