// SPDX-License-Identifier: BSD-2-Clause
#include "sim/graph_mirror.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace soarbox::sim {
namespace {

using script::PerceptGraph;

constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

std::string WithPlace(const std::string& attribute, std::uint32_t place) {
  return place == 0 ? attribute : attribute + "#" + std::to_string(place);
}

/// Valid as long as the value.
mind::Value ValueOf(const PerceptGraph::Value& value) {
  if (const auto* integer = std::get_if<std::int64_t>(&value)) return *integer;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::string_view(std::get<std::string>(value));
}

}  // namespace

GraphMirror::GraphMirror(PerceptLink& link) : link_(link) {
  link.Include([this](std::vector<PerceptLink::Again>& again) {
    if (nodes_.empty()) return;
    is_written_.assign(nodes_.size(), false);
    is_written_[0] = true;
    ListAgain(0, again);
  });
}

void GraphMirror::ListAgain(std::size_t n, std::vector<PerceptLink::Again>& again) {
  Node& node = nodes_[n];
  node.id = n == 0 ? link_.InputLink() : node.id;
  for (Constant& constant : node.constants) {
    if (constant.element == 0) continue;
    again.push_back({constant.element, [this, &node, &constant](std::vector<PerceptLink::Again>&) {
                       constant.element = link_.input()->Add(node.id, constant.attribute, ValueOf(constant.value));
                     }});
  }
  for (Link& link : node.links) {
    if (link.element == 0) continue;
    again.push_back({link.element,
                     [this, &node, &link](std::vector<PerceptLink::Again>& below) { WriteAgain(node, link, below); }});
  }
}

/// The first link to an object creates it.
void GraphMirror::WriteAgain(Node& node, Link& link, std::vector<PerceptLink::Again>& below) {
  Handle& to = nodes_[link.node].id;
  if (is_written_[link.node]) {
    link.element = link_.input()->AddLink(node.id, link.attribute, to);
    return;
  }
  link.element = link_.input()->AddObject(node.id, link.attribute, to);
  is_written_[link.node] = true;
  ListAgain(link.node, below);
}

void GraphMirror::Show(const PerceptGraph& graph) {
  if (link_.input() == nullptr) return;
  Match(graph);
  DropLinks();
  MakeObjects();
  for (std::size_t n = 0; n < next_.size(); ++n)
    ShowConstants(graph.nodes[n], next_[n], before_[n] == kNone ? nullptr : &nodes_[before_[n]]);
  // Links to existing objects are created last, when all objects exist.
  for (Node& node : next_) {
    for (Link& link : node.links) {
      if (link.is_first || link.element != 0 || node.id == 0 || next_[link.node].id == 0) continue;
      link.element = link_.input()->AddLink(node.id, link.attribute, next_[link.node].id);
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
      const std::uint32_t place = places[wanted.attribute]++;
      // Working memory is a set: only one of several equal elements exists.
      const bool is_there = is_met[wanted.node] && std::ranges::any_of(next_[n].links, [&](const Link& other) {
                              return other.node == wanted.node && other.attribute == wanted.attribute;
                            });
      if (is_there) continue;
      Link& link = next_[n].links.emplace_back();
      link.attribute = wanted.attribute;
      link.place = place;
      link.node = wanted.node;
      const std::string& key = graph.nodes[wanted.node].key;
      link.name = key.empty() ? WithPlace(link.attribute, link.place) : link.attribute + "=" + key;
      link.is_first = !is_met[wanted.node];
      is_met[wanted.node] = true;
      if (link.is_first) next_[wanted.node].path = next_[n].path + WithPlace(link.attribute, link.place) + ".";
      if (before == nullptr) continue;
      const auto at = std::ranges::find_if(before->links, [&](const Link& old) {
        return old.name == link.name && old.is_first == link.is_first && old.element != 0;
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
    if (before_[n] != kNone) next_[n].id = n == 0 ? link_.InputLink() : nodes_[before_[n]].id;
  if (!next_.empty()) next_[0].id = link_.InputLink();
}

/// Removes what the new graph does not have: first additional links to objects, then the objects.
void GraphMirror::DropLinks() {
  std::vector<Handle> kept;
  for (const Node& node : next_)
    for (const Link& link : node.links)
      if (link.element != 0) kept.push_back(link.element);
  std::ranges::sort(kept);
  const auto is_kept = [&](const Link& link) { return std::ranges::binary_search(kept, link.element); };
  for (const Node& node : nodes_)
    for (const Link& link : node.links)
      if (!link.is_first && link.element != 0 && !is_kept(link)) link_.input()->Remove(link.element);
  for (std::size_t n = 0; n < nodes_.size(); ++n) {
    if (!stays_[n]) continue;  // It is removed together with its object.
    for (const Link& link : nodes_[n].links) {
      if (!link.is_first || link.element == 0 || is_kept(link)) continue;
      NoteGone(nodes_[n].path, link.attribute, link.place);
      link_.input()->Remove(link.element);
    }
  }
}

void GraphMirror::MakeObjects() {
  for (Node& node : next_) {
    for (Link& link : node.links) {
      if (!link.is_first || link.element != 0 || node.id == 0) continue;
      link.element = link_.input()->AddObject(node.id, link.attribute, next_[link.node].id);
    }
  }
}

void GraphMirror::ShowConstants(const PerceptGraph::Node& wanted, Node& shown, const Node* before) {
  std::vector<Constant> old = before == nullptr ? std::vector<Constant>() : before->constants;
  std::map<std::string, std::uint32_t> places;
  for (const PerceptGraph::Constant& one : wanted.constants) {
    Constant constant{one.attribute, places[one.attribute]++, one.value};
    // Working memory is a set: only one of several equal elements exists.
    const bool is_there = std::ranges::any_of(shown.constants, [&](const Constant& other) {
      return other.attribute == constant.attribute && other.value == constant.value;
    });
    if (is_there) continue;
    const auto at = std::ranges::find_if(old, [&](const Constant& other) {
      return other.attribute == constant.attribute && other.place == constant.place && other.element != 0;
    });
    bool has_changed = true;
    if (at != old.end()) {
      has_changed = at->value != constant.value;
      if (!one.is_new && at->value.index() == constant.value.index()) {
        if (has_changed) link_.input()->Change(at->element, ValueOf(constant.value));
        constant.element = std::exchange(at->element, 0);
      }
    }
    if (constant.element == 0) {
      if (at != old.end()) link_.input()->Remove(std::exchange(at->element, 0));
      if (shown.id != 0) constant.element = link_.input()->Add(shown.id, constant.attribute, ValueOf(constant.value));
    }
    if (has_changed && log_ != nullptr)
      log_->Add(mind::PerceptChanged{shown.path, constant.attribute, constant.place, ValueOf(constant.value)});
    shown.constants.push_back(std::move(constant));
  }
  for (const Constant& gone : old) {
    if (gone.element == 0) continue;
    NoteGone(shown.path, gone.attribute, gone.place);
    link_.input()->Remove(gone.element);
  }
}

void GraphMirror::NoteGone(std::string_view path, std::string_view attribute, std::uint32_t place) {
  if (log_ != nullptr) log_->Add(mind::PerceptGone{path, attribute, place});
}

}  // namespace soarbox::sim
