// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"
#include "sim/run_event.h"
#include "world/scene_snapshot.h"

namespace soarbox::record {

/// How much of a run is recorded. Each level includes those before it.
enum class Level : std::uint8_t {
  kWorld,      ///< Scenes, events, inputs and state hashes.
  kDecisions,  ///< Also percepts, commands, and the operators and impasses of each decision.
  kAll,        ///< Also the rules that fired, and the elements that were added and removed.
};

/// What one mind did in a tick.
struct MindRecord {
  std::string agent;  ///< Name of its agent.
  /// Percepts, decisions and commands; at Level::kAll also firings and elements.
  mind::EventLog events;
  friend bool operator==(const MindRecord&, const MindRecord&) = default;
};

/// All data of one tick: the inputs before it, the scene and the events after it, and a hash of the state. Tick 0 is
/// the world after the scenario's set-up.
struct TickRecord {
  std::uint64_t tick = 0;
  std::uint64_t state_hash = 0;
  std::vector<std::string> inputs;  ///< The inputs before the tick, in order, as text (sim/input_text.h).
  world::SceneSnapshot scene;       ///< Its tick and time are those of the record.
  sim::EventList events;
  std::vector<MindRecord> minds;  ///< Only minds that did something.
};

/// What the mind of this agent did in the tick; null if it did nothing or the agent has no mind.
const MindRecord* FindMind(const TickRecord& record, std::string_view agent);

/// The inputs before a tick.
struct TickInputs {
  std::uint64_t tick = 0;
  std::vector<std::string> inputs;
};

}  // namespace soarbox::record
