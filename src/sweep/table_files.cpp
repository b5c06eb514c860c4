// SPDX-License-Identifier: BSD-2-Clause
#include "sweep/table_files.h"

#include <sqlite3.h>

#include <cstdio>
#include <deque>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "diagnostics/problem.h"

namespace soarbox::sweep {
namespace {

namespace fs = std::filesystem;
using record::Cell;
using record::Column;
using record::Metadata;
using record::TableSink;

Diagnostic CannotWrite(const fs::path& file, const std::string& why) {
  return ProblemIn(file, "this table cannot be written: " + why, "is the disk full, or the folder not yours?");
}

/// The temporary path of a file that is not complete.
fs::path Making(const fs::path& file) {
  return file.parent_path() / ("." + file.filename().string() + ".part");
}

Result<void> PutInPlace(const fs::path& file) {
  std::error_code error;
  fs::rename(Making(file), file, error);
  if (error) return CannotWrite(file, error.message());
  return {};
}

/// Refuses devices, because moving the file there would replace the device.
Result<void> CheckPlace(const fs::path& file) {
  std::error_code error;
  const fs::file_status there = fs::status(file, error);
  if (fs::exists(there) && !fs::is_regular_file(there)) return CannotWrite(file, "it is not a plain file");
  return {};
}

std::string QuotedCsv(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

nlohmann::ordered_json ObjectOf(const Metadata& metadata) {
  nlohmann::ordered_json made = nlohmann::ordered_json::object();
  for (const auto& [name, value] : metadata) {
    nlohmann::ordered_json parsed = nlohmann::ordered_json::parse(value, nullptr, false);
    made[name] = parsed.is_object() || parsed.is_array() ? std::move(parsed) : nlohmann::ordered_json(value);
  }
  return made;
}

class CsvSink final : public TableSink {
 public:
  CsvSink(fs::path folder, Metadata metadata) : folder_(std::move(folder)), metadata_(std::move(metadata)) {}

  Result<void> Begin(const std::string& table, const std::vector<Column>& columns) override {
    File& file = files_.emplace_back();
    file.path = folder_ / (table + ".csv");
    if (Result<void> checked = CheckPlace(file.path); !checked) return checked;
    file.out.open(Making(file.path), std::ios::binary);
    std::vector<Cell> names;
    for (const Column& column : columns) names.emplace_back(column.name);
    return Add(files_.size() - 1, names);
  }

  Result<void> Add(std::size_t table, const std::vector<Cell>& row) override {
    File& file = files_[table];
    for (std::size_t i = 0; i < row.size(); ++i) file.out << (i > 0 ? "," : "") << CsvOf(row[i]);
    if (file.out << "\r\n") return {};
    return CannotWrite(file.path, "writing failed");
  }

  Result<void> Finish() override {
    File& manifest = files_.emplace_back();
    manifest.path = folder_ / "manifest.json";
    manifest.out.open(Making(manifest.path), std::ios::binary);
    manifest.out << ObjectOf(metadata_).dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << '\n';
    for (File& file : files_) {
      if (!file.out.flush()) return CannotWrite(file.path, "writing failed");
      file.out.close();
      if (Result<void> put = PutInPlace(file.path); !put) return put;
    }
    return {};
  }

 private:
  struct File {
    fs::path path;
    std::ofstream out;
  };
  fs::path folder_;
  Metadata metadata_;
  std::deque<File> files_;
};

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

class SqliteSink final : public TableSink {
 public:
  SqliteSink(fs::path file, Metadata metadata) : file_(std::move(file)), metadata_(std::move(metadata)) {}
  ~SqliteSink() override {
    statements_.clear();
    database_.reset();
    std::error_code error;
    if (!is_finished_) fs::remove(Making(file_), error);
  }

  Result<void> Open() {
    std::error_code error;
    fs::remove(Making(file_), error);
    sqlite3* opened = nullptr;
    const int code = sqlite3_open(Making(file_).c_str(), &opened);
    database_.reset(opened);
    if (code != SQLITE_OK) return Failed();
    // An incomplete file is deleted, so no journal is needed and one transaction is sufficient.
    for (const char* line : {"PRAGMA journal_mode = OFF", "PRAGMA synchronous = OFF", "BEGIN"})
      if (sqlite3_exec(opened, line, nullptr, nullptr, nullptr) != SQLITE_OK) return Failed();
    return {};
  }

  Result<void> Begin(const std::string& table, const std::vector<Column>& columns) override {
    std::string create = "CREATE TABLE " + Identifier(table) + " (",
                insert = "INSERT INTO " + Identifier(table) + " VALUES (";
    for (std::size_t i = 0; i < columns.size(); ++i) {
      create += (i > 0 ? ", " : "") + Identifier(columns[i].name) + columns[i].type;
      insert += i > 0 ? ", ?" : "?";
    }
    if (sqlite3_exec(database_.get(), (create + ")").c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) return Failed();
    sqlite3_stmt* prepared = nullptr;
    if (sqlite3_prepare_v2(database_.get(), (insert + ")").c_str(), -1, &prepared, nullptr) != SQLITE_OK)
      return Failed();
    statements_.emplace_back(prepared);
    return {};
  }

  Result<void> Add(std::size_t table, const std::vector<Cell>& row) override {
    sqlite3_stmt* const statement = statements_[table].get();
    for (std::size_t i = 0; i < row.size(); ++i) {
      const int place = static_cast<int>(i) + 1;
      if (const double* number = std::get_if<double>(&row[i])) {
        sqlite3_bind_double(statement, place, *number);
      } else if (const std::int64_t* whole = std::get_if<std::int64_t>(&row[i])) {
        sqlite3_bind_int64(statement, place, *whole);
      } else if (const std::string* text = std::get_if<std::string>(&row[i])) {
        sqlite3_bind_text(statement, place, text->c_str(), static_cast<int>(text->size()), nullptr);
      } else {
        sqlite3_bind_null(statement, place);
      }
    }
    if (sqlite3_step(statement) != SQLITE_DONE) return Failed();
    sqlite3_reset(statement);
    return {};
  }

  Result<void> Finish() override {
    const std::size_t table = statements_.size();
    if (Result<void> begun = Begin("metadata", {{"name", record::kText}, {"value", record::kText}}); !begun)
      return begun;
    for (const auto& [name, value] : metadata_)
      if (Result<void> added = Add(table, {name, value}); !added) return added;
    if (sqlite3_exec(database_.get(), "COMMIT", nullptr, nullptr, nullptr) != SQLITE_OK) return Failed();
    statements_.clear();
    database_.reset();
    is_finished_ = true;
    return PutInPlace(file_);
  }

 private:
  Diagnostic Failed() const {
    return CannotWrite(file_, database_ != nullptr ? sqlite3_errmsg(database_.get()) : "no memory");
  }
  fs::path file_;
  Metadata metadata_;
  std::unique_ptr<sqlite3, CloseDatabase> database_;
  std::vector<std::unique_ptr<sqlite3_stmt, EndStatement>> statements_;
  bool is_finished_ = false;
};

}  // namespace

std::string CsvOf(const Cell& cell) {
  if (const std::int64_t* whole = std::get_if<std::int64_t>(&cell)) return std::to_string(*whole);
  if (const std::string* text = std::get_if<std::string>(&cell)) return QuotedCsv(*text);
  const double* const number = std::get_if<double>(&cell);
  if (number == nullptr) return {};
  char text[32];
  std::snprintf(text, sizeof text, "%.10g", *number);
  return text;
}

Result<std::unique_ptr<TableSink>> CsvFolder(const fs::path& folder, Metadata metadata) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return ProblemIn(folder, "this folder cannot be made: " + error.message());
  return std::unique_ptr<TableSink>(std::make_unique<CsvSink>(folder, std::move(metadata)));
}

Result<std::unique_ptr<TableSink>> SqliteFile(const fs::path& file, Metadata metadata) {
  if (const Result<void> checked = CheckPlace(file); !checked) return checked.error();
  auto sink = std::make_unique<SqliteSink>(file, std::move(metadata));
  if (const Result<void> opened = sink->Open(); !opened) return opened.error();
  return std::unique_ptr<TableSink>(std::move(sink));
}

}  // namespace soarbox::sweep
