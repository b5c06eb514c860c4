// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bytes/buffered_writer.h"
#include "bytes/byte_stream.h"
#include "record/percept_book.h"
#include "record/tick_record.h"

namespace soarbox::record {

/// What is known of a mind within a block, in the same way by the writer and the reader.
struct MindMemory {
  struct Percept {
    std::uint32_t path = 0;
    std::uint32_t hash = 0;  ///< Of the path; only the writer sets it.
    LastValue last;
  };
  std::string agent;
  std::vector<Percept> percepts;  ///< In the order in which they first changed.
  std::string others;             ///< Its other events in the last tick that had any.
  std::string new_others;         ///< Those of this tick; used while it is written or read.
};

/// Writes what minds did, tick by tick (docs/dev/recording_format.md). Percepts are stored as the number of their path
/// in the block and the difference from their last value; other events as differences from those of an earlier tick, in
/// which the same mind usually did the same with other identifiers.
class MindsEncoder {
 public:
  /// Begins a block.
  void Clear();
  void Write(BufferedWriter& out, const std::vector<MindRecord>& minds);

 private:
  std::uint32_t FindMind(BufferedWriter& out, const std::string& agent, std::uint32_t expected);
  void WriteEvents(BufferedWriter& out, std::uint32_t mind, std::string_view log);
  bool WritePercept(BufferedWriter& out, std::uint32_t mind, bool is_gone, std::string_view path,
                    std::string_view value);
  void WriteOther(BufferedWriter& out, std::string_view event, std::string_view& earlier, std::string& now);

  TextBook names_;    ///< Of the minds, by number.
  TextBook paths_;    ///< Path, attribute and key of percepts, as bytes.
  PairTable places_;  ///< The place of a path in MindMemory::percepts, by mind and path.
  std::vector<MindMemory> minds_;
  std::uint32_t next_percept_ = 0, next_path_ = 0;  ///< What the next percept of the current mind is expected to be.
};

/// Reads the output of MindsEncoder. The input may be any bytes; then `in` may have failed.
class MindsDecoder {
 public:
  /// Begins a block.
  void Clear();
  void Read(ByteReader& in, std::vector<MindRecord>& minds);

 private:
  void ReadEvents(ByteReader& in, MindMemory& mind, std::string& log);
  MindMemory::Percept* ReadPercept(ByteReader& in, MindMemory& mind, bool is_new, std::uint64_t step);

  TextBook paths_;
  std::vector<MindMemory> minds_;
  std::uint32_t next_percept_ = 0, next_path_ = 0;
};

}  // namespace soarbox::record
