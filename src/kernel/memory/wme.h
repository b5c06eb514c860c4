// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// A working memory element. Only what the match reads stands in here; what support, input and goal dependency sets
/// need lies in arrays beside it (working_memory.h).
struct Wme {
  Symbol id;
  Symbol attribute;
  Symbol value;
  bool acceptable = false;  ///< The element of an acceptable preference: (S1 ^operator O1 +).
  bool live = false;        ///< False once removed and not yet used again.
  std::uint64_t timetag = 0;
};

/// The elements of one agent, by WmeId. Indices of removed elements are used again, but not before the phase ends in
/// which they were removed.
using WmeTable = std::vector<Wme>;

}  // namespace soarbox::kernel
