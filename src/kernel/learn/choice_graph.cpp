// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/choice_graph.h"

#include <algorithm>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/exploration.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

std::vector<std::string> ChoiceGraph::Look(Symbol op) const {
  const WorkingMemory& memory = uses_.memory;
  std::vector<std::string> look{"^name"};
  for (SlotId slot = memory.identifier(op).slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
    for (WmeId id = memory.slot(slot).wmes; id != WmeId::kNone; id = memory.record(id).next) {
      const Wme& wme = memory.wme(id);
      const std::string value = ToString(uses_.symbols, wme.value, false);
      if (wme.attribute == words::kName) {
        look.front() += " " + value;
      } else {
        look.push_back("^" + ToString(uses_.symbols, wme.attribute, false) + " " + value);
      }
    }
  }
  std::sort(look.begin() + 1, look.end());
  return look;
}

ChoiceGraph::Level& ChoiceGraph::At(GoalLevel level) {
  Level& found = levels_[level];
  found.used = true;
  return found;
}

void ChoiceGraph::Add(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner,
                      const std::vector<bool>& learned) {
  Level& tree = At(level);
  Node& node = tree.at != nullptr ? *tree.at : tree.root;
  std::vector<double> chances;
  if (candidates.size() > 1) chances = SelectionChances(candidates, uses_.exploration);
  Node* next = nullptr;
  for (std::size_t n = 0; n < candidates.size(); ++n) {
    Branch& branch = node.branches[Look(candidates[n].value)];
    branch.begun = begun_ + uses_.counters.inits;
    branch.probability.reset();
    if (n < chances.size() && learned[n]) branch.probability = chances[n];
    if (candidates[n].value != winner.value) continue;
    if (branch.next == nullptr) branch.next = std::make_unique<Node>();
    next = branch.next.get();
  }
  if (next != nullptr) tree.at = next;
}

void ChoiceGraph::Begin(GoalLevel level) {
  const auto tree = levels_.find(level);
  if (tree != levels_.end()) tree->second.at = nullptr;
}

void ChoiceGraph::BeginAt(GoalLevel level) {
  if (level <= uses_.goals.depth()) {
    Level& tree = At(level);
    tree.at = nullptr;
    tree.cleared = false;
  }
  ++begun_;
}

void ChoiceGraph::BeginAll() {
  for (GoalLevel level = 1; level <= uses_.goals.depth(); ++level) {
    Level& tree = At(level);
    tree.at = nullptr;
    tree.cleared = false;
  }
  ++begun_;
}

void ChoiceGraph::Clear(GoalLevel level) {
  Level& tree = levels_[level];
  tree = Level();
  tree.cleared = true;
}

void ChoiceGraph::ClearAll() {
  for (auto& [level, tree] : levels_) Clear(level);
  for (GoalLevel level = 1; level <= uses_.goals.depth(); ++level) Clear(level);
}

const ChoiceGraph::Node* ChoiceGraph::Root(GoalLevel level) const {
  const auto tree = levels_.find(level);
  if (tree == levels_.end()) return level <= uses_.goals.depth() ? &kEmpty : nullptr;
  return tree->second.cleared && !tree->second.used ? nullptr : &tree->second.root;
}

}  // namespace soarbox::kernel
