// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "script/mind_factory.h"
#include "sim/event.h"
#include "sim/scenario.h"
#include "sim/soar_host.h"
#include "sim/soar_mind.h"
#include "world/world.h"

namespace soarbox::sim {

/// The Soar minds of a world: makes them when scripts ask for agents that have one, and lets them decide once per tick.
class Minds final : public script::MindFactory {
 public:
  /// Takes an event; the caller fills in time and tick.
  using Report = std::function<void(Event)>;

  Minds(world::World& world, const Scenario& scenario, SoarHost& host, Report report);

  /// Loads the rules that the request names, or its kind's own: seekingagent.soar, followeragent.soar,
  /// waypointagent.soar. Faulty rules are reported and the others loaded.
  Result<void> MakeMind(world::EntityId agent, const script::AgentCreationRequest& request) override;

  /// Every mind perceives and decides. Minds see the world as it stands before any of them acts, so their order does
  /// not matter.
  void Decide();

  /// Makes all minds anew in the host's kernel, with the rules that they had. Those that fail are reported, and stay
  /// idle.
  void Restore();

  struct Mind {
    world::EntityId agent;
    bool follows_leader;  ///< Perceives its leader, else its target.
    std::filesystem::path rules;
    SoarMind soar;
    float distance_squared_m2 = 0;
    bool decided = false;  ///< In this tick.
    bool lost = false;     ///< Its program has broken down, or could not be made again.
    bool in_gap = false;
    bool told_halt = false;
    std::string last_command = {};
  };
  /// Null if the agent has no mind. Valid until the next MakeMind.
  Mind* Find(world::EntityId agent);
  std::size_t size() const { return minds_.size(); }

 private:
  Result<SoarHost::Loaded> Load(const std::string& agent, const std::filesystem::path& rules);
  void Decide(Mind& mind);
  void TellGap(Mind& mind, const world::Agent& body);

  world::World& world_;
  const Scenario& scenario_;
  SoarHost& host_;
  Report report_;
  std::vector<Mind> minds_;         ///< In creation order, thus in ascending agent id.
  std::set<std::string> reported_;  ///< Problems told already: many agents share one file.
};

}  // namespace soarbox::sim
