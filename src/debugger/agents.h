// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "debugger/timeline.h"
#include "record/tick_record.h"
#include "sim/foreign_kind.h"
#include "sim/run_event.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

/// What went wrong with each agent so far; each problem once, as the run tells it.
class AgentTroubles {
 public:
  struct Trouble {
    std::uint64_t tick = 0;
    Diagnostic diagnostic;
  };

  void Add(const sim::EventList& events);
  /// Oldest first; at most the last kMost.
  const std::vector<Trouble>& Of(std::string_view agent) const;

  static constexpr std::size_t kMost = 100;

 private:
  std::map<std::string, std::vector<Trouble>, std::less<>> troubles_;
};

/// One agent of the world, as the list shows it.
struct AgentRow {
  std::uint32_t id = 0;  ///< As in the scene's snapshot.
  std::string name;
  std::string kind;    ///< "lua", "soar seeking", ...
  std::string team;    ///< Empty: none.
  std::string script;  ///< File name of its body script; empty for bodies that the vocabulary drives.
  bool has_mind = false;
  bool alive = true;
  bool failed = false;  ///< Its script or its Soar program has stopped.
  float health = 0;
  std::string state;    ///< The lowest state: "S1", "S3 (operator tie)"; empty without a mind.
  std::string op;       ///< The lowest operator that is selected: "seek (O3)"; empty if none is.
  std::string last_op;  ///< The one that was selected last, now or in a tick before, if a timeline tells it.
  std::string command;  ///< What its mind said last.
  std::string error;    ///< The newest error, all of it, with file and line; empty if there was none.
  std::string error_file;
  int error_line = 0;      ///< 0: not known.
  std::size_t errors = 0;  ///< How many there were.
  std::uint64_t decisions = 0;
  double decide_us = 0;  ///< Real time that the last tick's decisions took; differs from run to run.
};

/// Whether another simulation moves it (docs/dis.md).
inline bool IsForeign(const AgentRow& row) {
  return row.kind == sim::kForeignKind;
}

/// All agents, in creation order.
std::vector<AgentRow> ListAgents(const sim::Simulation& simulation, const AgentTroubles& troubles,
                                 const Timeline* timeline = nullptr);
/// The same from what is recorded of a tick; states and operators as the timeline has them then.
std::vector<AgentRow> ListAgents(const record::TickRecord& tick, const Timeline& timeline,
                                 const AgentTroubles& troubles);

enum class AgentColumn : std::uint8_t {
  kCreated,
  kName,
  kKind,
  kTeam,
  kHealth,
  kState,
  kOperator,
  kCommand,
  kErrors,
  kDecisions,
  kTime,
};
/// Stable: rows that are equal in this column keep their order.
void SortAgents(std::vector<AgentRow>& rows, AgentColumn column, bool descending = false);
/// Those that have each word of the text somewhere (name, kind, team, state, operator, command, error).
std::vector<AgentRow> FilterAgents(const std::vector<AgentRow>& rows, std::string_view text);

/// Without decision times, which differ from run to run.
std::string ToText(const std::vector<AgentRow>& rows);
Json ToJson(const std::vector<AgentRow>& rows);

}  // namespace soarbox::debugger
