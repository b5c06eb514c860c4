// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

/// What a test program that links soarbox_counted_allocations knows of its own `new` and `delete`, on one thread.
namespace soarbox::allocations {

/// How often memory was asked for and given since the program began.
std::int64_t Count();
/// How many of these are still held.
std::int64_t Live();

enum class Refusal : std::uint8_t { kOnce, kFromThenOn };
/// This many allocations succeed; the next one throws std::bad_alloc: once, or each from then on.
void RefuseAfter(std::int64_t allocations, Refusal refusal);
/// Nothing is refused any more.
void Allow();

}  // namespace soarbox::allocations
