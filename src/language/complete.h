// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "language/workspace.h"

namespace soarbox::language {

/// How a word may go on.
struct Proposal {
  enum class Kind : std::uint8_t {
    kAttribute,
    kPercept,
    kCommand,
    kValue,
    kOperator,
    kVariable,
    kFunction,
    kSoarCommand
  };
  Kind kind = Kind::kAttribute;
  std::string text;
  std::string detail;  ///< "m, 0 to 100", "used 12 times".
  std::string about;   ///< A sentence or two.
};
struct Proposals {
  Span replaced;  ///< What the chosen text takes the place of.
  std::vector<Proposal> list;
};

/// What may stand at a place: behind ^ or a dot the attributes of the object there (percepts, commands and their
/// parameters from the world's vocabulary, what the architecture gives, and what the program's rules use on the same
/// kind of object, or on any if none is known); behind an attribute its values; behind < the rule's variables; outside
/// of rules Soar's commands.
Proposals Complete(const Program& program, const Document& document, std::size_t offset);

}  // namespace soarbox::language
