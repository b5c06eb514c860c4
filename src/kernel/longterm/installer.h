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

/// Adds the results of long-term memory to working memory, as preferences of an instantiation without a rule ("Memory
/// System Recall"). Its traces are the elements of the command, so that learning and goal dependency sets treat it like
/// the instantiation of a rule. The preferences are removed only by Retract. As in Soar 9.6.3, they count as
/// o-supported only if the last rules that fired were o-supported: only then goal dependency sets and the activation of
/// working memory include them.
///
/// A retrieval calls Install twice: first for the contents of ^result, then for the contents of the retrieved objects.
/// Then it calls Settle. Slots that changed last are decided first, so the contents of the retrieved objects get the
/// lower time tags, as in Soar 9.6.3. The caller stores the preferences of ^result and passes them to Retract when the
/// command changes. Retrieved objects live as long as they are linked.
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
  /// Asserts all triples as one instantiation of the state at `level`, which depends on `command`. Appends the
  /// preferences that entered their slots to `made`, if given, in order. Skips existing triples.
  void Install(GoalLevel level, std::span<const WmeId> command, std::span<const Triple> triples,
               std::vector<PreferenceId>* made = nullptr);
  /// Retracts preferences, the last first, and empties the list.
  void Retract(std::vector<PreferenceId>& made);
  /// Decides the changed slots and updates the match. Call it after Install or Retract.
  void Settle();

 private:
  bool GivesOSupport() const;
  /// Returns null if working memory has none.
  WmActivation* Activation() const;

  Uses uses_;
  std::vector<PreferenceId> preferences_;  ///< Of the current instantiation.
};

}  // namespace soarbox::kernel
