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

/// Restrictions for commands of strangers. Such commands may read below certain folders. They may not write or start
/// anything, and not change anything that other agents or the user's own commands depend on.
///
/// A command is refused unless a table allows it, so a new command is refused until it is added to the table. Of the
/// commands of long-term memory, only the words in another table are allowed: those that open no file. Code that opens
/// a file must also call Interpreter::ResolveForReading or Interpreter::ResolveForWriting.
class Fence {
 public:
  /// Where the commands come from.
  enum class Source : std::uint8_t {
    kFiles,      ///< Files of a scenario, or commands that its rules execute.
    kRecording,  ///< Commands that were typed when a run was recorded. They may run agents, as they did then.
    kRulesOnly,  ///< Files that are only inspected. Only rules and commands that load files are executed.
  };

  explicit Fence(std::vector<std::filesystem::path> folders, Source source = Source::kFiles);

  Source source() const { return source_; }
  /// A copy with the same folders for commands of another source.
  Fence For(Source source) const;

  /// Whether a file, after resolving links, is below one of the folders and is not a device, pipe or socket.
  bool MayRead(const std::filesystem::path& path) const;

  struct Answer {
    bool carry_out = true;
    std::string refusal;  ///< The reason. Empty if carry_out is false and the command is skipped without an error.
  };
  /// Whether a command may be executed. Aliases must be expanded, and the first word must be the command's full name.
  Answer Ask(std::span<const Word> words) const;

 private:
  std::vector<std::filesystem::path> folders_;  ///< Canonical.
  Source source_;
};

}  // namespace soarbox::cli
