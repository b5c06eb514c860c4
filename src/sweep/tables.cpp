// SPDX-License-Identifier: BSD-2-Clause
#include <sqlite3.h>

#include <algorithm>
#include <cctype>
#include <cstdio>
#include <fstream>
#include <memory>
#include <set>
#include <variant>

#include "diagnostics/problem.h"
#include "mission/sentences.h"
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
    cells.emplace_back(run.recording);
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

Result<void> WriteSqlite(const fs::path& file, const Table& table) {
  std::error_code error;
  fs::remove(file, error);
  sqlite3* opened = nullptr;
  const int code = sqlite3_open(file.c_str(), &opened);
  const std::unique_ptr<sqlite3, CloseDatabase> database(opened);
  const auto fail = [&] { return Unwritten(file, opened != nullptr ? sqlite3_errmsg(opened) : "no memory"); };
  if (code != SQLITE_OK) return fail();
  std::string create = "CREATE TABLE runs (", insert = "INSERT INTO runs VALUES (";
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    create += (i > 0 ? ", " : "") + Identifier(table.columns[i].name) + table.columns[i].type;
    insert += i > 0 ? ", ?" : "?";
  }
  // The file is thrown away if this does not come to its end: no journal, one transaction.
  for (const std::string& line : {std::string("PRAGMA journal_mode = OFF"), std::string("BEGIN"), create + ")"})
    if (sqlite3_exec(opened, line.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return fail();
  sqlite3_stmt* prepared = nullptr;
  if (sqlite3_prepare_v2(opened, (insert + ")").c_str(), -1, &prepared, nullptr) != SQLITE_OK) return fail();
  {
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
      if (sqlite3_step(prepared) != SQLITE_DONE) return fail();
      sqlite3_reset(prepared);
    }
  }
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

Result<void> WriteTables(const fs::path& folder, const Spec& spec, const Plan& plan, const std::vector<Row>& rows) {
  const Table table = MakeTable(spec, plan, rows);
  std::error_code error;
  for (const char* name : {"results.csv", "results.sqlite"}) {
    const fs::path file = folder / name, making = folder / (std::string(".") + name);
    const Result<void> written = file.extension() == ".csv" ? WriteCsv(making, table) : WriteSqlite(making, table);
    if (!written) return written;
    fs::rename(making, file, error);
    if (error) return Unwritten(file, error.message());
  }
  return {};
}

}  // namespace soarbox::sweep
