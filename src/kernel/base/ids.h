// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// Indices into an agent's arenas. kNone (all bits set) means "no such thing".
enum class WmeId : std::uint32_t { kNone = 0xFFFFFFFFu };
enum class PreferenceId : std::uint32_t { kNone = 0xFFFFFFFFu };
enum class InstantiationId : std::uint32_t { kNone = 0xFFFFFFFFu };
enum class TokenId : std::uint32_t { kNone = 0xFFFFFFFFu };
/// A rule of an agent, dense from 0 in loading order; numbers of excised rules are used again.
enum class ProductionId : std::uint32_t { kNone = 0xFFFFFFFFu };

template <typename Id>
constexpr std::uint32_t Index(Id id) {
  return static_cast<std::uint32_t>(id);
}

/// A depth in the goal stack: the top state has level 1. 0 means "not linked to a goal".
using GoalLevel = std::uint16_t;

}  // namespace soarbox::kernel
