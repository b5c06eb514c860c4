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

/// What one run gives.
struct Row {
  std::string key;  ///< Names the run: the variant with its digest, and the seed.
  std::string build, host;
  std::size_t variant = 0;
  std::uint64_t seed = 0;
  int tries = 1;
  mission::RunResult result;
  std::vector<std::optional<double>> metrics;  ///< As Spec::metrics.
};

/// The truth of a sweep: files of rows, each line with a checksum. Many processes on many machines may add to them at a
/// time, each to its own. A line that was cut off, by a kill or a full disk, does not count.
class RowWriter {
 public:
  /// Makes a new file below the folder; its name gives host and process.
  static Result<std::unique_ptr<RowWriter>> Create(const std::filesystem::path& folder);
  ~RowWriter();
  RowWriter(const RowWriter&) = delete;
  RowWriter& operator=(const RowWriter&) = delete;
  /// Adds a row; it is on the disk a few seconds later. Fails when the disk is full.
  Result<void> Add(const Row& row);
  Result<void> Flush();

 private:
  RowWriter(std::FILE* file, std::filesystem::path path) : file_(file), path_(std::move(path)) {}
  std::FILE* file_;
  std::filesystem::path path_;
  std::chrono::steady_clock::time_point synced_ = std::chrono::steady_clock::now();
};

/// All rows below the folder, one for each key: the first whole one, a good one before a crashed one, and one with a
/// recording before one without. Two that differ in their state hash are a problem, which names both hosts.
std::map<std::string, Row> ReadRows(const std::filesystem::path& folder, std::vector<Diagnostic>& problems);

std::string KeyOf(const Plan& plan, std::size_t variant, std::uint64_t seed);

/// results.csv has a row for each run, numbers.csv one for each number of each run; results.sqlite has both, as `runs`
/// and `numbers`, and the entries of the manifest as `metadata`. manifest.json is the manifest. Each is written beside
/// its place and then moved there.
Result<void> WriteTables(const std::filesystem::path& folder, const Spec& spec, const Plan& plan,
                         const std::vector<Row>& rows, const std::string& manifest);
/// A line of JSON for each run, with the columns of results.csv.
std::string JsonLines(const Spec& spec, const Plan& plan, const std::vector<Row>& rows);

/// The columns that each table has, besides parameters, checks and metrics.
bool IsOwnColumn(std::string_view name);

/// What the rows say: rates and means with confidence, differences of variants on equal seeds.
std::string Summary(const Spec& spec, const Plan& plan, const std::vector<Row>& rows);

}  // namespace soarbox::sweep
