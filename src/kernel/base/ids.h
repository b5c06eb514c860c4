// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>

namespace soarbox::kernel {

/// A handle of a record of an agent (see RecordArena). Only the part that owns the record accesses its contents; other
/// parts pass the handle to the owner. kNone means "no record".
template <typename Record>
struct RecordId {
  Record* record = nullptr;

  static const RecordId kNone;
  friend constexpr bool operator==(RecordId, RecordId) = default;
};
template <typename Record>
inline constexpr RecordId<Record> RecordId<Record>::kNone{};

using PreferenceId = RecordId<struct Preference>;
using InstantiationId = RecordId<struct Instantiation>;
/// A slot: the preferences and elements of one identifier and attribute.
using SlotId = RecordId<struct Slot>;
/// A link between identifiers (links.h).
using LinkId = RecordId<struct Link>;

/// Indices into an agent's arenas. kNone (all bits set) means "none".
enum class WmeId : std::uint32_t { kNone = 0xFFFFFFFFu };
enum class TokenId : std::uint32_t { kNone = 0xFFFFFFFFu };
/// A rule of an agent. Numbers are dense from 0. New rules first reuse the numbers of excised ones.
enum class ProductionId : std::uint32_t { kNone = 0xFFFFFFFFu };

template <typename Id>
constexpr std::uint32_t Index(Id id) {
  return static_cast<std::uint32_t>(id);
}

/// A depth in the goal stack. The top state has level 1. 0 means "not linked to a goal".
using GoalLevel = std::uint16_t;

}  // namespace soarbox::kernel
