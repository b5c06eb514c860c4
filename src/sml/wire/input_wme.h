// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>

#include "sml/wire/element.h"

namespace soarbox::wire {

/// An element that a client adds to the input, or removes from it (then only the tag is used). The caller owns the
/// text.
struct InputWme {
  enum class Type : std::uint8_t { kString, kInt, kDouble, kId };

  bool add = true;
  long long tag = 0;
  /// The parent, by the name that the client or the kernel uses. May be empty if id_hint is set.
  std::string_view id;
  long long id_key = 0;       ///< The name as a number (IdentifierKey), if the kernel created it.
  std::uint32_t id_hint = 0;  ///< The kernel's handle of the parent, as sent to the client; 0 if it never was.
  std::string_view attribute;
  Type type = Type::kString;
  std::string_view text;  ///< A string, or the name of an identifier.
  long long integer = 0;
  double real = 0.0;
};

/// Adds <wme action="add" .../> or <wme action="remove" tag="..."/> to a command.
void AddWme(Element& command, const InputWme& wme);
/// Reads such an element. Missing or invalid numbers are 0, missing texts are empty. The result refers to the element.
InputWme ReadWme(const Element& element);

}  // namespace soarbox::wire
