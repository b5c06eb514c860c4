// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "debugger/memory.h"
#include "explain/inspector.h"

namespace soarbox::debugger {

/// A command on the output link.
struct CommandRow {
  std::string name;
  std::string id;  ///< Its identifier; empty if the command is a constant.
  std::uint64_t timetag = 0;
  std::vector<MemoryRow> parameters;  ///< Without the answer of the world.
  std::string status;                 ///< "complete", "error" or "interrupted"; "under way" if the command has no
                                      ///< status yet.
  std::string reason;                 ///< Why it failed, for an error.
  double progress = -1;               ///< 0 to 1; negative if it is not reported.
};

/// " ^within 1.2 ^waypoint north".
std::string ParameterText(const CommandRow& command);

struct IoView {
  MemoryObject input, output;
  std::vector<CommandRow> commands;  ///< Newest first.
};

IoView LookAtIo(explain::Inspector& mind, const MemoryChanges& changes = {});

std::string ToText(const IoView& view);

}  // namespace soarbox::debugger
