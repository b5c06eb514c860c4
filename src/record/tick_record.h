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

/// How much of a run is kept.
enum class Level : std::uint8_t {
  kWorld,      ///< What there is to see, events, inputs and state hashes.
  kDecisions,  ///< Also percepts, commands, and each decision's operators and impasses.
  kAll,        ///< Also which rules fired and which elements came and went.
};

/// What one mind did in a tick.
struct MindRecord {
  std::string agent;  ///< Its body's name.
  /// Percepts, decisions and commands; at Level::kAll also firings and elements.
  mind::EventLog events;
  bool from_words = false;  ///< Of an old recording: some is not known, and numbers have six digits.
  friend bool operator==(const MindRecord&, const MindRecord&) = default;
};

/// Everything that is known of one tick: what came in, what there was to see afterwards, what happened, and a hash of
/// the state. Tick 0 is the world as the scenario's set-up left it.
struct TickRecord {
  std::uint64_t tick = 0;
  std::uint64_t state_hash = 0;
  std::vector<std::string> inputs;  ///< What entered before the tick, in order, as sim writes it.
  world::SceneSnapshot scene;       ///< Its tick and time are those of the record.
  sim::EventList events;
  std::vector<MindRecord> minds;  ///< Those that did something.
};

/// What the mind of this agent did in the tick; null if that is nothing, or it has none.
const MindRecord* FindMind(const TickRecord& record, std::string_view agent);

/// What entered before a tick.
struct TickInputs {
  std::uint64_t tick = 0;
  std::vector<std::string> inputs;
};

}  // namespace soarbox::record
