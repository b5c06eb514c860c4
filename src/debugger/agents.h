// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/timeline.h"
#include "record/tick_record.h"
#include "sim/foreign_kind.h"
#include "sim/run_event.h"
#include "sim/simulation.h"

namespace soarbox::debugger {

/// The problems of each agent so far. Each problem is listed once, when the run reports it.
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

/// Both are empty if there is no operator.
struct OperatorName {
  std::string name, id;  ///< The name may be empty.
};
/// "seek (O3)", "O3", or nothing.
std::string ToText(const OperatorName& op);

/// One row of the list of agents.
struct AgentRow {
  std::uint32_t id = 0;  ///< As in the scene's snapshot.
  std::string name;
  std::string kind;    ///< "lua", "soar seeking", ...
  std::string team;    ///< Empty if it has none.
  std::string script;  ///< File name of its body script; empty if commands of the vocabulary control the body.
  bool has_mind = false;
  bool alive = true;
  bool failed = false;  ///< Its script or its Soar program has stopped.
  float health = 0;
  std::string state;     ///< The lowest state: "S3"; empty without a mind.
  std::string impasse;   ///< Its impasse: "operator tie"; empty for the top state.
  OperatorName op;       ///< The lowest selected operator.
  OperatorName last_op;  ///< The operator that was selected last, in this tick or an earlier one; empty without a
                         ///< timeline.
  std::string command;   ///< The last command that its mind gave.
  std::string error;     ///< The complete text of the newest error, with file and line; empty if there was none.
  std::string error_file;
  int error_line = 0;      ///< 0 if it is not known.
  std::size_t errors = 0;  ///< Number of errors so far.
  std::uint64_t decisions = 0;
  double decide_us = 0;  ///< Real time that the decisions of the last tick took, in µs; differs from run to run.
};

/// "S1", "S3 (operator tie)".
std::string StateText(const AgentRow& row);
/// Whether another simulation controls the agent (docs/dis.md).
inline bool IsForeign(const AgentRow& row) {
  return row.kind == sim::kForeignKind;
}

/// All agents, in creation order.
std::vector<AgentRow> ListAgents(const sim::Simulation& simulation, const AgentTroubles& troubles,
                                 const Timeline* timeline = nullptr);
/// The same from the record of a tick. States and operators come from the timeline at that tick.
std::vector<AgentRow> ListAgents(const record::TickRecord& tick, const Timeline& timeline,
                                 const AgentTroubles& troubles);

/// Without decision times, because they differ from run to run.
std::string ToText(const std::vector<AgentRow>& rows);

}  // namespace soarbox::debugger
