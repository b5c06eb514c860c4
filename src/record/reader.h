// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "record/block_codec.h"
#include "record/tick_source.h"

namespace soarbox::record {

/// Whether a file begins like a recording.
bool IsRecording(const std::filesystem::path& file);

/// Reads a recording on disk, with random access. Opening reads only the frames of the blocks; going to a tick reads
/// its block. The file may contain any bytes. If it is not a recording, or a part is damaged, the error says where.
///
/// Not thread-safe. The file must not become shorter meanwhile.
class Reader final : public TickSource {
 public:
  static Result<std::unique_ptr<Reader>> Open(const std::filesystem::path& file);

  const Header& header() const override { return header_; }
  std::string name() const override { return path_.string(); }
  const std::filesystem::path& file() const { return path_; }
  std::uint64_t bytes() const { return bytes_; }
  /// May be greater than 0 in a bounded recording.
  std::uint64_t first_tick() const override { return blocks_.front().frame.first_tick; }
  std::uint64_t last_tick() const override { return blocks_.back().frame.first_tick + blocks_.back().frame.ticks - 1; }
  /// Not empty if the file ends within a block, or if bytes after the last block are not a block. This happens if the
  /// program that wrote the file was killed.
  const std::string& ending() const { return ending_; }

  /// How long the run waited for the recording; all 0 if it did not wait, or if it was killed.
  const Waits& waits() const { return waits_; }

  Result<const TickRecord*> At(std::uint64_t tick) override;
  /// Reads the entire file.
  Result<std::vector<TickInputs>> Inputs() override;

 private:
  struct Block {
    BlockFrame frame;
    std::uint64_t payload_at = 0;
  };

  explicit Reader(std::filesystem::path path) : path_(std::move(path)), in_(path_, std::ios::binary) {}
  Result<void> ReadFrames();
  Result<std::string> ReadPayload(const Block& block);
  Diagnostic Damaged(std::uint64_t at, const std::string& what) const;

  std::filesystem::path path_;
  std::ifstream in_;
  std::uint64_t bytes_ = 0;
  Header header_;
  std::vector<Block> blocks_;  ///< Blocks of ticks, in order.
  std::vector<Block> inputs_;
  std::string ending_;
  Waits waits_;
  BlockCursor cursor_;
};

}  // namespace soarbox::record
