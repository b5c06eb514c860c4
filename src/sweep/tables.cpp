// SPDX-License-Identifier: BSD-2-Clause
#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "diagnostics/problem.h"
#include "mission/sentences.h"
#include "sweep/manifest.h"
#include "sweep/rows.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;

using Cell = std::variant<std::monostate, double, std::int64_t, std::string>;

struct Column {
  std::string name;
  const char* type = " REAL";  ///< For SQL; empty: as each cell is.
};
constexpr const char *kText = " TEXT", *kWhole = " INTEGER";

struct Table {
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
};

Diagnostic Unwritten(const fs::path& file, std::string message) {
  return ProblemIn(file.string(), "this table cannot be written: " + std::move(message),
                   "the rows are safe in the folder parts: run the same command again when there is room");
}

std::string Lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return lower;
}

/// "40" as a number, "\"soldier\"" as a text.
Cell ParameterCell(const std::string& text) {
  try {
    std::size_t used = 0;
    const double number = std::stod(text, &used);
    if (used == text.size()) return number;
  } catch (const std::exception&) {
  }
  return text.size() > 1 && (text.front() == '\'' || text.front() == '"') ? text.substr(1, text.size() - 2) : text;
}

/// Databases take "Time: a" and "time: a" for one name.
void MakeNamesDiffer(std::vector<Column>& columns) {
  std::set<std::string> taken;
  for (Column& column : columns) {
    const std::string name = column.name;
    for (int number = 2; !taken.insert(Lower(column.name)).second; ++number)
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
    // From the sweep's folder, which can be moved.
    cells.emplace_back(run.recording.empty() ? std::string()
                                             : "recordings/" + fs::path(run.recording).filename().string());
  }
  return table;
}

std::string CsvField(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

Result<void> WriteCsv(const fs::path& file, const Table& table) {
  std::ofstream out(file, std::ios::binary);
  for (std::size_t i = 0; i < table.columns.size(); ++i) out << (i > 0 ? "," : "") << CsvField(table.columns[i].name);
  out << "\r\n";
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out << ',';
      if (const double* number = std::get_if<double>(&row[i])) {
        char text[32];
        std::snprintf(text, sizeof text, "%.10g", *number);
        out << text;
      } else if (const std::int64_t* whole = std::get_if<std::int64_t>(&row[i])) {
        out << *whole;
      } else if (const std::string* text = std::get_if<std::string>(&row[i])) {
        out << CsvField(*text);
      }
    }
    out << "\r\n";
  }
  if (!out.flush()) return Unwritten(file, "is the disk full?");
  return {};
}

struct CloseDatabase {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct EndStatement {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};

std::string Identifier(const std::string& name) {
  std::string quoted = "\"";
  for (const char c : name) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

/// What a run is named by, before the first column that a run measures.
std::size_t NamesIn(const Spec& spec) {
  return 2 + spec.parameters.size();
}

/// A cell as a number: whether a check came true is 1 or 0. None if it is empty, or another text.
std::optional<double> NumberIn(const Column& column, const Cell& cell) {
  if (const double* number = std::get_if<double>(&cell)) return *number;
  if (const std::int64_t* whole = std::get_if<std::int64_t>(&cell)) return static_cast<double>(*whole);
  const std::string* text = std::get_if<std::string>(&cell);
  if (text == nullptr || !column.name.starts_with("check: ") || *text == "undecided") return std::nullopt;
  return *text == "true" ? 1 : 0;
}

/// The same in long form: a row for each number of each run.
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

/// The manifest as a table of names and values.
Table MetadataOf(const std::string& manifest) {
  Table table;
  table.columns = {{"name", kText}, {"value", kText}};
  for (auto& [name, value] : EntriesOf(manifest)) {
    std::vector<Cell>& cells = table.rows.emplace_back();
    cells.emplace_back(name);
    cells.emplace_back(value);
  }
  return table;
}

/// Adds a table to an open database; false if that fails.
bool AddTable(sqlite3* database, const std::string& name, const Table& table) {
  std::string create = "CREATE TABLE " + name + " (", insert = "INSERT INTO " + name + " VALUES (";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    create += (i > 0 ? ", " : "") + Identifier(table.columns[i].name) + table.columns[i].type;
    insert += i > 0 ? ", ?" : "?";
  }
  if (sqlite3_exec(database, (create + ")").c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return false;
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(database, (insert + ")").c_str(), -1, &prepared, nullptr) != SQLITE_OK) return false;
  const std::unique_ptr<sqlite3_stmt, EndStatement> statement(prepared);
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int place = static_cast<int>(i) + 1;
      if (const double* number = std::get_if<double>(&row[i])) {
        sqlite3_bind_double(prepared, place, *number);
      } else if (const std::int64_t* whole = std::get_if<std::int64_t>(&row[i])) {
        sqlite3_bind_int64(prepared, place, *whole);
      } else if (const std::string* text = std::get_if<std::string>(&row[i])) {
        sqlite3_bind_text(prepared, place, text->c_str(), static_cast<int>(text->size()), nullptr);
      } else {
        sqlite3_bind_null(prepared, place);
      }
    }
    if (sqlite3_step(prepared) != SQLITE_DONE) return false;
    sqlite3_reset(prepared);
  }
  return true;
}

Result<void> WriteSqlite(const fs::path& file, const Table& runs, const Table& tidy, const Table& metadata) {
  std::error_code error;
  fs::remove(file, error);
  sqlite3* opened = nullptr;
  const int code = sqlite3_open(file.c_str(), &opened);
  const std::unique_ptr<sqlite3, CloseDatabase> database(opened);
  const auto fail = [&] { return Unwritten(file, opened != nullptr ? sqlite3_errmsg(opened) : "no memory"); };
  if (code != SQLITE_OK) return fail();
  // The file is thrown away if this does not come to its end: no journal, one transaction.
  for (const char* line : {"PRAGMA journal_mode = OFF", "BEGIN"})
    if (sqlite3_exec(opened, line, nullptr, nullptr, nullptr) != SQLITE_OK) return fail();
  for (const auto& [name, table] : {std::pair{"runs", &runs}, {"numbers", &tidy}, {"metadata", &metadata}})
    if (!AddTable(opened, name, *table)) return fail();
  if (sqlite3_exec(opened, "COMMIT", nullptr, nullptr, nullptr) != SQLITE_OK) return fail();
  return {};
}

}  // namespace

bool IsOwnColumn(std::string_view name) {
  static constexpr const char* kOwn[] = {
      "variant",    "seed",      "outcome",  "passed",          "seconds",  "cpu_s",      "peak_mb",
      "state_hash", "host",      "tries",    "recording",       "alive",    "collisions", "commands",
      "damage",     "decisions", "distance", "failed_commands", "firings",  "gaps",       "health",
      "hits",       "idle",      "learned",  "messages",        "problems", "rounds",     "score"};
  const std::string lower = Lower(name);
  return lower.starts_with("impasses_") || lower.starts_with("check: ") || lower.starts_with("time: ") ||
         lower.starts_with("parameter: ") || std::ranges::find(kOwn, lower) != std::end(kOwn);
}

Result<void> WriteTables(const fs::path& folder, const Spec& spec, const Plan& plan, const std::vector<Row>& rows,
                         const std::string& manifest) {
  const Table runs = MakeTable(spec, plan, rows), tidy = TidyOf(spec, runs);
  std::error_code error;
  for (const char* name : {"results.csv", "numbers.csv", "results.sqlite"}) {
    const fs::path file = folder / name, making = folder / (std::string(".") + name);
    const Result<void> written = file.extension() == ".sqlite"
                                     ? WriteSqlite(making, runs, tidy, MetadataOf(manifest))
                                     : WriteCsv(making, file.stem() == "results" ? runs : tidy);
    if (!written) return written;
    fs::rename(making, file, error);
    if (error) return Unwritten(file, error.message());
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
