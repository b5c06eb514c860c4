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

/// The choices that an agent had, as a tree for each level of the goal stack: operators by what they look like, and
/// behind the one that was taken the choices that came next (`rl --trace`). It grows until it is cleared.
class ChoiceGraph {
 public:
  struct Node;
  struct Branch {
    std::uint64_t begun = 0;            ///< How often the agent had begun anew when it was last a candidate.
    std::optional<double> probability;  ///< That it had then; none if no learning rule spoke for it or it was alone.
    std::unique_ptr<Node> next;         ///< Null if it was never taken.
  };
  struct Node {
    std::map<std::vector<std::string>, Branch> branches;  ///< By "^name x", then its other attributes and values.
  };

  /// What it uses of the agent.
  struct Uses {
    const SymbolTable& symbols;
    const WorkingMemory& memory;
    const GoalStack& goals;
    const AgentCounters& counters;
    const ExplorationSettings& exploration;
  };
  explicit ChoiceGraph(const Uses& uses) : uses_(uses) {}

  /// A choice in the goal of this level. `learned`: for each candidate, whether a learning rule speaks for it.
  void Add(GoalLevel level, std::span<const Candidate> candidates, const Candidate& winner,
           const std::vector<bool>& learned);
  /// The goal of this level is new: choices begin at the root.
  void Begin(GoalLevel level);
  /// All levels begin at their roots, and branches count from there on as of a new beginning.
  void BeginAll();
  void BeginAt(GoalLevel level);
  /// Forgets the choices of a level, or of all.
  void Clear(GoalLevel level);
  void ClearAll();
  /// Where a level's choices begin; null if there is no such goal, or they were cleared and not begun since.
  const Node* Root(GoalLevel level) const;

 private:
  struct Level {
    Node root;
    Node* at = nullptr;  ///< Where its goal stands; null: at the root.
    bool cleared = false;
    bool used = false;
  };
  Level& At(GoalLevel level);
  std::vector<std::string> Look(Symbol op) const;

  Uses uses_;
  std::map<GoalLevel, Level> levels_;
  std::uint64_t begun_ = 0;  ///< By command.
  inline static const Node kEmpty{};
};

}  // namespace soarbox::kernel
