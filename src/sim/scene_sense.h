// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>

#include "sim/actor.h"

namespace soarbox::sim {

/// Converts what an actor knows about the world to a scene for its spatial visual system: its own body, eye and reach,
/// other agents, things, waypoints and regions. The scene contains no more than its percepts: a body that is out of
/// view stays where the actor last perceived it, until the actor perceives it again or forgets it. Coordinates are
/// those of the world: metres, x to the east, y up, z to the south.
class SceneSense {
 public:
  /// Returns commands of the scene graph edit language that update the scene; empty if nothing changed. `surroundings`:
  /// also update what is around the actor, not only its own body.
  std::string Update(const Actor& actor, bool surroundings);

 private:
  using Tags = std::map<std::string, std::string>;
  struct Shown {
    std::string shape, pose;
    Tags tags;
    bool is_own = false;
    bool wanted = false;  ///< Temporary: it exists in this update.
  };

  void Show(std::string_view name, Shown node, std::string& lines);
  void ShowOwn(const Actor& actor, std::string& lines);
  void ShowOthers(const Actor& actor, std::string& lines);
  void ShowThings(const Actor& actor, std::string& lines);
  void ShowPlaces(const Actor& actor, std::string& lines);

  std::map<std::string, Shown> shown_;  ///< By node id.
};

}  // namespace soarbox::sim
