// SPDX-License-Identifier: BSD-2-Clause
#include "journal/sqlite_journal.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "bytes/byte_stream.h"
#include "bytes/percent_code.h"
#include "diagnostics/problem.h"

namespace soarbox::journal {
namespace {

constexpr std::uint32_t kApplicationId = 0x53424F58;
constexpr std::uint32_t kSchemaVersion = 2;
constexpr std::size_t kSegmentBytes = 1u << 20;

Diagnostic Problem(const std::string& path, std::string_view what, std::string hint = {}) {
  return NewProblem(path + " " + std::string(what), std::move(hint));
}

/// CRC-32 as in zip files.
std::uint32_t Checksum(std::string_view bytes) {
  static const std::array<std::uint32_t, 256> table = [] {
    std::array<std::uint32_t, 256> made{};
    for (std::uint32_t n = 0; n < 256; ++n) {
      std::uint32_t value = n;
      for (int bit = 0; bit < 8; ++bit) value = (value >> 1) ^ ((value & 1) != 0 ? 0xEDB88320u : 0);
      made[n] = value;
    }
    return made;
  }();
  std::uint32_t crc = 0xFFFFFFFFu;
  for (const char byte : bytes) crc = table[(crc ^ static_cast<std::uint8_t>(byte)) & 0xFF] ^ (crc >> 8);
  return ~crc;
}

std::uint32_t BigEndian(const unsigned char* bytes) {
  return (std::uint32_t{bytes[0]} << 24) | (std::uint32_t{bytes[1]} << 16) | (std::uint32_t{bytes[2]} << 8) | bytes[3];
}

std::string_view NameOf(Memory memory) {
  return memory == Memory::kSemantic ? "semantic" : "episodic";
}

/// A prepared statement that is finalized by the destructor.
class Statement {
 public:
  Statement(sqlite3* database, const char* text) {
    status_ = sqlite3_prepare_v2(database, text, -1, &statement_, nullptr);
  }
  ~Statement() { sqlite3_finalize(statement_); }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;

  void Bind(int place, std::int64_t value) { sqlite3_bind_int64(statement_, place, value); }
  void BindBytes(int place, std::string_view bytes) {
    sqlite3_bind_blob64(statement_, place, bytes.data(), bytes.size(), SQLITE_STATIC);
  }
  void Bind(int place, std::string_view text) {
    sqlite3_bind_text(statement_, place, text.data(), static_cast<int>(text.size()), SQLITE_STATIC);
  }
  int Step() {
    if (status_ == SQLITE_OK || status_ == SQLITE_ROW) status_ = sqlite3_step(statement_);
    return status_;
  }
  std::int64_t Integer(int column) const { return sqlite3_column_int64(statement_, column); }
  std::string_view Bytes(int column) const {
    const auto* const data = static_cast<const char*>(sqlite3_column_blob(statement_, column));
    return {data, static_cast<std::size_t>(sqlite3_column_bytes(statement_, column))};
  }

 private:
  sqlite3_stmt* statement_ = nullptr;
  int status_ = SQLITE_OK;
};

/// Why a database of another program is refused. Reads it without creating SQLite's additional files.
Diagnostic RefusalOfForeign(const std::string& path) {
  std::string address = "file:";
  for (const char c : path) {
    if (c == '%' || c == '?' || c == '#') {
      AppendPercentCode(address, c);
    } else {
      address += c;
    }
  }
  address += "?immutable=1";
  sqlite3* database = nullptr;
  const bool is_open =
      sqlite3_open_v2(address.c_str(), &database, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr) == SQLITE_OK;
  const auto has_table = [&](const char* name) {
    Statement table(database, "SELECT 1 FROM sqlite_master WHERE type = 'table' AND name = ?");
    table.Bind(1, std::string_view(name));
    return table.Step() == SQLITE_ROW;
  };
  Diagnostic problem = Problem(path, "is a database of another program", "name another file; this one was not touched");
  if (is_open && has_table("smem_persistent_variables")) {
    problem = Problem(path, "is a database that Soar wrote",
                      "open it in Soar, type smem --export FILE there and source FILE here; this one was not touched");
  } else if (is_open && has_table("epmem_persistent_variables")) {
    problem = Problem(path, "is a database of episodes that Soar wrote, which only Soar can read",
                      "name another file; this one was not touched");
  }
  sqlite3_close(database);
  return problem;
}

/// Checks the header of a file without opening it as a database. Returns nothing if the file can be opened or created.
std::optional<Diagnostic> LookAt(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return {};
  if (std::filesystem::is_directory(path, error)) return Problem(path, "is a folder", "name a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) return Problem(path, "cannot be read");
  unsigned char header[100] = {};
  file.read(reinterpret_cast<char*>(header), sizeof(header));
  const std::streamsize size = file.gcount();
  if (size == 0) return {};
  if (size < 100 || std::memcmp(header, "SQLite format 3", 16) != 0) {
    return Problem(path, "is not a database", "name another file; this one was not touched");
  }
  if (BigEndian(header + 68) != kApplicationId) return RefusalOfForeign(path);
  if (BigEndian(header + 60) > kSchemaVersion) {
    return Problem(path, "was written by a newer version of Soarbox", "use that version; the file was not touched");
  }
  return {};
}

class SqliteJournal final : public kernel::Journal {
 public:
  SqliteJournal(std::string path, sqlite3* database) : path_(std::move(path)), database_(database) {}
  ~SqliteJournal() override {
    static_cast<void>(Commit());
    sqlite3_close(database_);
  }

  void Append(std::string_view record) override { ByteWriter(pending_).Text(record); }

  Result<void> Commit() override {
    if (pending_.empty()) return {};
    Statement insert(database_, "INSERT INTO record(bytes, crc) VALUES(?, ?)");
    insert.BindBytes(1, pending_);
    insert.Bind(2, std::int64_t{Checksum(pending_)});
    if (insert.Step() != SQLITE_DONE) return Failure("cannot be written");
    record_bytes_ += pending_.size();
    pending_.clear();
    return {};
  }

  Result<void> Replace(std::string_view image) override {
    if (!Run("BEGIN IMMEDIATE; DELETE FROM segment; DELETE FROM record")) return Failure("cannot be written");
    for (std::size_t at = 0; at < image.size(); at += kSegmentBytes) {
      const std::string_view piece = image.substr(at, kSegmentBytes);
      Statement insert(database_, "INSERT INTO segment(bytes, crc) VALUES(?, ?)");
      insert.BindBytes(1, piece);
      insert.Bind(2, std::int64_t{Checksum(piece)});
      if (insert.Step() != SQLITE_DONE) return RolledBack();
    }
    if (!Run("COMMIT")) return RolledBack();
    image_bytes_ = image.size();
    record_bytes_ = 0;
    pending_.clear();  // The image includes them.
    return {};
  }

  bool WantsImage() const override { return record_bytes_ > kSegmentBytes && record_bytes_ > image_bytes_ / 4; }

  bool Run(const char* text) { return sqlite3_exec(database_, text, nullptr, nullptr, nullptr) == SQLITE_OK; }

  Diagnostic Failure(std::string_view what) const {
    const int code = sqlite3_errcode(database_) & 0xFF;
    if (code == SQLITE_BUSY || code == SQLITE_LOCKED) {
      return Problem(path_, "is in use by another process", "name another file, or end that process");
    }
    if (code == SQLITE_FULL) {
      return Problem(path_, "cannot grow: the disk is full", "make room; what is new stays in memory until then");
    }
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) {
      return Problem(path_, "is damaged", "use a backup; the file was not touched");
    }
    return Problem(path_, std::string(what) + ": " + sqlite3_errmsg(database_));
  }

  /// Reads the contents. Fails if they are damaged.
  Result<void> Load(OpenedJournal& opened) {
    std::int64_t expected = 0;
    Statement segments(database_, "SELECT number, bytes, crc FROM segment ORDER BY number");
    while (segments.Step() == SQLITE_ROW) {
      const std::string_view bytes = segments.Bytes(1);
      if (Checksum(bytes) != static_cast<std::uint32_t>(segments.Integer(2))) return Damaged("segment", expected);
      opened.image += bytes;
      ++expected;
    }
    if (segments.Step() != SQLITE_DONE) return Failure("cannot be read");
    expected = 0;
    Statement records(database_, "SELECT number, bytes, crc FROM record ORDER BY number");
    int status = records.Step();
    for (; status == SQLITE_ROW; status = records.Step()) {
      const std::string_view bytes = records.Bytes(1);
      if (Checksum(bytes) != static_cast<std::uint32_t>(records.Integer(2))) return Damaged("record", expected);
      ByteReader reader(bytes);
      while (!reader.AtEnd()) opened.records.emplace_back(reader.Text());
      if (reader.failed()) return Damaged("record", expected);
      record_bytes_ += bytes.size();
      ++expected;
    }
    if (status != SQLITE_DONE) return Failure("cannot be read");
    image_bytes_ = opened.image.size();
    return {};
  }

 private:
  Result<void> Damaged(std::string_view table, std::int64_t number) const {
    return Problem(path_, "is damaged (" + std::string(table) + " " + std::to_string(number + 1) + ")",
                   "use a backup; the file was not touched");
  }
  Result<void> RolledBack() {
    const Diagnostic failure = Failure("cannot be written");
    Run("ROLLBACK");
    return failure;
  }

  std::string path_;
  sqlite3* database_;
  std::string pending_;
  std::size_t image_bytes_ = 0, record_bytes_ = 0;
};

std::string Text(std::string_view before, std::uint32_t number) {
  return std::string(before) + std::to_string(number);
}

bool IsOfThisVersion(sqlite3* database) {
  Statement version(database, "PRAGMA user_version");
  return version.Step() == SQLITE_ROW && version.Integer(0) == kSchemaVersion;
}

/// Creates the tables of a new file. The header is written before the log, so that others can identify the file.
bool MakeTables(SqliteJournal& journal, Memory memory) {
  const std::string kind(NameOf(memory));
  return journal.Run(("BEGIN IMMEDIATE;" + Text("PRAGMA application_id=", kApplicationId) + ";" +
                      Text("PRAGMA user_version=", kSchemaVersion) +
                      ";CREATE TABLE meta(key TEXT PRIMARY KEY, value TEXT) WITHOUT ROWID;"
                      "CREATE TABLE segment(number INTEGER PRIMARY KEY, bytes BLOB, crc INTEGER);"
                      "CREATE TABLE record(number INTEGER PRIMARY KEY, bytes BLOB, crc INTEGER);"
                      "INSERT INTO meta VALUES('kind','" +
                      kind + "');COMMIT")
                         .c_str());
}

}  // namespace

Result<OpenedJournal> Open(const std::string& path, Memory memory, const OpenOptions& options) {
  if (path.empty()) {
    return NewProblem("no file is named for the database", "set path");
  }
  if (std::optional<Diagnostic> problem = LookAt(path)) return *problem;
  std::error_code error;
  const bool is_new = !std::filesystem::exists(path, error) || std::filesystem::file_size(path, error) == 0;
  sqlite3* database = nullptr;
  if (sqlite3_open_v2(path.c_str(), &database, SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE, nullptr) != SQLITE_OK) {
    const Diagnostic problem = Problem(path, std::string("cannot be opened: ") + sqlite3_errmsg(database));
    sqlite3_close(database);
    return problem;
  }
  auto journal = std::make_unique<SqliteJournal>(path, database);
  sqlite3_extended_result_codes(database, 0);
  if (!journal->Run("PRAGMA locking_mode=EXCLUSIVE") || (is_new && !MakeTables(*journal, memory)) ||
      !journal->Run("PRAGMA journal_mode=WAL") ||
      !journal->Run(options.survive_power ? "PRAGMA synchronous=FULL" : "PRAGMA synchronous=NORMAL") ||
      !journal->Run("BEGIN IMMEDIATE; COMMIT")) {
    return journal->Failure("cannot be opened");
  }
  OpenedJournal opened;
  {
    Statement kind(database, "SELECT value FROM meta WHERE key = 'kind'");
    if (kind.Step() != SQLITE_ROW) return Problem(path, "is damaged", "use a backup; the file was not touched");
    if (kind.Bytes(0) != NameOf(memory)) {
      return Problem(path, "holds a memory of another kind", "name another file; this one was not touched");
    }
  }
  if (options.overwrite && !journal->Run("BEGIN IMMEDIATE; DELETE FROM segment; DELETE FROM record; COMMIT")) {
    return journal->Failure("cannot be emptied");
  }
  if (Result<void> loaded = journal->Load(opened); !loaded) return loaded.error();
  if (!is_new && !IsOfThisVersion(database) && !journal->Run(Text("PRAGMA user_version=", kSchemaVersion).c_str())) {
    return journal->Failure("cannot be written");
  }
  opened.journal = std::move(journal);
  return opened;
}

Result<void> WriteCopy(const std::string& path, Memory memory, std::string_view image) {
  OpenOptions options;
  options.overwrite = true;
  Result<OpenedJournal> opened = Open(path, memory, options);
  if (!opened) return opened.error();
  return opened->journal->Replace(image);
}

std::string_view SqliteVersion() {
  return sqlite3_libversion();
}

}  // namespace soarbox::journal
