// SPDX-License-Identifier: BSD-2-Clause
#include "journal/sqlite_journal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sqlite3.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <random>
#include <string>

#include "bytes/byte_stream.h"
namespace soarbox::journal {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using Bytes = std::string;

class SqliteJournal : public ::testing::Test {
 protected:
  SqliteJournal() {
    folder_ = fs::path(::testing::TempDir()) / ("journal-" + std::to_string(getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~SqliteJournal() override { fs::remove_all(folder_); }
  std::string Path(const std::string& name) const { return (folder_ / name).string(); }
  static OpenedJournal OpenOr(const std::string& path, const OpenOptions& options = {}) {
    Result<OpenedJournal> opened = Open(path, Memory::kSemantic, options);
    EXPECT_TRUE(opened.ok()) << opened.error().message;
    return opened ? std::move(*opened) : OpenedJournal();
  }
  static std::string Refusal(const std::string& path, Memory memory = Memory::kSemantic) {
    const Result<OpenedJournal> opened = Open(path, memory, {});
    return opened ? std::string() : opened.error().message;
  }
  static std::string Contents(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  fs::path folder_;
};

Bytes Record(std::uint8_t first, std::size_t size = 3) {
  Bytes bytes(size, '\0');
  std::iota(bytes.begin(), bytes.end(), first);
  return bytes;
}

TEST_F(SqliteJournal, WhatWasCommittedIsThereAgainInOrder) {
  {
    OpenedJournal opened = OpenOr(Path("a.db"));
    opened.journal->Append(Record(1));
    opened.journal->Append(Record(9, 200));
    ASSERT_TRUE(opened.journal->Commit().ok());
    opened.journal->Append(Record(5));  // Committed on closing.
  }
  const OpenedJournal opened = OpenOr(Path("a.db"));
  EXPECT_TRUE(opened.image.empty());
  EXPECT_THAT(opened.records, ::testing::ElementsAre(Record(1), Record(9, 200), Record(5)));
}

TEST_F(SqliteJournal, AnImageTakesThePlaceOfTheRecords) {
  {
    OpenedJournal opened = OpenOr(Path("a.db"));
    opened.journal->Append(Record(1));
    ASSERT_TRUE(opened.journal->Commit().ok());
    ASSERT_TRUE(opened.journal->Replace(Record(0, 3 << 20)).ok());
    opened.journal->Append(Record(2));
  }
  const OpenedJournal opened = OpenOr(Path("a.db"));
  EXPECT_EQ(opened.image, Record(0, 3 << 20));
  EXPECT_THAT(opened.records, ::testing::ElementsAre(Record(2)));
}

TEST_F(SqliteJournal, OverwritingEmptiesTheFile) {
  { OpenOr(Path("a.db")).journal->Append(Record(1)); }
  OpenOptions options;
  options.overwrite = true;
  { EXPECT_TRUE(OpenOr(Path("a.db"), options).records.empty()); }
  EXPECT_TRUE(OpenOr(Path("a.db")).records.empty());
}

TEST_F(SqliteJournal, ForeignFilesAreRefusedAndNotTouched) {
  std::ofstream(Path("text.db")) << std::string(4000, 'x');
  std::ofstream(Path("short.db")) << "SQLite format 3";
  std::string foreign("SQLite format 3\0", 16);
  foreign.resize(4096);
  std::ofstream(Path("foreign.db"), std::ios::binary) << foreign;
  fs::create_directory(Path("folder.db"));
  for (const char* name : {"text.db", "short.db", "foreign.db"}) {
    const std::string before = Contents(Path(name));
    EXPECT_THAT(Refusal(Path(name)), HasSubstr(name));
    EXPECT_EQ(Contents(Path(name)), before);
  }
  EXPECT_THAT(Refusal(Path("text.db")), HasSubstr("is not a database"));
  EXPECT_THAT(Refusal(Path("foreign.db")), HasSubstr("of another program"));
  EXPECT_THAT(Refusal(Path("folder.db")), HasSubstr("is a folder"));
  EXPECT_THAT(Refusal(Path("no/such/folder.db")), HasSubstr("cannot be opened"));
  EXPECT_THAT(Refusal(""), HasSubstr("no file is named"));
  { OpenOr(Path("a.db")); }
  EXPECT_THAT(Refusal(Path("a.db"), Memory::kEpisodic), HasSubstr("another kind"));
}

/// Databases with the layout of Soar 9.6 are recognised by their tables, even in a folder with an unusual name.
TEST_F(SqliteJournal, SoarsOwnFilesAreRefusedWithAWayToReadThem) {
  fs::create_directory(Path("50% #?"));
  const std::pair<Memory, std::string> kinds[] = {{Memory::kSemantic, "smem"}, {Memory::kEpisodic, "epmem"}};
  for (const auto& [memory, prefix] : kinds) {
    const std::string path = Path("50% #?/" + prefix + ".db");
    sqlite3* database = nullptr;
    ASSERT_EQ(sqlite3_open(path.c_str(), &database), SQLITE_OK);
    const std::string tables = "CREATE TABLE versions(system TEXT PRIMARY KEY, version_number TEXT);CREATE TABLE " +
                               prefix +
                               "_persistent_variables(variable_id INTEGER PRIMARY KEY, variable_value NUMERIC)";
    ASSERT_EQ(sqlite3_exec(database, tables.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
    sqlite3_close(database);
    const std::string before = Contents(path);
    for (const bool overwrite : {false, true}) {
      OpenOptions options;
      options.overwrite = overwrite;
      const Result<OpenedJournal> opened = Open(path, memory, options);
      ASSERT_FALSE(opened.ok());
      EXPECT_THAT(opened.error().message, HasSubstr(path));
      EXPECT_THAT(opened.error().message, HasSubstr("that Soar wrote"));
      EXPECT_THAT(opened.error().hint, HasSubstr(memory == Memory::kSemantic ? "smem --export" : "another file"));
    }
    EXPECT_EQ(Contents(path), before);
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(Path("50% #?")), fs::directory_iterator()), 2);
}

TEST_F(SqliteJournal, DamageIsFoundAndNotMended) {
  {
    OpenedJournal opened = OpenOr(Path("a.db"));
    ASSERT_TRUE(opened.journal->Replace(Record(0, 20000)).ok());
    opened.journal->Append(Record(7, 5000));
  }
  const std::string whole = Contents(Path("a.db"));
  std::mt19937 random(1);
  int refused = 0;
  for (int n = 0; n < 40; ++n) {
    std::string spoilt = whole;
    for (int k = 0; k < 8; ++k) spoilt[100 + random() % (spoilt.size() - 100)] ^= static_cast<char>(1 + random() % 255);
    std::ofstream(Path("b.db"), std::ios::binary) << spoilt;
    const Result<OpenedJournal> opened = Open(Path("b.db"), Memory::kSemantic, {});
    if (opened) {
      // The file is readable if only unused bytes were changed; the contents must then be the same.
      EXPECT_EQ(opened->image, Record(0, 20000));
    } else {
      ++refused;
      EXPECT_THAT(opened.error().message, HasSubstr("b.db"));
    }
    fs::remove(Path("b.db-wal"));
    fs::remove(Path("b.db-shm"));
  }
  EXPECT_GT(refused, 20);
}

TEST_F(SqliteJournal, ASecondProcessIsTurnedAway) {
  int ready[2], done[2];
  ASSERT_EQ(pipe(ready), 0);
  ASSERT_EQ(pipe(done), 0);
  const pid_t child = fork();
  if (child == 0) {
    close(done[1]);
    Result<OpenedJournal> opened = Open(Path("a.db"), Memory::kSemantic, {});
    if (!opened) _exit(1);
    opened->journal->Append(Record(1));
    if (!opened->journal->Commit().ok()) _exit(2);
    char byte = 0;
    if (write(ready[1], &byte, 1) != 1) _exit(3);
    if (read(done[0], &byte, 1) < 0) _exit(4);  // Blocks until the other end is closed.
    _exit(0);
  }
  close(ready[1]);
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_THAT(Refusal(Path("a.db")), HasSubstr("in use by another process"));
  close(done[1]);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  for (const int end : {ready[0], done[0]}) close(end);
  // Another user in the same process is refused, too.
  const OpenedJournal opened = OpenOr(Path("a.db"));
  EXPECT_THAT(opened.records, ::testing::ElementsAre(Record(1)));
  EXPECT_THAT(Refusal(Path("a.db")), HasSubstr("in use by another process"));
}

TEST_F(SqliteJournal, AFullDiskKeepsWhatIsNewUntilThereIsRoom) {
  OpenedJournal opened = OpenOr(Path("a.db"));
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &before), 0);
  signal(SIGXFSZ, SIG_IGN);
  rlimit limit = before;
  limit.rlim_cur = 64 * 1024;
  ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &limit), 0);
  opened.journal->Append(Record(3, 500000));
  const Result<void> failed = opened.journal->Commit();
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_FALSE(failed.ok());
  EXPECT_TRUE(opened.journal->Commit().ok());
  opened.journal.reset();
  EXPECT_THAT(OpenOr(Path("a.db")).records, ::testing::ElementsAre(Record(3, 500000)));
}

/// The child commits numbered records, and sometimes an image of all, and reports each number after its commit.
[[noreturn]] void Write(const std::string& path, int said) {
  Result<OpenedJournal> opened = Open(path, Memory::kSemantic, {});
  if (!opened) _exit(2);
  std::uint64_t count = 0;
  if (!opened->image.empty()) count = ByteReader(opened->image).Fixed64();
  count += opened->records.size();
  for (;; ++count) {
    std::string record;
    ByteWriter(record).Fixed64(count);
    opened->journal->Append(record);
    if (!opened->journal->Commit().ok()) _exit(3);
    if (count % 50 == 49) {
      std::string image;
      ByteWriter(image).Fixed64(count + 1);
      if (!opened->journal->Replace(image).ok()) _exit(4);
    }
    if (write(said, &count, sizeof(count)) != sizeof(count)) _exit(0);
  }
}

TEST_F(SqliteJournal, KilledAtAnyInstantTheFileHoldsAllThatWasCommitted) {
  std::mt19937 random(7);
  for (int kill_number = 0; kill_number < 100; ++kill_number) {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) Write(Path("a.db"), ends[1]);
    close(ends[1]);
    std::uint64_t last = 0, number = 0;
    const int before_kill = static_cast<int>(random() % 30);
    for (int n = 0; n < before_kill && read(ends[0], &number, sizeof(number)) == sizeof(number); ++n) last = number;
    usleep(random() % 300);
    kill(child, SIGKILL);
    while (read(ends[0], &number, sizeof(number)) == sizeof(number)) last = number;
    close(ends[0]);
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the child ended by itself with " << WEXITSTATUS(status);
    const OpenedJournal opened = OpenOr(Path("a.db"));
    const std::uint64_t first = opened.image.empty() ? 0 : ByteReader(opened.image).Fixed64();
    for (std::size_t n = 0; n < opened.records.size(); ++n) {
      ASSERT_EQ(ByteReader(opened.records[n]).Fixed64(), first + n);
    }
    ASSERT_GE(first + opened.records.size(), last == 0 ? 0 : last + 1);
  }
}

}  // namespace
}  // namespace soarbox::journal
