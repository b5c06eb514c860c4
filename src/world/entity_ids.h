// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::world {

/// The sandbox (0), an agent or an object. Agents and objects share one counter, which starts at 1. Numbers are never
/// reused; scripts see the number.
enum class EntityId : std::uint32_t { kSandbox = 0 };
inline constexpr EntityId kNoEntity{0xffffffffu};

/// A node of the scene tree. Numbers are never reused; scripts see only handles.
enum class NodeId : std::uint32_t { kNone = 0, kRoot = 1 };

/// A user-interface component. Numbers are never reused.
enum class UiId : std::uint32_t { kNone = 0 };

/// One animation of one body. Numbers are never reused.
enum class AnimationId : std::uint32_t { kNone = 0 };

inline constexpr std::uint32_t Number(EntityId id) {
  return static_cast<std::uint32_t>(id);
}
inline constexpr std::uint32_t Number(NodeId id) {
  return static_cast<std::uint32_t>(id);
}
inline constexpr std::uint32_t Number(UiId id) {
  return static_cast<std::uint32_t>(id);
}
inline constexpr std::uint32_t Number(AnimationId id) {
  return static_cast<std::uint32_t>(id);
}

}  // namespace soarbox::world
