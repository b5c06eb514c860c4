// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "sml/wire/element.h"

namespace soarbox::wire {

/// One element that a client adds to the input (or one that it takes away: only the tag counts then). The text belongs
/// to whoever made this.
struct InputWme {
  enum class Type : std::uint8_t { kString, kInt, kDouble, kId };

  bool add = true;
  long long tag = 0;
  /// The parent, as the client or the kernel names it. May be left out if there is an id_hint.
  std::string_view id;
  long long id_key = 0;       ///< The same as one number (IdentifierKey), if the kernel named it.
  std::uint32_t id_hint = 0;  ///< The kernel's handle of the parent when the client heard of it; 0 if it never did.
  std::string_view attribute;
  Type type = Type::kString;
  std::string_view text;  ///< A string, or the name of an identifier.
  long long integer = 0;
  double real = 0.0;
};

/// Adds <wme action="add" .../> or <wme action="remove" tag="..."/> to a command.
void AddWme(Element& command, const InputWme& wme);
/// Reads such an element; what is missing or is no number is empty or 0. It points into the element.
InputWme ReadWme(const Element& element);

}  // namespace soarbox::wire
