// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"
#include "script/percept_graph.h"

namespace sml {
class Agent;
class Identifier;
class WMElement;
}  // namespace sml

namespace soarbox::sim {

/// Keeps an agent's input link equal to a graph of objects and writes only the differences.
///
/// An object is the same as in the previous graph if it has the same key, or, without a key, if it is at the same place
/// of an object that is the same; then it keeps its identifier. A place is named by the shortest way from the input
/// link. Equal constants stay as they are, unless their object says that they are new. Other elements on the input link
/// are not its own and stay. Owned by the agent's mind.
class GraphMirror {
 public:
  explicit GraphMirror(sml::Agent& agent) : agent_(&agent) {}

  void Show(const script::PerceptGraph& graph);
  /// Notes each change from now on, objects by their first place; null: stops. Not owned.
  void SetLog(mind::EventLog* log) { log_ = log; }

 private:
  struct Constant {
    std::string attribute;
    std::uint32_t place = 0;  ///< Among those of the same attribute.
    script::PerceptGraph::Value value;
    sml::WMElement* element = nullptr;
  };
  struct Link {
    std::string attribute;
    std::string name;  ///< What finds it again: attribute and key or place.
    std::uint32_t place = 0;
    std::size_t node = 0;
    sml::WMElement* element = nullptr;
    bool is_first = false;  ///< The one that its object was made with.
  };
  struct Node {
    sml::Identifier* id = nullptr;
    std::string path;  ///< With a dot at its end.
    std::vector<Constant> constants;
    std::vector<Link> links;
  };

  void Match(const script::PerceptGraph& graph);
  void DropLinks();
  void MakeObjects();
  void ShowConstants(const script::PerceptGraph::Node& wanted, Node& shown, const Node* before);
  sml::WMElement* Create(Node& node, const Constant& constant);
  /// Gives the element its value; false if it is of another type.
  bool Update(Constant& before, const script::PerceptGraph::Value& value);
  void NoteGone(std::string_view path, std::string_view attribute, std::uint32_t place);

  sml::Agent* agent_;
  mind::EventLog* log_ = nullptr;
  std::vector<Node> nodes_;  ///< As they are on the input link; empty: nothing was shown yet.
  // Scratch of Show.
  std::vector<Node> next_;
  std::vector<std::size_t> before_;  ///< By number in next_: in nodes_, or none.
  std::vector<bool> stays_;          ///< By number in nodes_.
};

}  // namespace soarbox::sim
