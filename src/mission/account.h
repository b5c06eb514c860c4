// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "mission/rule_watch.h"
#include "sim/findings.h"

namespace soarbox::sim {
class Simulation;
}

namespace soarbox::mission {

using sim::Cause;

/// Which rules an account is about.
struct AccountSettings {
  std::string file;             ///< Name of the file of rules; empty: all files.
  std::string agent;            ///< The agent whose mind is queried; empty: all agents that run rules of the file.
  std::set<std::string> given;  ///< Rules of the file that came with the lesson. Only symptoms are reported about them.

  /// False if there is neither a file nor an agent. Then nothing is explained.
  bool IsAsked() const { return !file.empty() || !agent.empty(); }
  /// Whether rules of this file are meant. Without `file`: whether the rule was loaded from any file.
  bool IsAbout(const std::string& rule_file) const;
  bool IsAboutAgent(const std::string& name) const { return agent.empty() || agent == name; }
};

/// Explains what went wrong in a run, for the author of one file of rules. It must see all ticks of the run.
class Account {
 public:
  Account(sim::Simulation& simulation, AccountSettings settings);

  /// Call it once for each tick, with its events.
  void See(const sim::EventList& events);
  /// Returns a few sentences, sorted by cause; possibly none. `failed_s`: time of the first failed check. What happened
  /// only later, such as a refused command or an idle agent, is not reported as its cause.
  std::vector<sim::Finding> Finish(double failed_s);

 private:
  std::set<std::string> AgentsOfFile();
  std::vector<sim::Finding> Slips(const std::vector<RuleWatch::Waiting>& waiting) const;

  sim::Simulation& simulation_;
  AccountSettings settings_;
  RuleWatch watch_;
  sim::EventFindings events_;
};

}  // namespace soarbox::mission
