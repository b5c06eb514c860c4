// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "language/workspace.h"

namespace soarbox::language {

/// A possible completion of a word.
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
  std::string about;   ///< One or two sentences.
};
struct Proposals {
  Span replaced;  ///< The text that the chosen completion replaces.
  std::vector<Proposal> list;
};

/// Completions at a position. After ^ or a dot: the attributes of the object. These are percepts, commands and their
/// parameters from the world's vocabulary, attributes of the architecture, and attributes that the program's rules use
/// for the same kind of object (for any object if its kind is not known). After an attribute: its values. After <: the
/// variables of the rule. Outside rules: Soar's commands.
Proposals Complete(const Program& program, const Document& document, std::size_t offset);

}  // namespace soarbox::language
