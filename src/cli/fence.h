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

/// What the commands of strangers may do. They may read below some folders. They may not write or start anything, nor
/// change anything that other agents or your own commands depend on.
///
/// A command is refused unless a table allows it, and of the commands that handle files only the words that open none
/// are allowed. So a new command is refused until it is allowed here. Code that opens a file also asks
/// Interpreter::ResolveForReading or Interpreter::ResolveForWriting.
class Fence {
 public:
  /// Whose commands they are.
  enum class Source : std::uint8_t {
    kFiles,      ///< Of a scenario's files, or carried out by its rules.
    kRecording,  ///< Typed when a run was recorded; they may run agents, as they did then.
    kRulesOnly,  ///< Of files that are only inspected: only rules, and the files that hold them, count.
  };

  explicit Fence(std::vector<std::filesystem::path> folders, Source source = Source::kFiles);

  Source source() const { return source_; }
  /// The same folders for commands of another source.
  Fence For(Source source) const;

  /// True if the file, after all links, is below one of the folders and is no device, pipe or socket.
  bool MayRead(const std::filesystem::path& path) const;

  struct Answer {
    bool carry_out = true;
    std::string refusal;  ///< Why not. Empty with carry_out off: the command is skipped as if it had succeeded.
  };
  /// Whether this command may be carried out. Aliases must be expanded, and the first word must be the command's full
  /// name.
  Answer Ask(std::span<const Word> words) const;

 private:
  std::vector<std::filesystem::path> folders_;  ///< Canonical.
  Source source_;
};

}  // namespace soarbox::cli
