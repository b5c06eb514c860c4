// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "debugger/json.h"
#include "debugger/memory.h"
#include "explain/inspector.h"

namespace soarbox::debugger {

/// A command on the output link.
struct CommandRow {
  std::string name;
  std::string id;  ///< Its identifier; empty if it is a plain value.
  std::uint64_t timetag = 0;
  std::vector<MemoryRow> parameters;  ///< Without the world's answer.
  std::string status;                 ///< "complete", "error", "interrupted"; "under way" without one.
  std::string reason;                 ///< Of an error.
  double progress = -1;               ///< 0 to 1; less than 0: not told.
};

struct IoView {
  MemoryObject input, output;
  std::vector<CommandRow> commands;  ///< Newest first.
};

IoView LookAtIo(explain::Inspector& mind, const MemoryChanges& changes = {});

std::string ToText(const IoView& view);
Json ToJson(const IoView& view);

}  // namespace soarbox::debugger
