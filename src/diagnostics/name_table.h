// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <string_view>

namespace soarbox {

/// The name of an enumerator, from a table in the order of the enumeration; empty for values outside the table.
template <typename Enum, std::size_t count>
constexpr const char* NameIn(const char* const (&names)[count], Enum value) {
  const auto index = static_cast<std::size_t>(value);
  return index < count ? names[index] : "";
}

}  // namespace soarbox
