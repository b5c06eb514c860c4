// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <vector>

#include "sim/percept.h"

namespace sml {
class Agent;
class Identifier;
class WMElement;
}  // namespace sml

namespace soarbox::sim {

class MindNotes;

/// Keeps an agent's input link equal to a list of percepts and writes only the differences.
///
/// Invariant: what it keeps is what the client library was told last. Other elements on the input link (the thesis'
/// ^distance) are not its own and stay. Owned by the agent's mind.
class InputMirror {
 public:
  explicit InputMirror(sml::Agent& agent);

  /// Makes the input link show this; an object that is found again (attribute and key) keeps its identifier.
  void Show(const PerceptList& wanted);
  /// Notes each change from now on; null: does not. Not owned.
  void SetNotes(MindNotes* notes) { notes_ = notes; }
  /// How many elements the last Show wrote, changed or removed.
  std::size_t changes() const { return changes_; }

 private:
  struct Node {
    std::string attribute;
    std::uint32_t key = 0;
    Percept constant;  ///< Its value if it is no object.
    sml::WMElement* element = nullptr;
    bool is_object = false;
    std::vector<Node> children;
  };

  void Update(std::vector<Node>& have, const PerceptList& want, sml::Identifier& parent);
  void UpdateBelow(Node& node, const Percept& percept, sml::Identifier& object);
  void Make(Node& node, const Percept& percept, sml::Identifier& parent);
  bool Change(Node& node, const Percept& percept);
  void NoteValue(const Node& node);
  void NoteGone(const Node& node);

  sml::Agent* agent_;
  std::vector<Node> nodes_;
  std::size_t changes_ = 0;
  MindNotes* notes_ = nullptr;
  std::string path_;  ///< Of the object that is under way, with a dot behind it; kept with notes only.
};

}  // namespace soarbox::sim
