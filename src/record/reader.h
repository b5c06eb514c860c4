// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "record/format.h"
#include "record/header.h"
#include "record/tick_record.h"

namespace soarbox::record {

/// A recording on disk, read at any place. Opening reads the blocks' frames only; going to a tick reads its block.
/// Any bytes may stand in the file: what is not a recording, or a damaged part of one, is an error that says where.
///
/// One thread at a time; the file must not shrink meanwhile.
class Reader {
 public:
  static Result<std::unique_ptr<Reader>> Open(const std::filesystem::path& file);

  const Header& header() const { return header_; }
  const std::filesystem::path& file() const { return path_; }
  std::uint64_t bytes() const { return bytes_; }
  /// The first and last tick that frames are there for. A bounded recording does not begin with tick 0.
  std::uint64_t first_tick() const { return blocks_.front().frame.first_tick; }
  std::uint64_t last_tick() const { return blocks_.back().frame.first_tick + blocks_.back().frame.ticks - 1; }
  /// Not empty if the file ends within a block, or something that is no block follows: what a kill leaves.
  const std::string& ending() const { return ending_; }

  /// The record of a tick. The next ticks in order are read without going back. Fails for a tick that is not there
  /// and for a damaged block; other blocks can still be read. Valid until the next call.
  Result<const TickRecord*> At(std::uint64_t tick);

  /// All that entered from the first tick of the run on, in order; what the whole file holds is read for it.
  Result<std::vector<TickInputs>> Inputs();

 private:
  struct Block {
    BlockFrame frame;
    std::uint64_t payload_at = 0;
  };

  explicit Reader(std::filesystem::path path) : path_(std::move(path)), in_(path_, std::ios::binary) {}
  Result<void> ReadFrames();
  Result<void> LoadPayload(const Block& block);
  Diagnostic Damaged(std::uint64_t at, const std::string& what) const;

  std::filesystem::path path_;
  std::ifstream in_;
  std::uint64_t bytes_ = 0;
  Header header_;
  std::vector<Block> blocks_;  ///< Of ticks, in order.
  std::vector<Block> inputs_;
  std::string ending_;

  // The block that was read last.
  std::string payload_;
  std::size_t loaded_ = static_cast<std::size_t>(-1);  ///< Its index in blocks_.
  std::size_t read_ = 0;                               ///< Bytes of it that record_ is the result of.
  std::uint64_t next_tick_ = 0;
  TickRecord record_;
};

}  // namespace soarbox::record
