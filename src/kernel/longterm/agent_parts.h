// SPDX-License-Identifier: BSD-2-Clause
#pragma once

namespace soarbox::kernel {

class Agent;
struct AgentCounters;
class Chunker;
class Elaboration;
class Firing;
class GoalChanges;
class GoalStack;
class InstantiationTable;
class LongTerm;
class Modules;
class Observers;
class Justifier;
class OutputLink;
class PreferenceChanges;
class Rete;
class RunControl;
class SymbolTable;
class WmeChanges;
class WorkingMemory;

/// The parts of an agent that long-term memory uses. LongTerm stores them; modules, which may be created later, receive
/// them from it.
struct AgentParts {
  Agent& agent;
  SymbolTable& symbols;
  WorkingMemory& memory;
  GoalStack& goals;
  InstantiationTable& instantiations;
  const Rete& rete;
  const Observers& observers;
  const AgentCounters& counters;
  WmeChanges& changes;
  PreferenceChanges& preferences;
  Firing& firing;
  Chunker& chunker;
  Elaboration& elaboration;
  const RunControl& run;
  const OutputLink& output;
  const Justifier& justifier;
  GoalChanges& goal_changes;
  Modules& modules;
  LongTerm& long_term;
};

}  // namespace soarbox::kernel
