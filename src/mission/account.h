// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <set>
#include <string>
#include <vector>

#include "sim/run_event.h"

namespace soarbox::sim {
class Simulation;
}

namespace soarbox::mission {

/// Whose rules an account is about.
struct AccountSettings {
  std::string file;  ///< Name of the file of rules; empty: no account is asked for.
  std::set<std::string>
      given;  ///< Rules in it that somebody else wrote: blamed only if none of the others is at fault.
};

/// What a run says about one file of rules, for the person who wrote it: slips, why its agent had nothing to do, and
/// where rules that never fired stopped matching. Follows a run through all its ticks.
class Account {
 public:
  Account(sim::Simulation& simulation, AccountSettings settings)
      : simulation_(simulation), settings_(std::move(settings)) {}

  /// Call once for each tick, with its events.
  void See(const sim::EventList& events);
  /// Sentences, most telling first; few, and perhaps none. `failed_s`: when the first check failed. Whoever had nothing
  /// to do only after that did not fail because of it.
  std::vector<std::string> Finish(double failed_s);

 private:
  sim::Simulation& simulation_;
  AccountSettings settings_;
  std::vector<std::string> slips_;
  std::string refused_agent_;  ///< Whose command the world refused first, as it was written wrong.
  double refused_s_ = 0;
  std::string refused_;
  std::string idle_agent_;         ///< Who first had nothing to do.
  double idle_s_ = 0;              ///< Since when.
  std::vector<std::string> idle_;  ///< Since when, and why.
};

}  // namespace soarbox::mission
