// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include "kernel/memory/element_listener.h"

namespace soarbox::kernel {

class Agent;
struct AgentCounters;
class Descriptions;
class GoalDependencySets;
class GoalStack;
class InputLink;
class Modules;
class Observers;
class RunControl;
class SymbolTable;
class WorkingMemory;

/// Forwards the events of working memory elements to the parts of an agent: goal dependency sets, the input link,
/// modules, and observers.
class ElementEvents final : public ElementListener {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    Agent& agent;
    const SymbolTable& symbols;
    const WorkingMemory& memory;
    const GoalStack& goals;
    AgentCounters& counters;
    const Observers& observers;
    Modules& modules;
    InputLink& input;
    const Descriptions& descriptions;
    GoalDependencySets& gds;
    RunControl& run;
  };
  explicit ElementEvents(const Uses& uses) : uses_(uses) {}

  void AttributeUsed(Symbol attribute) override;
  void DependencyLost(WmeId wme) override;
  void DependencyForgotten(WmeId wme) override;
  void InputElementRemoved(std::uint32_t element) override;
  bool FlushBegins(std::size_t added, std::size_t removed) override;
  void FirstWasLost(WmeId wme) override;
  void Entered(WmeId wme) override;
  void Left(WmeId wme) override;
  void RuleInterrupts() override;
  void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) override;

 private:
  Uses uses_;
};

}  // namespace soarbox::kernel
