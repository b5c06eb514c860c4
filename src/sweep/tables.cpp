// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "diagnostics/lower_case.h"
#include "mission/check_sentences.h"
#include "record/manifest.h"
#include "sweep/rows.h"
#include "sweep/sweep_manifest.h"
#include "sweep/table_files.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;

using record::Cell;
using record::Column;
using record::kText;
using record::kWhole;

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

/// "40" is a number, "\"soldier\"" is a text.
Cell ParameterCell(const std::string& text) {
  try {
    std::size_t used = 0;
    const double number = std::stod(text, &used);
    if (used == text.size()) return number;
  } catch (const std::exception&) {
  }
  return text.size() > 1 && (text.front() == '\'' || text.front() == '"') ? text.substr(1, text.size() - 2) : text;
}

/// Makes names of columns unique; databases treat "Time: a" and "time: a" as the same name.
void MakeNamesDiffer(std::vector<Column>& columns) {
  std::set<std::string> taken;
  for (Column& column : columns) {
    const std::string name = column.name;
    for (int number = 2; !taken.insert(LowerCase(column.name)).second; ++number)
      column.name = name + " (" + std::to_string(number) + ")";
  }
}

Table MakeTable(const Spec& spec, const Plan& plan, const std::vector<Row>& rows) {
  Table table;
  table.columns = {{"variant", kText}, {"seed", kWhole}};
  for (const std::string& parameter : spec.parameters)
    table.columns.push_back({IsOwnColumn(parameter) ? "parameter: " + parameter : parameter, ""});
  table.columns.push_back({"outcome", kText});
  table.columns.push_back({"passed", kWhole});
  for (const mission::Check& check : spec.mission.checks) {
    table.columns.push_back({"check: " + check.name, kText});
    table.columns.push_back({"time: " + check.name});
  }
  for (const Metric& metric : spec.metrics) table.columns.push_back({metric.name});
  table.columns.push_back({"seconds"});
  std::set<std::string> numbers;
  for (const Row& row : rows)
    for (const auto& [name, value] : row.result.numbers) numbers.insert(name);
  for (const std::string& number : numbers) table.columns.push_back({number});
  for (const char* name : {"cpu_s", "peak_mb"}) table.columns.push_back({name});
  for (const char* name : {"state_hash", "host"}) table.columns.push_back({name, kText});
  table.columns.push_back({"tries", kWhole});
  table.columns.push_back({"recording", kText});
  MakeNamesDiffer(table.columns);
  for (const Row& row : rows) {
    const Variant& variant = plan.variants[row.variant].variant;
    const mission::RunResult& run = row.result;
    std::vector<Cell>& cells = table.rows.emplace_back();
    cells.emplace_back(variant.name);
    cells.emplace_back(static_cast<std::int64_t>(row.seed));
    for (const std::string& parameter : spec.parameters) {
      Cell cell;
      for (const auto& [name, value] : variant.parameters)
        if (name == parameter) cell = ParameterCell(value);
      cells.push_back(std::move(cell));
    }
    cells.emplace_back(run.outcome);
    const bool is_judged = run.outcome == "ok" && (run.IsJudged() || !run.IsUndecided());
    cells.emplace_back(is_judged ? Cell(std::int64_t{run.passed ? 1 : 0}) : Cell());
    for (std::size_t i = 0; i < spec.mission.checks.size(); ++i) {
      const bool is_there = i < run.checks.size();
      cells.emplace_back(is_there ? Cell(std::string(mission::NameOf(run.checks[i].verdict.state))) : Cell());
      cells.emplace_back(is_there ? Cell(run.checks[i].verdict.time_s) : Cell());
    }
    for (std::size_t i = 0; i < spec.metrics.size(); ++i)
      cells.emplace_back(i < row.metrics.size() && row.metrics[i] ? Cell(*row.metrics[i]) : Cell());
    cells.emplace_back(run.seconds);
    for (const std::string& number : numbers) {
      const std::optional<double> value = run.NumberOf(number);
      cells.emplace_back(value ? Cell(*value) : Cell());
    }
    cells.emplace_back(run.cpu_s);
    cells.emplace_back(run.peak_mb);
    char hash[20];
    std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(run.state_hash));
    cells.emplace_back(std::string(hash));
    cells.emplace_back(row.host);
    cells.emplace_back(std::int64_t{row.tries});
    // Relative to the sweep's folder, which can be moved.
    cells.emplace_back(run.recording.empty() ? std::string()
                                             : "recordings/" + fs::path(run.recording).filename().string());
  }
  return table;
}

/// Number of columns that identify a run; measured columns follow.
std::size_t NamesIn(const Spec& spec) {
  return 2 + spec.parameters.size();
}

/// A cell as a number; results of checks are 1 or 0. Nothing if the cell is empty or another text.
std::optional<double> NumberIn(const Column& column, const Cell& cell) {
  if (const double* number = std::get_if<double>(&cell)) return *number;
  if (const std::int64_t* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  const std::string* text = std::get_if<std::string>(&cell);
  if (text == nullptr || !column.name.starts_with("check: ") || *text == "undecided") return std::nullopt;
  return *text == "true" ? 1 : 0;
}

/// The table in long form: a row for each number of each run.
Table TidyOf(const Spec& spec, const Table& wide) {
  Table tidy;
  const std::size_t names = NamesIn(spec);
  for (std::size_t i = 0; i < names; ++i) tidy.columns.push_back(wide.columns[i]);
  tidy.columns.push_back({"name", kText});
  tidy.columns.push_back({"value"});
  for (const std::vector<Cell>& row : wide.rows) {
    for (std::size_t i = names; i < row.size(); ++i) {
      const std::optional<double> number = NumberIn(wide.columns[i], row[i]);
      if (!number) continue;
      std::vector<Cell>& cells = tidy.rows.emplace_back();
      for (std::size_t name = 0; name < names; ++name) cells.push_back(row[name]);
      cells.emplace_back(wide.columns[i].name);
      cells.emplace_back(*number);
    }
  }
  return tidy;
}

/// Passes a table to a sink.
Result<void> Put(record::TableSink& sink, std::size_t number, const std::string& name, const Table& table) {
  if (Result<void> begun = sink.Begin(name, table.columns); !begun) return begun;
  for (const std::vector<Cell>& row : table.rows)
    if (Result<void> added = sink.Add(number, row); !added) return added;
  return {};
}

}  // namespace

bool IsOwnColumn(std::string_view name) {
  static constexpr const char* kOwn[] = {
      "variant",    "seed",      "outcome",  "passed",          "seconds",  "cpu_s",      "peak_mb",
      "state_hash", "host",      "tries",    "recording",       "alive",    "collisions", "commands",
      "damage",     "decisions", "distance", "failed_commands", "firings",  "gaps",       "health",
      "hits",       "idle",      "learned",  "messages",        "problems", "rounds",     "score"};
  const std::string lower = LowerCase(name);
  return lower.starts_with("impasses_") || lower.starts_with("check: ") || lower.starts_with("time: ") ||
         lower.starts_with("parameter: ") || std::ranges::find(kOwn, lower) != std::end(kOwn);
}

Result<void> WriteTables(const fs::path& folder, const Spec& spec, const Plan& plan, const std::vector<Row>& rows,
                         const std::string& manifest) {
  const Table runs = MakeTable(spec, plan, rows), tidy = TidyOf(spec, runs);
  const auto write = [&](Result<std::unique_ptr<record::TableSink>> sink, const char* runs_name) -> Result<void> {
    if (!sink) return sink.error();
    if (Result<void> put = Put(**sink, 0, runs_name, runs); !put) return put;
    if (Result<void> put = Put(**sink, 1, "numbers", tidy); !put) return put;
    return (*sink)->Finish();
  };
  const record::Metadata metadata = record::EntriesOf(manifest);
  Result<void> written = write(CsvFolder(folder, metadata), "results");
  if (written) written = write(SqliteFile(folder / "results.sqlite", metadata), "runs");
  if (!written) {
    Diagnostic problem = written.error();
    problem.hint = "the rows are safe in the folder parts: run the same command again when there is room";
    return problem;
  }
  return WriteManifest(folder, manifest);
}

std::string JsonLines(const Spec& spec, const Plan& plan, const std::vector<Row>& rows) {
  const Table table = MakeTable(spec, plan, rows);
  std::string lines;
  for (const std::vector<Cell>& row : table.rows) {
    nlohmann::ordered_json line{{"event", "run"}};
    for (std::size_t i = 0; i < row.size(); ++i) {
      auto& value = line[table.columns[i].name];
      if (const double* number = std::get_if<double>(&row[i])) value = *number;
      if (const std::int64_t* whole = std::get_if<std::int64_t>(&row[i])) value = *whole;
      if (const std::string* text = std::get_if<std::string>(&row[i])) value = *text;
    }
    lines += line.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
  }
  return lines;
}

}  // namespace soarbox::sweep
