// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/result.h"
#include "kernel/longterm/journal.h"

/// Journals in SQLite files: SQLite is the container (atomic commits, recovery, locks), never the query engine.
///
/// A file has the application id 0x53424F58 ("SBOX"), the schema version 2 as its user version (1 until the
/// weights of links were kept), and three tables:
///   meta(key, value)               kind: "semantic" or "episodic"
///   segment(number, bytes, crc)    the image, in pieces of 1 MiB
///   record(number, bytes, crc)     what was appended since, one row per commit
/// It is written ahead (WAL), by one process at a time.
namespace soarbox::journal {

enum class Memory : std::uint8_t { kSemantic, kEpisodic };

struct OpenOptions {
  bool overwrite = false;      ///< Empty it first (append off).
  bool survive_power = false;  ///< Each commit waits for the disk (optimization safety); else it survives a kill only.
};

/// What a file holds, and the journal to go on with.
struct OpenedJournal {
  std::unique_ptr<kernel::Journal> journal;
  std::string image;                 ///< Empty: none was ever written.
  std::vector<std::string> records;  ///< Oldest first.
};

/// Opens or makes a file. Refuses, with the reason, and leaves untouched: what is not a database, a database of another
/// program, of another memory or of a newer Soarbox, a damaged one, and one that another process has open.
Result<OpenedJournal> Open(const std::string& path, Memory memory, const OpenOptions& options);

/// Writes a memory's image to a file of its own (`smem --backup`). Replaces a file of Soarbox, refuses any other.
Result<void> WriteCopy(const std::string& path, Memory memory, std::string_view image);

/// The version of the library, as `smem --stats` shows it.
std::string_view SqliteVersion();

}  // namespace soarbox::journal
