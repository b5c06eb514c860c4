// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/installer.h"

#include "kernel/decide/engine.h"

namespace soarbox::kernel {

Symbol Installer::NewIdentifier(char letter, GoalLevel level, std::uint64_t long_term_identifier) {
  const Symbol id = engine_.memory.NewIdentifier(letter, level);
  if (long_term_identifier != 0) engine_.memory.SetLongTerm(id, long_term_identifier);
  return id;
}

bool Installer::GivesOSupport() const {
  const Elaboration& elaboration = engine_.elaboration;
  // An apply phase in which nothing fires counts as one of o-supported rules.
  const bool nothing_fired = engine_.run.phase() == Phase::kOutput && elaboration.count() == 0;
  return nothing_fired || elaboration.firing_type() == FiringType::kPe;
}

void Installer::Install(GoalLevel level, std::span<const WmeId> command, std::span<const Triple> triples,
                        std::vector<PreferenceId>* made) {
  if (triples.empty()) return;
  const bool o_support = GivesOSupport();
  const InstantiationId id = engine_.instantiations.Make();
  {
    Instantiation& instantiation = engine_.instantiations[id];
    instantiation.goal = engine_.goals.at(level).id;
    instantiation.level = level;
    instantiation.o_support = o_support;
    instantiation.held = true;
  }
  if (level > 1) {
    engine_.firing.TraceConditions(id, command);
    if (engine_.chunker.settings().learning()) engine_.chunker.NoteFiring(id);
  }
  // An instantiation lists its preferences last first.
  std::vector<PreferenceId> preferences;
  preferences.reserve(triples.size());
  for (const Triple& triple : triples) {
    preferences.push_back(engine_.preferences.Make(id, triple.id, triple.attribute, triple.value, Symbol(),
                                                   PreferenceType::kAcceptable, o_support));
  }
  engine_.preferences.LinkToGoal(id);
  for (const PreferenceId preference : preferences) {
    if (!engine_.preferences.Assert(preference)) {
      engine_.preferences.FreeIfUnused(preference);
    } else if (made != nullptr) {
      engine_.preferences.AddReference(preference);
      made->push_back(preference);
    }
  }
  engine_.instantiations[id].held = false;
  engine_.preferences.FreeIfUnused(id);
}

void Installer::Retract(std::vector<PreferenceId>& made) {
  while (!made.empty()) {
    const PreferenceId preference = made.back();
    made.pop_back();
    engine_.preferences.Retract(preference);
    engine_.preferences.DropReference(preference);
  }
}

void Installer::Settle() {
  engine_.elaboration.ApplyWorkingMemoryChanges();
}

}  // namespace soarbox::kernel
