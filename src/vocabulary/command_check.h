// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "vocabulary/percept.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::vocabulary {

/// A command of a mind on its output link.
struct SaidCommand {
  std::uint64_t tag = 0;  ///< Identifies the command while it is on the output link.
  std::string name;
  PerceptList parameters;
  bool is_object = true;      ///< False: its value is a constant instead of an identifier.
  bool is_too_large = false;  ///< It has more parameters than are read; none of them are read.
};

/// An error in a command that is found before it is executed; `reason` is empty if there is none.
struct CommandFault {
  std::string reason;
  std::string parameter;
  std::string text;  ///< For users, with what to do: "^within of seek is 500: it takes a number (m, 0.1 to 100)".

  std::string brief = {};  ///< The same, without the contents of an object that is given instead of a name; empty if
                           ///< there is no such object.

  bool ok() const { return reason.empty(); }
};

/// Whether the reason of a failure is the form of the command, which CheckCommand finds, and not the state of the
/// world.
bool IsFaultOfForm(std::string_view reason);

/// Checks the name and the parameters of a command against the table.
CommandFault CheckCommand(const SaidCommand& command);

}  // namespace soarbox::vocabulary
