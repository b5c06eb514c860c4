// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "world/entity_ids.h"
#include "world/scene_snapshot.h"

namespace soarbox::world {
class Agent;
class World;
}  // namespace soarbox::world

namespace soarbox::sim {

/// The picture that a recorded client describes: elements below ^soarbox.scene on the input link of an agent
/// (docs/client_recordings.md).
///
///     ^body   ^name ^x ^y ^heading ^size ^color    the agent of that name, or a ball with its heading
///     ^line   ^x ^y ^to-x ^to-y ^color
///     ^text   ^x ^y ^text ^color
///
/// Metres and degrees: x to the right, y to the front, a heading of 0 along x, counter-clockwise. A value of the wrong
/// type is treated as missing. Call Note with the parts of each line `add`, `set` or `remove` of the client's log.
/// Owned by the agent's mind.
class ClientScene {
 public:
  /// Applies a line of the log. `input_link`: the name of the identifier of the input link.
  void Note(const std::vector<std::string>& parts, std::string_view input_link);
  /// Removes everything. Call it after init-soar: the client then adds everything again.
  void Clear();
  /// Draws it for the current tick; moves bodies of agents.
  void Show(world::World& world);

  /// Maximum number of shapes that are drawn; further ones are left out.
  static constexpr std::size_t kMost = 1000;

 private:
  struct Value {
    std::string text;
    double number = 0;
    bool is_number = false;
  };
  struct Shape {
    std::string kind;
    std::map<std::string, Value, std::less<>> values;
    double Number(std::string_view attribute, double otherwise) const;
    std::string Text(std::string_view attribute) const;
    world::Vec3 At(std::string_view x, std::string_view y, float height_m) const;
    world::Vec3 Color() const;
  };
  struct Element {
    std::string id, attribute, value;
  };

  void Set(const Element& element, std::string_view type);
  void ShowBody(const Shape& shape, world::World& world) const;
  void ShowText(const Shape& shape, world::World& world);

  std::string root_, scene_;                 ///< Identifiers of ^soarbox and ^scene; empty: there is none.
  std::map<std::string, Shape> shapes_;      ///< By their identifiers.
  std::map<std::string, Element> elements_;  ///< By their handles.
  std::vector<world::UiId> texts_;           ///< All texts that were created so far; the first ones are in use.
  std::size_t texts_shown_ = 0;
};

}  // namespace soarbox::sim
