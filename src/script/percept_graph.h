// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

struct lua_State;

namespace soarbox::script {

/// An agent's percepts from the sandbox's script: objects, which may be linked from several places and in cycles, and
/// their contents.
struct PerceptGraph {
  using Value = std::variant<std::int64_t, double, std::string>;
  struct Constant {
    std::string attribute;
    Value value;
    bool is_new = false;  ///< Counts as new even if it has not changed.
  };
  struct Link {
    std::string attribute;
    std::size_t node = 0;  ///< Index into nodes.
  };
  struct Node {
    std::string key;  ///< Identifies the object across graphs; empty: its place identifies it.
    std::vector<Constant> constants;
    std::vector<Link> links;
  };
  /// The first is the input link itself. The others are in breadth-first order.
  std::vector<Node> nodes;
};

/// Copies the table at `index`. A table is an object; the same table is the same object. A list is several attributes
/// with its name. Numbers, strings and booleans ("yes", "no") are constants; integral numbers are integers. The field
/// `_key` sets Node::key. `_new` says which constants are new: true for all, or a list of their attributes. The
/// attributes are in alphabetical order. Other values are left out.
///
/// Raises a Lua error if there are more than 2,000 objects or 20,000 elements.
PerceptGraph CopyGraph(lua_State* state, int index);

}  // namespace soarbox::script
