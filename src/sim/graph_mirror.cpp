// SPDX-License-Identifier: BSD-2-Clause
#include "sim/graph_mirror.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "sml_Client.h"

namespace soarbox::sim {
namespace {

using script::PerceptGraph;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::string WithPlace(const std::string& attribute, std::uint32_t place) {
  return place == 0 ? attribute : attribute + "#" + std::to_string(place);
}

}  // namespace

void GraphMirror::Show(const PerceptGraph& graph) {
  Match(graph);
  DropLinks();
  MakeObjects();
  for (std::size_t n = 0; n < next_.size(); ++n)
    ShowConstants(graph.nodes[n], next_[n], before_[n] == kNone ? nullptr : &nodes_[before_[n]]);
  // Links to existing objects are created last, when all objects exist.
  for (Node& node : next_) {
    for (Link& link : node.links) {
      if (link.is_first || link.element != nullptr || node.id == nullptr || next_[link.node].id == nullptr) continue;
      link.element = agent_->CreateSharedIdWME(node.id, link.attribute.c_str(), next_[link.node].id);
    }
  }
  nodes_ = std::exchange(next_, {});
}

/// Identifies objects of the graph with objects on the input link. The graph lists the nearest first, so that an object
/// is identified before links back to it.
void GraphMirror::Match(const PerceptGraph& graph) {
  next_.assign(graph.nodes.size(), {});
  before_.assign(graph.nodes.size(), kNone);
  stays_.assign(nodes_.size(), false);
  std::vector<bool> is_met(graph.nodes.size(), false);
  if (!graph.nodes.empty()) is_met[0] = true;
  if (!graph.nodes.empty() && !nodes_.empty()) {
    before_[0] = 0;
    stays_[0] = true;
  }
  for (std::size_t n = 0; n < graph.nodes.size(); ++n) {
    const Node* const before = before_[n] == kNone ? nullptr : &nodes_[before_[n]];
    std::map<std::string, std::uint32_t> places;
    for (const PerceptGraph::Link& wanted : graph.nodes[n].links) {
      Link& link = next_[n].links.emplace_back();
      link.attribute = wanted.attribute;
      link.place = places[wanted.attribute]++;
      link.node = wanted.node;
      const std::string& key = graph.nodes[wanted.node].key;
      link.name = key.empty() ? WithPlace(link.attribute, link.place) : link.attribute + "=" + key;
      link.is_first = !is_met[wanted.node];
      is_met[wanted.node] = true;
      if (link.is_first) next_[wanted.node].path = next_[n].path + WithPlace(link.attribute, link.place) + ".";
      if (before == nullptr) continue;
      const auto at = std::ranges::find_if(before->links, [&](const Link& old) {
        return old.name == link.name && old.is_first == link.is_first && old.element != nullptr;
      });
      if (at == before->links.end()) continue;
      if (link.is_first && !stays_[at->node]) {
        before_[wanted.node] = at->node;
        stays_[at->node] = true;
        link.element = at->element;
      } else if (!link.is_first && before_[wanted.node] == at->node) {
        link.element = at->element;
      }
    }
  }
  for (std::size_t n = 0; n < next_.size(); ++n)
    if (before_[n] != kNone) next_[n].id = n == 0 ? agent_->GetInputLink() : nodes_[before_[n]].id;
  if (!next_.empty()) next_[0].id = agent_->GetInputLink();
}

/// Removes what the new graph does not have: first additional links to objects, then the objects.
void GraphMirror::DropLinks() {
  std::vector<sml::WMElement*> kept;
  for (const Node& node : next_)
    for (const Link& link : node.links)
      if (link.element != nullptr) kept.push_back(link.element);
  std::ranges::sort(kept);
  const auto is_kept = [&](const Link& link) { return std::ranges::binary_search(kept, link.element); };
  for (const Node& node : nodes_)
    for (const Link& link : node.links)
      if (!link.is_first && link.element != nullptr && !is_kept(link)) agent_->DestroyWME(link.element);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!stays_[n]) continue;  // It is removed together with its object.
    for (const Link& link : nodes_[n].links) {
      if (!link.is_first || link.element == nullptr || is_kept(link)) continue;
      NoteGone(nodes_[n].path, link.attribute, link.place);
      agent_->DestroyWME(link.element);
    }
  }
}

void GraphMirror::MakeObjects() {
  for (Node& node : next_) {
    for (Link& link : node.links) {
      if (!link.is_first || link.element != nullptr || node.id == nullptr) continue;
      sml::Identifier* made = agent_->CreateIdWME(node.id, link.attribute.c_str());
      link.element = made;
      next_[link.node].id = made;
    }
  }
}

sml::WMElement* GraphMirror::Create(Node& node, const Constant& constant) {
  if (node.id == nullptr) return nullptr;
  const char* const attribute = constant.attribute.c_str();
  if (const auto* integer = std::get_if<std::int64_t>(&constant.value))
    return agent_->CreateIntWME(node.id, attribute, *integer);
  if (const auto* number = std::get_if<double>(&constant.value))
    return agent_->CreateFloatWME(node.id, attribute, *number);
  return agent_->CreateStringWME(node.id, attribute, std::get<std::string>(constant.value).c_str());
}

bool GraphMirror::Update(Constant& before, const PerceptGraph::Value& value) {
  if (before.element == nullptr || before.value.index() != value.index()) return false;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    agent_->Update(static_cast<sml::IntElement*>(before.element), *integer);
  } else if (const auto* number = std::get_if<double>(&value)) {
    agent_->Update(static_cast<sml::FloatElement*>(before.element), *number);
  } else {
    agent_->Update(static_cast<sml::StringElement*>(before.element), std::get<std::string>(value).c_str());
  }
  return true;
}

void GraphMirror::ShowConstants(const PerceptGraph::Node& wanted, Node& shown, const Node* before) {
  std::vector<Constant> old = before == nullptr ? std::vector<Constant>() : before->constants;
  std::map<std::string, std::uint32_t> places;
  for (const PerceptGraph::Constant& one : wanted.constants) {
    Constant constant{one.attribute, places[one.attribute]++, one.value, nullptr};
    // Working memory is a set: only one of several equal elements exists.
    const bool is_there = std::ranges::any_of(shown.constants, [&](const Constant& other) {
      return other.attribute == constant.attribute && other.value == constant.value;
    });
    if (is_there) continue;
    const auto at = std::ranges::find_if(old, [&](const Constant& other) {
      return other.attribute == constant.attribute && other.place == constant.place && other.element != nullptr;
    });
    bool has_changed = true;
    if (at != old.end()) {
      has_changed = at->value != constant.value;
      if (!one.is_new && (!has_changed || Update(*at, constant.value)))
        constant.element = std::exchange(at->element, nullptr);
    }
    if (constant.element == nullptr) {
      if (at != old.end()) agent_->DestroyWME(std::exchange(at->element, nullptr));
      constant.element = Create(shown, constant);
    }
    if (has_changed && log_ != nullptr) {
      mind::PerceptChanged percept{shown.path, constant.attribute, constant.place, {}};
      if (const auto* integer = std::get_if<std::int64_t>(&constant.value)) {
        percept.value = *integer;
      } else if (const auto* number = std::get_if<double>(&constant.value)) {
        percept.value = *number;
      } else {
        percept.value = std::string_view(std::get<std::string>(constant.value));
      }
      log_->Add(percept);
    }
    shown.constants.push_back(std::move(constant));
  }
  for (const Constant& gone : old) {
    if (gone.element == nullptr) continue;
    NoteGone(shown.path, gone.attribute, gone.place);
    agent_->DestroyWME(gone.element);
  }
}

void GraphMirror::NoteGone(std::string_view path, std::string_view attribute, std::uint32_t place) {
  if (log_ != nullptr) log_->Add(mind::PerceptGone{path, attribute, place});
}

}  // namespace soarbox::sim
