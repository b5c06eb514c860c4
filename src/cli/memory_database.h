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

/// What the commands of the two long-term memories do alike: settings, and the file that keeps a memory.
namespace soarbox::cli {

/// One of the two, and what it is called where they differ.
struct LongTermMemory {
  std::string_view group;      ///< Of its settings, and its command: "smem".
  std::string_view title;      ///< In messages about settings: "SMem".
  std::string_view prefix;     ///< Of what it prints: "SMem".
  std::string_view adjective;  ///< "semantic".
  journal::Memory kind = journal::Memory::kSemantic;
};

/// How the database is to be opened, with the path that it has now: folders may be changed before it is.
struct Database {
  bool is_file = false;
  std::string path;
  journal::OpenOptions options;
};
Database DatabaseOf(CommandCall& call, const LongTermMemory& memory);

/// Fails with the problem and, behind a colon, its hint.
bool FailWith(CommandCall& call, const Diagnostic& problem);

/// Whether a setting may take the value: files are written where that is allowed. The command has failed otherwise.
bool MayTake(CommandCall& call, std::string_view setting, const std::string& value);

/// Stores a setting, unless it is one of `closed_only` and the memory is open. The command has failed otherwise.
bool Store(CommandCall& call, const LongTermMemory& memory, const std::string& setting, const std::string& value,
           bool is_open, std::span<const std::string_view> closed_only);

/// Says what becomes of the file that is there when `append` is off.
void WarnOfAppend(CommandCall& call, const LongTermMemory& memory);

/// Takes over what the file holds, and writes there from now on.
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

/// Writes what the memory holds to a file.
template <typename Memory>
bool BackUp(CommandCall& call, const LongTermMemory& names, const Memory& memory, const std::filesystem::path& path,
            const std::string& file) {
  const Result<void> written = journal::WriteCopy(path.string(), names.kind, memory.Image());
  if (!written) return FailWith(call, written.error());
  call.Out(fmt::format("{}| Database backed up to {}\n", names.prefix, file));
  return true;
}

}  // namespace soarbox::cli
