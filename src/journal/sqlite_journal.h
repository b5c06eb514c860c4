// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/longterm/journal.h"

/// Journals in SQLite files. SQLite is used only as a container (atomic commits, recovery, locks), not to query
/// memories.
///
/// A file has the application id 0x53424F58 ("SBOX"), the schema version 2 as its user version (1 until the weights of
/// links were stored), and three tables:
///   meta(key, value)               kind: "semantic" or "episodic"
///   segment(number, bytes, crc)    the image, in pieces of 1 MiB
///   record(number, bytes, crc)     records added since then, one row per commit
/// It uses a write-ahead log (WAL). Only one process can open it at a time.
namespace soarbox::journal {

enum class Memory : std::uint8_t { kSemantic, kEpisodic };

struct OpenOptions {
  bool overwrite = false;      ///< Empty it first (append off).
  bool survive_power = false;  ///< Each commit waits for the disk (optimization safety). Otherwise it survives only a
                               ///< kill of the process.
};

/// The contents of a file, and the journal to append to it.
struct OpenedJournal {
  std::unique_ptr<kernel::Journal> journal;
  std::string image;                 ///< Empty if none was ever written.
  std::vector<std::string> records;  ///< Oldest first.
};

/// Opens or creates a file. Fails with the reason if the file is not a database, is damaged, is open in another
/// process, or belongs to another program, another memory or a newer Soarbox. A failure does not change the file.
Result<OpenedJournal> Open(const std::string& path, Memory memory, const OpenOptions& options);

/// Writes a memory's image to a separate file (`smem --backup`). Replaces a file of Soarbox, but no other file.
Result<void> WriteCopy(const std::string& path, Memory memory, std::string_view image);

/// The version of the library, as `smem --stats` shows it.
std::string_view SqliteVersion();

}  // namespace soarbox::journal
