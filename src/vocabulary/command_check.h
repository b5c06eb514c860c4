// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>

#include "vocabulary/percept.h"
#include "vocabulary/vocabulary.h"

namespace soarbox::vocabulary {

/// A command as a mind put it on its output link.
struct SaidCommand {
  std::uint64_t tag = 0;  ///< Names it for as long as it stays there.
  std::string name;
  PerceptList parameters;
  bool is_object = true;      ///< False: the rules gave the attribute a constant instead of an identifier.
  bool is_too_large = false;  ///< More stands below it than is read; nothing of it is.
};

/// What is wrong with a command before anybody tries it; `reason` is empty if nothing is.
struct CommandFault {
  std::string reason;
  std::string parameter;
  std::string text;  ///< For people, with what to do: "^within is 500: it takes m, 0.1 to 100".

  bool ok() const { return reason.empty(); }
};

/// Checks the name and the parameters against the table.
CommandFault CheckCommand(const SaidCommand& command);

}  // namespace soarbox::vocabulary
