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

/// Keeps an agent's input link equal to a graph of objects. It writes only the differences.
///
/// An object is identified with an object of the previous graph if both have the same key. Objects without a key are
/// identified if they are at the same place of identified objects. They then keep their identifier. The place is the
/// shortest path from the input link. Equal constants stay unchanged, unless their object is marked as new. Elements
/// that others have added to the input link are not changed. Owned by the agent's mind.
class GraphMirror {
 public:
  explicit GraphMirror(sml::Agent& agent) : agent_(&agent) {}

  void Show(const script::PerceptGraph& graph);
  /// Records each change in `log` from now on, with the first path of each object; null: stops. Not owned.
  void SetLog(mind::EventLog* log) { log_ = log; }

 private:
  struct Constant {
    std::string attribute;
    std::uint32_t place = 0;  ///< Index among the constants with the same attribute.
    script::PerceptGraph::Value value;
    sml::WMElement* element = nullptr;
  };
  struct Link {
    std::string attribute;
    std::string name;  ///< Identifies the link: attribute, and key or index.
    std::uint32_t place = 0;
    std::size_t node = 0;
    sml::WMElement* element = nullptr;
    bool is_first = false;  ///< The link with which its object was created.
  };
  struct Node {
    sml::Identifier* id = nullptr;
    std::string path;  ///< Ends with a dot.
    std::vector<Constant> constants;
    std::vector<Link> links;
  };

  void Match(const script::PerceptGraph& graph);
  void DropLinks();
  void MakeObjects();
  void ShowConstants(const script::PerceptGraph::Node& wanted, Node& shown, const Node* before);
  sml::WMElement* Create(Node& node, const Constant& constant);
  /// Changes the element's value. Returns false if the type differs.
  bool Update(Constant& before, const script::PerceptGraph::Value& value);
  void NoteGone(std::string_view path, std::string_view attribute, std::uint32_t place);

  sml::Agent* agent_;
  mind::EventLog* log_ = nullptr;
  std::vector<Node> nodes_;  ///< The objects on the input link; empty before the first Show.
  // Scratch of Show.
  std::vector<Node> next_;
  std::vector<std::size_t> before_;  ///< By index in next_: the index in nodes_, or none.
  std::vector<bool> stays_;          ///< By index in nodes_.
};

}  // namespace soarbox::sim
