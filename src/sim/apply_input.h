// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <span>
#include <string>

#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"
#include "sim/input.h"
#include "world/entity_ids.h"

namespace soarbox::world {
class World;
}
namespace soarbox::script {
class ScriptHost;
}

namespace soarbox::sim {

struct BodyKind;
class ForeignBodies;
class SoarHost;

/// What inputs can change or call.
struct InputTargets {
  world::World& world;
  script::ScriptHost& scripts;
  SoarHost& soar;
  std::function<void(const CommandInput& asked, const Result<std::string>& answer)> answer;
  std::function<void(Diagnostic)> warn;
  std::function<void(world::EntityId agent, const std::string& order)> order;
  ForeignBodies& foreign;
  std::span<const BodyKind> kinds;                    ///< Kinds of bodies in the scenario.
  std::function<void(std::string_view acts)> client;  ///< Receives lines of the log of a recorded client.
};

/// Applies an input. Reports what cannot be done.
void ApplyInput(const Input& input, const InputTargets& targets);

}  // namespace soarbox::sim
