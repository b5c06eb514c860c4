// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>

#include "sim/actor.h"

namespace soarbox::sim {

/// What an actor knows of the world as a scene for its imagination (the spatial visual system): its own body, eye and
/// reach, the others, things, waypoints and regions. It is as honest as the actor's percepts: what is out of view stays
/// where the actor last noticed it, until the actor notices it again or forgets it. The frame is the world's: metres, x
/// to the east, y up, z to the south.
class SceneSense {
 public:
  /// Lines of the scene graph edit language that bring the scene up to date; empty if nothing changed. `surroundings`:
  /// with what is around the actor, not only its own body.
  std::string Update(const Actor& actor, bool surroundings);

 private:
  using Tags = std::map<std::string, std::string>;
  struct Shown {
    std::string shape, pose;
    Tags tags;
    bool is_own = false;
    bool wanted = false;  ///< Scratch: it is there in this update.
  };

  void Show(std::string_view name, Shown node, std::string& lines);
  void ShowOwn(const Actor& actor, std::string& lines);
  void ShowOthers(const Actor& actor, std::string& lines);
  void ShowThings(const Actor& actor, std::string& lines);
  void ShowPlaces(const Actor& actor, std::string& lines);

  std::map<std::string, Shown> shown_;  ///< By the node's id.
};

}  // namespace soarbox::sim
