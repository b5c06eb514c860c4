// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// The elements of ^smem or ^epmem of a state: (state ^smem link), (link ^command command), (link ^result result).
struct MemoryLink {
  Symbol link, command, result;
  WmeId present_id = WmeId::kNone;  ///< ^epmem: the element (link ^present-id n).
};

}  // namespace soarbox::kernel
