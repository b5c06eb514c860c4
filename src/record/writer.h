// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "record/block_codec.h"
#include "record/header.h"
#include "record/tick_record.h"

namespace soarbox::record {

struct WriterSettings {
  std::uint32_t ticks_per_block = 30;  ///< Maximum number of ticks that are lost if the program is killed.
  std::uint64_t limit_bytes = 0;       ///< Maximum size of the file; 0: no limit. At the limit, the older half of the
                                       ///< ticks is dropped; all inputs stay.
  std::string manifest = {};           ///< The manifest (ManifestOf in manifest.h), stored in a separate block; empty:
                                       ///< none.
};

/// Writes a recording, block by block. A block that was written never changes, so the file can be read meanwhile. A
/// program that is killed leaves all complete blocks.
///
/// Not thread-safe. The destructor writes the remaining ticks.
class Writer {
 public:
  /// Creates the file; replaces an existing one. Fails if it cannot be created or written; the error names it.
  static Result<std::unique_ptr<Writer>> Create(const std::filesystem::path& file, const Header& header,
                                                const WriterSettings& settings = {});
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Adds the next tick. Fails if the disk is full or a similar error occurs. The recording then ends with the last
  /// complete block; each further call returns the same error.
  Result<void> Add(const TickRecord& tick);
  /// The same. On return, `tick` contains an earlier tick, whose memory the caller can reuse.
  Result<void> AddAndSwap(TickRecord& tick);
  /// For a recording that begins after tick 0: writes the inputs before its first tick. Call it before the first Add.
  Result<void> AddEarlierInputs(const std::vector<TickInputs>& earlier);
  /// Writes the ticks of the incomplete block.
  Result<void> Flush();
  /// Stores how long the run waited. Call it after the last tick and Flush.
  Result<void> AddWaits(const Waits& waits);

  std::uint64_t bytes() const { return bytes_; }

 private:
  struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  using File = std::unique_ptr<std::FILE, CloseFile>;
  struct Block {
    std::uint64_t begin = 0;
    std::uint64_t bytes = 0;
  };

  Writer(File file, std::filesystem::path path, const Header& header, const WriterSettings& settings);
  Result<void> Write(const std::string& bytes);
  Result<void> WriteInputsSoFar();
  Result<void> DropOlderHalf();
  Result<void> Failed(const char* doing);

  File file_;
  std::filesystem::path path_;
  std::string header_block_;  ///< Includes the manifest's block.
  WriterSettings settings_;
  std::uint64_t bytes_ = 0;
  std::optional<Diagnostic> failure_;

  BlockBuilder builder_;
  std::string new_inputs_;    ///< Inputs of the ticks of the current block.
  std::deque<Block> blocks_;  ///< Blocks of ticks in the file.
  std::string all_inputs_;    ///< For a bounded recording: inputs of all ticks in the file, needed when ticks are
                              ///< dropped.
};

}  // namespace soarbox::record
