// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "mission/rule_watch.h"
#include "sim/run_event.h"

namespace soarbox::sim {
class Simulation;
}

namespace soarbox::mission {

/// What kind of cause a finding names. The order is the ranking: what is certain comes before what was only tried, and
/// symptoms come last.
enum class Cause : std::uint8_t {
  kSlip,      ///< A slip in a rule, which shows without running it.
  kMistake,   ///< A known mistake that a rule shows, as its author wrote it.
  kEndless,   ///< Rules fire again and again in one phase.
  kRefused,   ///< The world refused a command because of how it is written.
  kFurthest,  ///< A rule that never fired, and the condition that failed when it got furthest.
  kHappened,  ///< A known mistake: something happened that should not.
  kStalled,   ///< An operator was applied and stays selected, so that nothing follows.
  kMissing,   ///< A known mistake: something never happened.
  kWaiting,   ///< A rule that never fired because its operator was not selected.
  kSymptom,   ///< The agent had nothing to do, or a rule that came with the lesson never fired.
};

/// One sentence about what went wrong in a run.
struct RunFinding {
  Cause cause = Cause::kSymptom;
  std::string text;
};

/// Whose rules an account is about.
struct AccountSettings {
  std::string file;             ///< Name of the file of rules; empty: every file.
  std::string agent;            ///< The agent whose mind is asked; empty: all that run rules of the file.
  std::set<std::string> given;  ///< Rules in it that came with the lesson. Nothing but symptoms is said about them.

  /// Without a file and without an agent no account is given.
  bool IsAsked() const { return !file.empty() || !agent.empty(); }
  bool IsAbout(const std::string& rule_file) const;
  bool IsAboutAgent(const std::string& name) const { return agent.empty() || agent == name; }
};

/// What a run shows of one file of rules, for the person who wrote it. Follows a run through all its ticks.
class Account {
 public:
  Account(sim::Simulation& simulation, AccountSettings settings);

  /// Call once for each tick, with its events.
  void See(const sim::EventList& events);
  /// Sentences in the order of their causes; few, and perhaps none. `failed_s`: when the first check failed. An agent
  /// that had nothing to do only after that did not fail because of it.
  std::vector<RunFinding> Finish(double failed_s);

 private:
  bool IsAboutGiven(const std::string& message) const;

  sim::Simulation& simulation_;
  AccountSettings settings_;
  RuleWatch watch_;
  std::vector<RunFinding> slips_;
  std::string refused_agent_;  ///< The agent whose command the world refused first, because of how it is written.
  double refused_s_ = 0;
  std::string refused_;
  std::string idle_agent_;         ///< The agent that first had nothing to do.
  double idle_s_ = 0;              ///< Since when.
  std::vector<std::string> idle_;  ///< Why, most telling first; the last one says since when.
};

}  // namespace soarbox::mission
