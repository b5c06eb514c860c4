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
  std::uint32_t ticks_per_block = 30;  ///< The most ticks that are lost when the program is killed.
  std::uint64_t limit_bytes = 0;       ///< 0: none. At the limit the older half of the frames goes; all inputs stay.
  std::string manifest = {};           ///< ManifestOf (manifest.h), kept in a block of its own; empty: none.
};

/// Writes a recording, block by block. A written block never changes, so you can read the file meanwhile, and a program
/// that is killed leaves all complete blocks.
///
/// One thread at a time. The destructor writes what is waiting.
class Writer {
 public:
  /// Creates the file, replacing an old one. Fails if it cannot be made or written; the error names it.
  static Result<std::unique_ptr<Writer>> Create(const std::filesystem::path& file, const Header& header,
                                                const WriterSettings& settings = {});
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Adds the next tick. Fails when the disk is full or the like. The recording then ends with the last complete block
  /// and accepts nothing more; each further call returns the same error.
  Result<void> Add(const TickRecord& tick);
  /// The same; `tick` is then an earlier one, whose memory may serve again.
  Result<void> AddAndSwap(TickRecord& tick);
  /// For a recording that does not start at tick 0: the inputs before its first tick. Call before the first Add.
  Result<void> AddEarlierInputs(const std::vector<TickInputs>& earlier);
  /// Writes the ticks of the unfinished block.
  Result<void> Flush();

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
  std::string header_block_;  ///< With the manifest.
  WriterSettings settings_;
  std::uint64_t bytes_ = 0;
  std::optional<Diagnostic> failure_;

  BlockBuilder builder_;
  std::string new_inputs_;    ///< Of the ticks of the current block.
  std::deque<Block> blocks_;  ///< Of ticks, on disk.
  std::string all_inputs_;    ///< Of a bounded recording, those of all ticks on disk, for when it drops some.
};

}  // namespace soarbox::record
