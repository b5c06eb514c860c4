// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "mind/event_log.h"
#include "script/percept_graph.h"
#include "sim/percept_link.h"

namespace soarbox::sim {

/// Keeps an agent's input link equal to a graph of objects. It writes only the differences.
///
/// An object keeps its identifier if it was in the previous graph. The parent of an object is the first object, in
/// breadth-first order, with a link to it. An object was in the previous graph if its parent was, and had a link to a
/// child with the same attribute and the same key. If the child has no key, the position of the link among those with
/// the same attribute is compared instead. Equal constants stay unchanged, unless their object is marked as new.
/// Elements that others have added to the input link are not changed. Owned by the agent's mind.
class GraphMirror {
 public:
  explicit GraphMirror(PerceptLink& link);
  GraphMirror(const GraphMirror&) = delete;
  GraphMirror& operator=(const GraphMirror&) = delete;

  void Show(const script::PerceptGraph& graph);
  /// Records each change in `log` from now on, with the first path of each object; null: stops. Not owned.
  void SetLog(mind::EventLog* log) { log_ = log; }

 private:
  using Handle = mind::InputWriter::Handle;
  struct Constant {
    std::string attribute;
    std::uint32_t place = 0;  ///< Index among the constants with the same attribute.
    script::PerceptGraph::Value value;
    Handle element = 0;
  };
  struct Link {
    std::string attribute;
    std::string name;  ///< Identifies the link: attribute, and key or index.
    std::uint32_t place = 0;
    std::size_t node = 0;
    Handle element = 0;
    bool is_first = false;  ///< The link with which its object was created.
  };
  struct Node {
    Handle id = 0;
    std::string path;  ///< Ends with a dot.
    std::vector<Constant> constants;
    std::vector<Link> links;
  };

  void Match(const script::PerceptGraph& graph);
  void DropLinks();
  void MakeObjects();
  void ShowConstants(const script::PerceptGraph::Node& wanted, Node& shown, const Node* before);
  /// Lists what is below an object and must be written again.
  void ListAgain(std::size_t n, std::vector<PerceptLink::Again>& again);
  void WriteAgain(Node& node, Link& link, std::vector<PerceptLink::Again>& below);
  void NoteGone(std::string_view path, std::string_view attribute, std::uint32_t place);

  PerceptLink& link_;
  mind::EventLog* log_ = nullptr;
  std::vector<Node> nodes_;  ///< The objects on the input link; empty before the first Show.
  // Scratch of Show.
  std::vector<Node> next_;
  std::vector<std::size_t> before_;  ///< By index in next_: the index in nodes_, or none.
  std::vector<bool> stays_;          ///< By index in nodes_.
  // Scratch of WriteAgain.
  std::vector<bool> is_written_;  ///< By index in nodes_.
};

}  // namespace soarbox::sim
