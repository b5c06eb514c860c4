// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

struct lua_State;

namespace soarbox::script {

/// What the sandbox's script says that an agent perceives: objects, which may be linked from several places and in
/// circles, and what is below each.
struct PerceptGraph {
  using Value = std::variant<std::int64_t, double, std::string>;
  struct Constant {
    std::string attribute;
    Value value;
    bool is_new = false;  ///< Counts as new, whether it has changed or not.
  };
  struct Link {
    std::string attribute;
    std::size_t node = 0;  ///< In nodes.
  };
  struct Node {
    std::string key;  ///< Makes it the same object as in an earlier graph; empty: its place does.
    std::vector<Constant> constants;
    std::vector<Link> links;
  };
  /// The first is the input link itself. The others come in the order in which they are met, the nearest first.
  std::vector<Node> nodes;
};

/// Copies the table at `index`. A table is an object, and the same table met again is the same object; a list stands
/// for several attributes of its name. Numbers, strings and booleans ("yes", "no") are constants; whole numbers are
/// integers. The field `_key` sets Node::key; `_new` says which constants are new: true for all, or a list of their
/// attributes. The attributes are in alphabetical order.
/// Other values are left out. Raises a Lua error beyond 2,000 objects or 20,000 elements.
PerceptGraph CopyGraph(lua_State* state, int index);

}  // namespace soarbox::script
