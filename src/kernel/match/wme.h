// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "kernel/base/ids.h"
#include "kernel/base/plain_vector.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/rule_kinds.h"

namespace soarbox::kernel {

/// A working memory element. It contains only the fields that the match reads; the data for support, input and goal
/// dependency sets are in separate arrays (working_memory.h).
struct Wme {
  Symbol id;
  Symbol attribute;
  Symbol value;
  bool acceptable = false;  ///< The element of an acceptable preference: (S1 ^operator O1 +).
  bool live = false;        ///< False after its removal, until it is reused.
  std::uint64_t timetag = 0;
};

/// One of an element's three symbols.
inline Symbol FieldOf(const Wme& wme, Field field) {
  static_assert(offsetof(Wme, id) == 0 && offsetof(Wme, attribute) == 4 && offsetof(Wme, value) == 8 &&
                static_cast<int>(Field::kValue) == 2 && sizeof(Symbol) == 4);
  std::uint32_t bits;
  std::memcpy(&bits, reinterpret_cast<const char*>(&wme) + 4 * static_cast<std::size_t>(field), sizeof(bits));
  return Symbol::FromBits(bits);
}

inline std::uint32_t BitsOf(const Wme& wme, Field field) {
  return FieldOf(wme, field).bits();
}

/// The elements of one agent, by WmeId. Indices of removed elements are reused, but only after the phase of the
/// removal.
using WmeTable = PlainVector<Wme>;

}  // namespace soarbox::kernel
