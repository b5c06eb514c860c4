// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/agent_core.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <limits>
#include <new>
#include <utility>

#include "kernel/decide/invariants.h"
#include "kernel/decide/rule_sharing.h"
#include "kernel/imagery/imagery.h"

namespace soarbox::kernel {

AgentCore::~AgentCore() = default;

AgentCore::AgentCore(Agent& owner, std::string agent_name)
    : agent(owner),
      name(std::move(agent_name)),
      memory(symbols),
      links(memory),
      rete(symbols, memory.wmes()),
      observers(owner),
      rule_changes(*this),
      element_events({owner, symbols, memory, goals, counters, observers, modules, input, descriptions, gds, run}),
      changes(memory, links, rete, output_marks, element_events),
      input(symbols, memory, changes),
      output(memory, output_marks),
      preferences(*this),
      context(*this),
      firing(*this),
      selections({memory, goals, preferences}),
      chunker({owner,       symbols,         memory,    goals,        instantiations, rete,      productions,  changes,
               preferences, goal_changes,    firing,    run,          selections,     justifier, descriptions, settings,
               counters,    expected_values, observers, rule_changes, modules}),
      justifier({owner, memory, goals, instantiations, rete, changes, preferences, firing, chunker, descriptions,
                 settings, counters, observers, rule_changes}),
      reinforcement({owner, symbols, memory, goals, instantiations, rete, settings, counters, exploration,
                     expected_values, productions, observers, rule_changes, modules}),
      descriptions({memory, instantiations, rete, justifier}),
      slot_decision({memory, changes, preferences, gds, decision}),
      gds({owner, memory, goals, instantiations, firing, goal_changes, descriptions, observers}),
      goal_changes(*this),
      decision(*this),
      elaboration(*this),
      run(*this),
      long_term({owner, symbols, memory, goals, instantiations, rete, observers, counters, changes, preferences, firing,
                 chunker, elaboration, run, output, justifier, goal_changes, modules, long_term}) {
  rete.OnMixedSupport([this](ProductionId production) {
    const std::string rule(rete.production(production)->name);
    observers.Print("WARNING:  Operator elaborations mixed with operator applications\nAssigning i_support to prod " +
                    rule);
  });
}

Symbol AgentCore::NameOf(const Production& rule) {
  const SymbolTable::PinScope pin(symbols);
  return symbols.String(rule.name);
}

void AgentCore::OfferRules() {
  rules_changed = false;
  ShareRules(symbols, rete, rules, productions);
}

// Sweeping ------------------------------------------------------------------------------------------------------------

void AgentCore::Sweep() {
  if (!changes.empty() || links.HasWork()) return;
  identifier_marks.assign(memory.identifier_limit(), 0);
  symbols.BeginMark();
  std::uint8_t* const marks = identifier_marks.data();
  const std::size_t limit = identifier_marks.size();
  const auto mark = [&](Symbol symbol) {
    if (symbol.IsIdentifier()) {
      if (symbol.index() < limit) marks[symbol.index()] = 1;
    } else {
      symbols.Mark(symbol);
    }
  };
  for (std::uint32_t index = 0; index < memory.wmes().size(); ++index) {
    const Wme& wme = memory.wmes()[index];
    if (!wme.live && memory.record(static_cast<WmeId>(index)).references == 0) continue;
    mark(wme.id);
    mark(wme.attribute);
    mark(wme.value);
  }
  // The elements of matches that wait for their retraction.
  for (const WmeId dead : changes.dead()) {
    mark(memory.wme(dead).id);
    mark(memory.wme(dead).attribute);
    mark(memory.wme(dead).value);
  }
  memory.ForEachPreference([&](const Preference& preference) {
    mark(preference.id);
    mark(preference.attribute);
    mark(preference.value);
    mark(preference.referent);
  });
  memory.ForEachSlot([&](SlotId slot) {
    mark(memory.slot(slot).id);
    mark(memory.slot(slot).attribute);
  });
  for (GoalLevel level = 1; level <= goals.depth(); ++level) mark(goals.at(level).id);
  instantiations.ForEach([&](const Instantiation& instantiation) { mark(instantiation.goal); });
  input.Mark(mark);
  output.Mark(mark);
  modules.Mark(std::ref(mark));
  const std::size_t identifiers_before = memory.identifier_count(), constants_before = symbols.UnpinnedCount();
  for (std::uint32_t index = 0; index < memory.identifier_limit(); ++index) {
    const Symbol id(Symbol::Tag::kIdentifier, index);
    if (marks[index] != 0 || !memory.identifier(id).live) continue;
    input.IdentifierGone(id);
    output_marks.Unmark(id);
    if (modules.Wants(ModuleHook::kIdentifiers)) modules.IdentifierFreed(id);
    memory.FreeIdentifier(id);
  }
  symbols.Sweep();
  // If little was freed, memory is growing: the next sweep is worthwhile only after it has grown much more.
  const auto next = [](std::size_t before, std::size_t now) { return 2 * now > before ? 4 * now : 2 * now; };
  sweep_identifiers_at = std::max(kLeastIdentifiersSwept, next(identifiers_before, memory.identifier_count()));
  sweep_constants_at = std::max(kLeastConstantsSwept, next(constants_before, symbols.UnpinnedCount()));
}

// Beginning -----------------------------------------------------------------------------------------------------------

void AgentCore::Initialize(bool announce) {
  modules.BeforeInit();
  if (!run.broken()) goal_changes.TakeAllApart();
  justifier.ExciseAll();
  rete.Clear();
  goals.Clear();
  instantiations.Clear();
  selections.Clear();
  justifier.Clear();
  preferences.Clear();
  changes.Clear();
  links.Clear();
  decision.Clear();
  elaboration.Clear();
  run.Clear();
  output.Reset();
  firing.made().clear();
  for (const ProductionId production : excisions) rete.ExciseProduction(production);
  excisions.clear();
  memory.Clear();
  symbols.ResetIdentifierCounters();
  const std::uint64_t inits = counters.inits;
  counters = AgentCounters{};
  counters.inits = inits;
  goal_changes.MakeTopState();
  elaboration.ApplyWorkingMemoryChanges();
  if (announce && observers.Wants(Event::kDecision)) {
    const GoalInfo top = descriptions.Describe(goals.top());
    observers.Notify(Event::kDecision, [&](Observer& o) { o.OnDecision(agent, top, 0); });
  }
  goal_changes.MakeIoLinks();
  input.Reset(goal_changes.input_link());
  elaboration.ApplyWorkingMemoryChanges();
  modules.AfterInit();
}

void AgentCore::StopIfOutgrown() const {
  constexpr std::size_t kUnlimited = std::numeric_limits<std::size_t>::max();
  if (settings.most_memory_bytes != kUnlimited && agent.MemoryBytes() > settings.most_memory_bytes) {
    throw std::bad_alloc();
  }
}

#ifdef SOARBOX_CHECK_INVARIANTS
namespace {

[[noreturn]] void Fail(const AgentCore& core, const std::string& violation) {
  std::fprintf(stderr, "soarbox: agent %s: invariant violated: %s\n", core.name.c_str(), violation.c_str());
  std::abort();
}

}  // namespace

void AgentCore::CheckAfterPhase() const {
  std::string violation = FindViolation(*this);
  if (violation.empty()) violation = FindDanglingHandle(*this);
  if (!violation.empty()) Fail(*this, violation);
}

void AgentCore::CheckSupported(const Preference& left_out) const {
  const SlotId slot = memory.FindSlot(left_out.id, left_out.attribute);
  if (slot != SlotId::kNone && left_out.level == 1) {
    for (PreferenceId p = memory.slot(slot).acceptable; p != PreferenceId::kNone;
         p = memory.preference(p).next_in_slot) {
      const Preference& kept = memory.preference(p);
      if (kept.value == left_out.value && kept.o_supported && kept.level == 1 && kept.in_slot) return;
    }
  }
  Fail(*this, "no preference of the top state replaces the one that was left out of " + ToString(symbols, left_out.id) +
                  " ^" + ToString(symbols, left_out.attribute));
}
#else
void AgentCore::CheckAfterPhase() const {}
void AgentCore::CheckSupported(const Preference&) const {}
#endif

}  // namespace soarbox::kernel
