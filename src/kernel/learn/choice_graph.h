// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/decide/preference_semantics.h"

namespace soarbox::kernel {

struct AgentCounters;
struct ExplorationSettings;
class GoalStack;
class SymbolTable;
class WorkingMemory;

/// The choices of an agent as a tree for each level of the goal stack (`rl --trace`). A node contains the candidate
/// operators by their appearance; the branch of the selected one leads to the next choice. It grows until it is
/// cleared.
class ChoiceGraph {
 public:
  struct Node;
  struct Branch {
    std::uint64_t begun = 0;            ///< Number of restarts at the time when it was last a candidate.
    std::optional<double> probability;  ///< Its probability at that time; none if no learning rule supported it or if
                                        ///< it was the only candidate.
    std::unique_ptr<Node> next;         ///< Null if it was never selected.
  };
  struct Node {
    std::map<std::vector<std::string>, Branch> branches;  ///< By "^name x" and the other attributes and values.
  };

  /// The parts of the agent that it uses.
  struct Uses {
    const SymbolTable& symbols;
    const WorkingMemory& memory;
    const GoalStack& goals;
    const AgentCounters& counters;
    const ExplorationSettings& exploration;
  };
  explicit ChoiceGraph(const Uses& uses) : uses_(uses) {}

  /// Adds a choice in the goal of this level. `learned`: for each candidate, whether a learning rule supports it.
  void Add(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner,
           const std::vector<bool>& learned);
  /// The goal of this level is new: its choices begin at the root.
  void Begin(GoalLevel level);
  /// Restarts: the choices of all levels begin at their roots, and branches are marked with the new number of restarts.
  void BeginAll();
  void BeginAt(GoalLevel level);
  /// Removes the choices of a level; without an argument, of all levels.
  void Clear(GoalLevel level);
  void ClearAll();
  /// The root of a level's tree; null if there is no such goal, or if it was cleared and not used since.
  const Node* Root(GoalLevel level) const;

 private:
  struct Level {
    Node root;
    Node* at = nullptr;  ///< The current node of its goal; null: the root.
    bool cleared = false;
    bool used = false;
  };
  Level& At(GoalLevel level);
  std::vector<std::string> Look(Symbol op) const;

  Uses uses_;
  std::map<GoalLevel, Level> levels_;
  std::uint64_t begun_ = 0;  ///< Number of restarts by command.
  inline static const Node kEmpty{};
};

}  // namespace soarbox::kernel
