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
  std::vector<sim::Finding> Finish(double failed_s);

 private:
  bool IsAboutGiven(const std::string& message) const;
  std::set<std::string> AgentsOfFile();
  std::vector<sim::Finding> Slips(const std::vector<RuleWatch::Waiting>& waiting) const;

  sim::Simulation& simulation_;
  AccountSettings settings_;
  RuleWatch watch_;
  sim::EventFindings events_;
};

}  // namespace soarbox::mission
