// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/tokens.h"

namespace soarbox::cli {

/// What the commands of strangers may do. They read below some folders, and write nothing, start nothing, and change
/// nothing that other agents or the user's own commands go by.
///
/// Every command is refused unless a table allows it, and of those that know files only the words that open none: a
/// command that is new is refused until it is allowed here. All that opens a file asks besides
/// (Interpreter::ResolveForReading, Interpreter::ResolveForWriting).
class Fence {
 public:
  /// Whose commands they are.
  enum class Source : std::uint8_t {
    kFiles,      ///< Of a scenario's files, and of those that its rules carry out.
    kRecording,  ///< Typed when a run was recorded; they may run agents, as they did then.
    kRulesOnly,  ///< Of files that are looked over: only rules, and the files that they lie in, count.
  };

  explicit Fence(std::vector<std::filesystem::path> folders, Source source = Source::kFiles);

  Source source() const { return source_; }
  /// The same folders for commands of another source.
  Fence For(Source source) const;

  /// True if the file, all links followed, lies below one of the folders and is no device, pipe or socket.
  bool MayRead(const std::filesystem::path& path) const;

  struct Answer {
    bool carry_out = true;
    std::string refusal;  ///< Why not; empty with carry_out off: it is passed over, as if it had succeeded.
  };
  /// Whether this command may be carried out. The words' aliases are expanded, and the first is the command's full
  /// name.
  Answer Ask(std::span<const Word> words) const;

 private:
  std::vector<std::filesystem::path> folders_;  ///< Canonical.
  Source source_;
};

}  // namespace soarbox::cli
