// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <span>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/decide/memory_link.h"
#include "kernel/longterm/agent_parts.h"

namespace soarbox::kernel {

class Chunker;
class Elaboration;
class Firing;
class GoalStack;
class InstantiationTable;
class LongTerm;
class PreferenceChanges;
class RunControl;
class WmActivation;
class WorkingMemory;

/// One result of a retrieval for working memory: (id ^attribute value).
struct Triple {
  Symbol id, attribute, value;
};

/// Puts the answers of long-term memory into working memory: preferences of an instantiation that no rule made ("Memory
/// System Recall"). Its traces are the elements of the command, so that learning and goal dependency sets follow it as
/// they follow any rule's. Only Retract removes them, but as in Soar 9.6.3 they count as o-supported only if the rules
/// that fired last were: only then the goal dependency set and the activation of working memory include them.
///
/// A retrieval calls Install twice: first for the contents of ^result (the caller keeps these preferences and gives
/// them to Retract when the command changes), then for the contents of the retrieved objects, which live as long as
/// they are linked; then Settle. In this order the contents get the lower time tags, as in Soar 9.6.3.
class Installer {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    WorkingMemory& memory;
    const GoalStack& goals;
    InstantiationTable& instantiations;
    PreferenceChanges& preferences;
    Firing& firing;
    Chunker& chunker;
    Elaboration& elaboration;
    const RunControl& run;
    const LongTerm& long_term;
  };
  explicit Installer(const Uses& uses) : uses_(uses) {}
  explicit Installer(const AgentParts& parts);

  /// A new identifier for the contents, at the level of a state; linked to the long-term identifier unless that is 0.
  Symbol NewIdentifier(char letter, GoalLevel level, std::uint64_t long_term_identifier = 0);
  /// Asserts all triples as one instantiation of the state at `level`, which rests on `command`. Appends what entered
  /// its slot to `made`, if given, in order. Triples that exist already are left out.
  void Install(GoalLevel level, std::span<const WmeId> command, std::span<const Triple> triples,
               std::vector<PreferenceId>* made = nullptr);
  /// Retracts preferences, last first, and empties the list.
  void Retract(std::vector<PreferenceId>& made);
  /// Decides the slots that changed and updates the match. Call after something was installed or retracted.
  void Settle();

 private:
  bool GivesOSupport() const;
  /// Null if working memory has none.
  WmActivation* Activation() const;

  Uses uses_;
  std::vector<PreferenceId> preferences_;  ///< Of the current instantiation.
};

}  // namespace soarbox::kernel
