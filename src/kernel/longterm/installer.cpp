// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/installer.h"

#include "kernel/decide/elaboration.h"
#include "kernel/decide/firing.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/decide/run_control.h"
#include "kernel/learn/chunker.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/wm_activation.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

Installer::Installer(const AgentParts& parts)
    : uses_{parts.memory,      parts.goals, parts.instantiations, parts.preferences, parts.firing, parts.chunker,
            parts.elaboration, parts.run,   parts.long_term} {}

Symbol Installer::NewIdentifier(char letter, GoalLevel level, std::uint64_t long_term_identifier) {
  const Symbol id = uses_.memory.NewIdentifier(letter, level);
  if (long_term_identifier != 0) uses_.memory.SetLongTerm(id, long_term_identifier);
  return id;
}

bool Installer::GivesOSupport() const {
  const Elaboration& elaboration = uses_.elaboration;
  // As in Soar, an apply phase without firings counts as one of o-supported rules.
  const bool nothing_fired = uses_.run.phase() == Phase::kOutput && elaboration.count() == 0;
  return nothing_fired || elaboration.firing_type() == FiringType::kPe;
}

void Installer::Install(GoalLevel level, std::span<const WmeId> command, std::span<const Triple> triples,
                        std::vector<PreferenceId>* made) {
  if (triples.empty()) return;
  const bool o_support = GivesOSupport();
  const InstantiationId id = uses_.instantiations.Make();
  {
    Instantiation& instantiation = uses_.instantiations[id];
    instantiation.goal = uses_.goals.at(level).id;
    instantiation.level = level;
    instantiation.o_support = o_support;
    instantiation.held = true;
  }
  if (WmActivation* const activation = o_support ? Activation() : nullptr) activation->NoteAnswer(id, command);
  if (level > 1) {
    uses_.firing.TraceConditions(id, command);
    if (uses_.chunker.settings().learning()) uses_.chunker.NoteFiring(id);
  }
  // (The list of an instantiation's preferences is in the reverse order.)
  preferences_.clear();
  for (const Triple& triple : triples) {
    preferences_.push_back(uses_.preferences.Make(id, triple.id, triple.attribute, triple.value, Symbol(),
                                                  PreferenceType::kAcceptable, o_support));
  }
  uses_.preferences.LinkToGoal(id);
  for (const PreferenceId preference : preferences_) {
    if (!uses_.preferences.Assert(preference)) {
      uses_.preferences.FreeIfUnused(preference);
    } else if (made != nullptr) {
      uses_.preferences.AddReference(preference);
      made->push_back(preference);
    }
  }
  uses_.instantiations[id].held = false;
  uses_.preferences.FreeIfUnused(id);
}

void Installer::Retract(std::vector<PreferenceId>& made) {
  while (!made.empty()) {
    const PreferenceId preference = made.back();
    made.pop_back();
    uses_.preferences.Retract(preference);
    uses_.preferences.DropReference(preference);
  }
}

WmActivation* Installer::Activation() const {
  return static_cast<WmActivation*>(uses_.long_term.module(LongTerm::ModuleKind::kActivation));
}

void Installer::Settle() {
  uses_.elaboration.ApplyWorkingMemoryChanges();
  if (WmActivation* const activation = Activation()) activation->ForgetAnswers();
}

}  // namespace soarbox::kernel
