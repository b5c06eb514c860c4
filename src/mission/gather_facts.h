// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "mission/event_facts.h"
#include "mission/mission.h"
#include "sim/simulation.h"

namespace soarbox::mission {

/// Whether an event reports an error or a warning.
bool IsProblem(const sim::RunEvent& event);
/// Formats a diagnostic on one line: "hare.soar:3:4: error: ...".
std::string ProblemText(const Diagnostic& diagnostic);

/// Collects the facts of each tick from a simulation. It only reads, so it does not change the run.
class FactGatherer {
 public:
  FactGatherer(sim::Simulation& simulation, Wants wants);

  /// Call it after the set-up and after each tick, with the events of that tick. The result is valid until the next
  /// call.
  const TickFacts& Gather(const sim::EventList& events);
  const TickFacts& facts() const { return facts_; }
  /// Reads the numbers of each mind now, whether checks need them or not.
  void GatherInsight();

 private:
  void GatherBodies();
  void GatherItems();
  void GatherEvents(const sim::EventList& events);
  void GatherMessages();
  void GatherMinds();
  void ReadEvents(const mind::EventLog& events, std::size_t agent);
  void Inspect(AgentFacts& facts, std::size_t agent);
  std::size_t IndexOf(std::string_view name) const;

  struct Memory;
  static void GatherRetrievals(explain::Inspector& inspector, const std::vector<explain::StateFact>& stack,
                               AgentFacts& facts, Memory& memory);

  /// State of a mind that is kept from tick to tick.
  struct Memory {
    std::vector<OperatorFact> selected;  ///< By level.
    std::vector<std::string> ids;
    using Said = std::map<std::string, std::vector<std::pair<std::string, std::string>>>;
    Said last_said;  ///< Parameters by the name of the command.
    Said under_way;
    std::uint32_t happened = 0;
    std::size_t rules = 0;
    bool knows_rules = false;
    std::uint64_t answered_timetag = 0;  ///< Time tag of the newest answer of a long-term memory.
    bool notes_recalls = false;          ///< Its kernel reports each recall.
  };

  sim::Simulation& simulation_;
  Wants wants_;
  TickFacts facts_;
  std::vector<Memory> memories_;  ///< In the order of facts_.agents.
  std::vector<std::uint32_t> ids_;
  std::uint32_t messages_ = 0;
  bool is_begun_ = false;
};

}  // namespace soarbox::mission
