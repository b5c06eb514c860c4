// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <functional>
#include <span>
#include <string>

#include "diagnostics/diagnostic.h"
#include "diagnostics/result.h"
#include "sim/input.h"
#include "world/ids.h"

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

/// What an input can reach.
struct InputTargets {
  world::World& world;
  script::ScriptHost& scripts;
  SoarHost& soar;
  std::function<void(const CommandInput& asked, const Result<std::string>& answer)> answer;
  std::function<void(Diagnostic)> warn;
  std::function<void(world::EntityId agent, const std::string& order)> order;
  ForeignBodies& foreign;
  std::span<const BodyKind> kinds;                    ///< Of bodies.
  std::function<void(std::string_view acts)> client;  ///< Lines of the log of a recorded client.
};

/// Lets an input take effect. Reports what it cannot do.
void ApplyInput(const Input& input, const InputTargets& targets);

}  // namespace soarbox::sim
