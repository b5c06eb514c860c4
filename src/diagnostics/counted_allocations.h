// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

/// For test programs that link soarbox_counted_allocations: counts and control of `new` and `delete`, on one thread.
namespace soarbox::allocations {

/// Number of allocations since the program began.
std::int64_t Count();
/// Number of allocations that were not freed.
std::int64_t Live();

enum class Refusal : std::uint8_t { kOnce, kFromThenOn };
/// Lets this many allocations succeed. The next one throws std::bad_alloc, either only once or each from then on.
void RefuseAfter(std::int64_t allocations, Refusal refusal);
/// Ends RefuseAfter: all allocations succeed again.
void Allow();

}  // namespace soarbox::allocations
