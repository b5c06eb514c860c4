// SPDX-License-Identifier: BSD-2-Clause
#include "sim/input_mirror.h"

#include <algorithm>

#include "sim/mind_notes.h"
#include "sml_Client.h"

namespace soarbox::sim {

InputMirror::InputMirror(sml::Agent& agent) : agent_(&agent) {}

void InputMirror::Show(const PerceptList& wanted) {
  changes_ = 0;
  Update(nodes_, wanted, *agent_->GetInputLink());
}

void InputMirror::NoteValue(const Node& node) {
  if (notes_ != nullptr) notes_->NotePercept(path_, node.constant);
}

void InputMirror::NoteGone(const Node& node) {
  if (notes_ != nullptr) notes_->NotePerceptGone(path_, node.attribute, node.key);
}

void InputMirror::UpdateBelow(Node& node, const Percept& percept, sml::Identifier& object) {
  const std::size_t length = path_.size();
  if (notes_ != nullptr) {
    path_ += node.attribute;
    if (node.key != 0) path_.append("#").append(std::to_string(node.key));
    path_ += '.';
  }
  Update(node.children, std::get<Percept::Object>(percept.value), object);
  path_.resize(length);
}

/// Makes the element of a percept, with all below it.
void InputMirror::Make(Node& node, const Percept& percept, sml::Identifier& parent) {
  ++changes_;
  node.attribute = percept.attribute;
  node.key = percept.key;
  node.is_object = percept.IsObject();
  const char* attribute = node.attribute.c_str();
  if (node.is_object) {
    sml::Identifier* made = agent_->CreateIdWME(&parent, attribute);
    node.element = made;
    if (made != nullptr) UpdateBelow(node, percept, *made);
    return;
  }
  node.constant = percept;
  NoteValue(node);
  if (const auto* integer = std::get_if<std::int64_t>(&percept.value)) {
    node.element = agent_->CreateIntWME(&parent, attribute, *integer);
  } else if (const auto* number = std::get_if<double>(&percept.value)) {
    node.element = agent_->CreateFloatWME(&parent, attribute, *number);
  } else {
    node.element = agent_->CreateStringWME(&parent, attribute, percept.Text()->c_str());
  }
}

/// Gives a constant its new value; false if its type changed and it must be made anew.
bool InputMirror::Change(Node& node, const Percept& percept) {
  if (node.constant.value == percept.value) return true;
  if (node.element == nullptr || node.constant.value.index() != percept.value.index()) return false;
  if (const auto* integer = std::get_if<std::int64_t>(&percept.value)) {
    agent_->Update(node.element->ConvertToIntElement(), *integer);
  } else if (const auto* number = std::get_if<double>(&percept.value)) {
    agent_->Update(node.element->ConvertToFloatElement(), *number);
  } else {
    agent_->Update(node.element->ConvertToStringElement(), percept.Text()->c_str());
  }
  node.constant.value = percept.value;
  NoteValue(node);
  ++changes_;
  return true;
}

void InputMirror::Update(std::vector<Node>& have, const PerceptList& want, sml::Identifier& parent) {
  // Percepts keep their order from tick to tick, so that the next one is nearly always where it was.
  std::size_t at = 0;
  for (const Percept& percept : want) {
    const auto is_same = [&](const Node& node) {
      return node.key == percept.key && node.is_object == percept.IsObject() && node.attribute == percept.attribute;
    };
    auto found = std::find_if(have.begin() + static_cast<std::ptrdiff_t>(at), have.end(), is_same);
    if (found == have.end()) {
      Node made;
      Make(made, percept, parent);
      have.insert(have.begin() + static_cast<std::ptrdiff_t>(at), std::move(made));
    } else {
      if (found != have.begin() + static_cast<std::ptrdiff_t>(at))
        std::rotate(have.begin() + static_cast<std::ptrdiff_t>(at), found, found + 1);
      Node& node = have[at];
      if (node.is_object) {
        if (auto* object = node.element ? node.element->ConvertToIdentifier() : nullptr)
          UpdateBelow(node, percept, *object);
      } else if (!Change(node, percept)) {
        if (node.element != nullptr) agent_->DestroyWME(node.element);
        Make(node, percept, parent);
      }
    }
    ++at;
  }
  // What nobody wanted goes; an object takes what is below it along.
  for (std::size_t i = at; i < have.size(); ++i) {
    if (have[i].element != nullptr) agent_->DestroyWME(have[i].element);
    NoteGone(have[i]);
    ++changes_;
  }
  have.resize(at);
}

}  // namespace soarbox::sim
