// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "cli/setting_store.h"
#include "diagnostics/problem.h"
#include "journal/sqlite_journal.h"
#include "kernel/longterm/journal.h"

/// Functions that the commands of both long-term memories use: settings, and the file that stores a memory.
namespace soarbox::cli {

/// One of the two memories, with the names that differ.
struct LongTermMemory {
  std::string_view group;      ///< Group of its settings, and name of its command: "smem".
  std::string_view title;      ///< Name in messages about settings: "SMem".
  std::string_view prefix;     ///< Prefix of its output: "SMem".
  std::string_view adjective;  ///< "semantic".
  journal::Memory kind = journal::Memory::kSemantic;
};

/// How to open the database. The path is absolute, because the current folder may change before it is opened.
struct Database {
  bool is_file = false;
  std::string path;
  journal::OpenOptions options;
};
Database DatabaseOf(CommandCall& call, const LongTermMemory& memory);

/// Fails with the problem, a colon and its hint.
bool FailWith(CommandCall& call, const Diagnostic& problem);

/// Whether a setting may have this value: with a fence, the database must stay in memory. Otherwise fails the command.
bool MayTake(CommandCall& call, std::string_view setting, const std::string& value);

/// Stores a setting. Fails the command if the setting or the value is invalid, or if the memory is open and the setting
/// is one of `closed_only`.
bool Store(CommandCall& call, const LongTermMemory& memory, const std::string& setting, const std::string& value,
           bool is_open, std::span<const std::string_view> closed_only);

/// Warns about what happens to an existing file when `append` is off.
void WarnOfAppend(CommandCall& call, const LongTermMemory& memory);

/// Loads the contents of the file, and stores changes there from now on.
template <typename Memory>
Result<void> LoadFrom(Memory& memory, const Database& database, journal::Memory kind) {
  Result<journal::OpenedJournal> opened = journal::Open(database.path, kind, database.options);
  if (!opened) return opened.error();
  if (!memory.Load(opened->image, opened->records)) {
    return NewProblem(database.path + " is damaged: its records make no sense",
                      "use a backup; the file was not touched");
  }
  memory.SetJournal(std::move(opened->journal));
  return {};
}

/// Writes the contents of the memory to a file.
template <typename Memory>
bool BackUp(CommandCall& call, const LongTermMemory& names, const Memory& memory, const std::filesystem::path& path,
            const std::string& file) {
  const Result<void> written = journal::WriteCopy(path.string(), names.kind, memory.Image());
  if (!written) return FailWith(call, written.error());
  call.Out(fmt::format("{}| Database backed up to {}\n", names.prefix, file));
  return true;
}

}  // namespace soarbox::cli
