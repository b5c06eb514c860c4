// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/rows.h"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "diagnostics/problem.h"
#include "record/header.h"
#include "record/manifest.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

std::string ChecksumOf(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  char out[20];
  std::snprintf(out, sizeof out, "%016llx ", static_cast<unsigned long long>(hash));
  return out;
}

Diagnostic Failed(const fs::path& path) {
  return ProblemIn(path.string(), std::string("rows cannot be written: ") + std::strerror(errno),
                   "what was computed so far is kept: run the same command again when there is room");
}

Row RowFromJson(const Json& json) {
  Row row;
  row.key = json.value("key", "");
  row.build = json.value("build", "");
  row.host = json.value("host", "");
  row.variant = json.value("variant", std::size_t{0});
  row.seed = json.value("seed", std::uint64_t{0});
  row.tries = json.value("tries", 1);
  row.result.cpu_s = json.value("cpu_s", 0.0);
  row.result.peak_mb = json.value("peak_mb", 0.0);
  for (const Json& metric : json.value("metrics", Json::array()))
    row.metrics.push_back(metric.is_number() ? std::optional<double>(metric.get<double>()) : std::nullopt);
  return row;
}

/// Parses a line; nothing if it is incomplete or invalid.
std::optional<Row> ReadRow(const std::string& line) {
  if (line.size() < 18 || ChecksumOf(std::string_view(line).substr(17)) != line.substr(0, 17)) return std::nullopt;
  const Json json = Json::parse(line.substr(17), nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    Row row = RowFromJson(json);
    Result<mission::RunResult> result = mission::FromJsonLine(json.value("result", ""));
    if (!result) return std::nullopt;
    result->seed = row.seed;
    result->cpu_s = row.result.cpu_s;
    result->peak_mb = row.result.peak_mb;
    row.result = std::move(*result);
    return row;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::string KeyOf(const Plan& plan, std::size_t variant, std::uint64_t seed) {
  const ReadyVariant& ready = plan.variants[variant];
  return ready.digest + "/" + ready.variant.name + "/" + std::to_string(seed);
}

Result<std::unique_ptr<RowWriter>> RowWriter::Create(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  for (int number = 1; number < 10'000; ++number) {
    const fs::path path =
        folder / (record::HostName() + "-" + std::to_string(getpid()) + "-" + std::to_string(number) + ".rows");
    if (fs::exists(path, error)) continue;
    std::FILE* file = std::fopen(path.c_str(), "wxe");
    if (file == nullptr) return Failed(path);
    return std::unique_ptr<RowWriter>(new RowWriter(file, path));
  }
  return Failed(folder);
}

RowWriter::~RowWriter() {
  std::fclose(file_);
}

Result<void> RowWriter::Add(const Row& row) {
  Json json{{"key", row.key},
            {"build", row.build},
            {"host", row.host},
            {"variant", row.variant},
            {"seed", row.seed},
            {"tries", row.tries},
            {"result", mission::ToJsonLine(row.result)},
            {"cpu_s", row.result.cpu_s},
            {"peak_mb", row.result.peak_mb}};
  Json& metrics = json["metrics"] = Json::array();
  for (const std::optional<double>& metric : row.metrics) metrics.push_back(metric ? Json(*metric) : Json(nullptr));
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  const std::string line = ChecksumOf(text) + text + "\n";
  if (std::fwrite(line.data(), 1, line.size(), file_) != line.size() || std::fflush(file_) != 0) return Failed(path_);
  const auto now = std::chrono::steady_clock::now();
  if (now - synced_ > std::chrono::seconds(5)) return Flush();
  return {};
}

Result<void> RowWriter::Flush() {
  synced_ = std::chrono::steady_clock::now();
  if (std::fflush(file_) != 0 || fsync(fileno(file_)) != 0) return Failed(path_);
  return {};
}

std::map<std::string, Row> ReadRows(const fs::path& folder, std::vector<Diagnostic>& problems) {
  std::map<std::string, Row> rows;
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".rows") files.push_back(it->path());
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files) {
    std::ifstream in(file, std::ios::binary);
    for (std::string line; std::getline(in, line);) {
      std::optional<Row> row = ReadRow(line);
      if (!row) continue;
      const auto [at, is_new] = rows.try_emplace(row->key, *row);
      if (is_new) continue;
      Row& known = at->second;
      if (known.result.outcome != "ok") {
        const int tries = std::max(known.tries, row->tries);
        known = std::move(*row);
        known.tries = tries;
      } else if (row->result.outcome == "ok" && row->build == known.build &&
                 row->result.state_hash != known.result.state_hash) {
        Diagnostic& problem = problems.emplace_back();
        problem.file = file.string();
        problem.message =
            "seed " + std::to_string(row->seed) + " came to different states on " + known.host + " and " + row->host;
        problem.hint =
            "the same build and seed give the same run: that is a fault of Soarbox or of one of these machines";
      } else if (known.result.recording.empty() && row->result.outcome == "ok") {
        known.result.recording = row->result.recording;
      }
    }
  }
  return rows;
}

}  // namespace soarbox::sweep
