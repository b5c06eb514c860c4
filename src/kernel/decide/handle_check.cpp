// SPDX-License-Identifier: BSD-2-Clause
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>

#include "kernel/decide/agent_core.h"
#include "kernel/decide/invariants.h"
#include "kernel/rules/rule_symbols.h"

namespace soarbox::kernel {
namespace {

/// One pass over all data of an agent. Keeps the first violation. Texts are built only for violations, because the
/// check runs after every phase.
class HandleCheck {
 public:
  explicit HandleCheck(const AgentCore& core) : core_(core), memory_(core.memory) {}

  std::string Run() {
    CheckSlots();
    CheckPreferences();
    CheckInstantiations();
    CheckJustifications();
    CheckElements();
    CheckMatches();
    CheckRules();
    return violation_;
  }

 private:
  /// `what` is a text, or a function that returns it.
  template <typename What>
  void Require(bool right, What&& what) {
    if (right || !violation_.empty()) return;
    if constexpr (std::is_invocable_v<What>) {
      violation_ = std::forward<What>(what)();
    } else {
      violation_ = what;
    }
  }
  void RequireLive(Symbol symbol, const char* holder) {
    if (!symbol || !violation_.empty()) return;
    Require(core_.symbols.IsLive(symbol), [&] { return std::string(holder) + " holds a symbol that is gone"; });
    if (symbol.IsIdentifier()) {
      Require(memory_.identifier(symbol).live,
              [&] { return std::string(holder) + " holds an identifier that is gone"; });
    }
  }
  void RequireLive(PreferenceId preference, const char* holder) {
    Require(preference.record->live, [&] { return std::string(holder) + " holds a preference that is gone"; });
  }
  std::string TextOf(Symbol id, Symbol attribute, Symbol value) const {
    return "(" + ToString(core_.symbols, id) + " ^" + ToString(core_.symbols, attribute) + " " +
           ToString(core_.symbols, value) + ")";
  }

  void CheckSlots() {
    memory_.ForEachSlot([&](SlotId id) {
      const Slot& slot = memory_.slot(id);
      RequireLive(slot.id, "a slot");
      RequireLive(slot.attribute, "a slot");
      std::uint32_t substate_facts = 0;
      for (const PreferenceId first : {slot.acceptable, slot.others}) {
        GoalLevel level = 0;
        for (PreferenceId p = first; p != PreferenceId::kNone; p = memory_.preference(p).next_in_slot) {
          const Preference& preference = memory_.preference(p);
          Require(preference.slot == id && preference.id == slot.id && preference.attribute == slot.attribute,
                  "a slot holds a preference of another one");
          Require(preference.level >= level, "a slot's preferences are out of order");
          level = preference.level;
          const bool is_fact = preference.type == PreferenceType::kAcceptable && preference.o_supported;
          substate_facts += is_fact && preference.level > 1 ? 1 : 0;
          ++references_[p.record];
        }
      }
      Require(substate_facts == slot.substate_facts, "a slot miscounts the facts of substates");
    });
    for (const PreferenceId retired : core_.preferences.retired_preferences()) {
      RequireLive(retired, "the list of retracted preferences");
      ++references_[retired.record];
    }
    core_.selections.ForEachPreference([&](PreferenceId p) {
      RequireLive(p, "the record of a selection");
      ++references_[p.record];
    });
    for (GoalLevel level = 1; level <= core_.goals.depth(); ++level) {
      for (WmeId wme = memory_.slot(core_.goals.at(level).operator_slot).wmes; wme != WmeId::kNone;
           wme = memory_.record(wme).next) {
        ++references_[memory_.record(wme).preference.record];
      }
    }
  }

  void CheckPreferences() {
    memory_.ForEachPreference([&](const Preference& preference) {
      for (const Symbol symbol : {preference.id, preference.attribute, preference.value, preference.referent}) {
        RequireLive(symbol, "a preference");
      }
      Require(preference.instantiation != InstantiationId::kNone && preference.instantiation.record->live,
              "the instantiation of a preference is gone");
      if (!violation_.empty()) return;
      Require(preference.instantiation.record->level == preference.level,
              "a preference has another level than its instantiation");
      bool listed = false;
      for (PreferenceId p = preference.instantiation.record->preferences; p != PreferenceId::kNone;
           p = memory_.preference(p).next_of_instantiation) {
        listed |= p.record == &preference;
      }
      Require(listed, "an instantiation does not list its preference");
      if (preference.next_clone != PreferenceId::kNone) {
        RequireLive(preference.next_clone, "a preference");
        Require(preference.next_clone.record->previous_clone.record == &preference,
                "clones are not linked to each other");
      }
    });
  }

  void CheckInstantiations() {
    core_.instantiations.ForEach([&](const Instantiation& instantiation) {
      const InstantiationId id{const_cast<Instantiation*>(&instantiation)};
      RequireLive(instantiation.goal, "an instantiation");
      if (instantiation.production != ProductionId::kNone) {
        ++rules_[Index(instantiation.production)];
        Require(core_.rete.production(instantiation.production) != nullptr, "the rule of an instantiation is gone");
      }
      if (instantiation.match != MatchId::kNone) {
        Require(core_.rete.matches().InstantiationOf(instantiation.match) == id, [&] {
          return "the match of " + std::string(core_.descriptions.ProductionName(id)) +
                 " belongs to another instantiation";
        });
      }
      for (const ConditionTrace& trace : core_.instantiations.Trace(id)) {
        ++elements_[Index(trace.wme)];
        if (trace.preference == PreferenceId::kNone) continue;
        RequireLive(trace.preference, "a condition");
        ++references_[trace.preference.record];
        const Preference& maker = memory_.preference(trace.preference);
        const Wme& wme = memory_.wme(trace.wme);
        Require(maker.id == wme.id && maker.attribute == wme.attribute && maker.value == wme.value,
                "a condition names another preference as the creator of its element");
      }
    });
    core_.modules.ForEachHeld([&](PreferenceId held) {
      RequireLive(held, "a result of long-term memory");
      ++references_[held.record];
    });
    memory_.ForEachPreference([&](const Preference& preference) {
      const auto found = references_.find(&preference);
      const std::uint32_t count = found == references_.end() ? 0 : found->second;
      // Long-term memory can retract its results, so it holds references to their preferences.
      const Instantiation& maker = *preference.instantiation.record;
      const bool may_be_held = maker.production == ProductionId::kNone && maker.justification == 0xFFFFFFFFu;
      Require(preference.references == count || (may_be_held && preference.references == count + 1), [&] {
        return "the preference for " + TextOf(preference.id, preference.attribute, preference.value) + " counts " +
               std::to_string(preference.references) + " references and has " + std::to_string(count);
      });
    });
  }

  void CheckJustifications() {
    for (const std::uint32_t index : core_.justifier.Live()) {
      const Justifier::Record& record = core_.justifier.record(index);
      Require(record.instantiation != InstantiationId::kNone && record.instantiation.record->live &&
                  record.instantiation.record->justification == index,
              "a justification has lost its instantiation");
      if (record.production != ProductionId::kNone) {
        Require(core_.rete.production(record.production) != nullptr, "the rule of a justification is gone");
      }
      for (const WmeId ground : record.grounds) ++elements_[Index(ground)];
    }
    core_.justifier.ForEachLiteral([&](Symbol symbol) { RequireLive(symbol, "a justification"); });
  }

  void CheckElements() {
    for (std::uint32_t index = 0; index < memory_.wmes().size() && violation_.empty(); ++index) {
      const WmeId id = static_cast<WmeId>(index);
      const Wme& wme = memory_.wme(id);
      const WmeRecord& record = memory_.record(id);
      const auto counted = elements_.find(index);
      const std::uint32_t count = counted == elements_.end() ? 0 : counted->second;
      Require(record.references >= count, [&] {
        return "an element counts " + std::to_string(record.references) + " references and has " +
               std::to_string(count);
      });
      if (!wme.live && record.references == 0) continue;
      for (const Symbol symbol : {wme.id, wme.attribute, wme.value}) RequireLive(symbol, "an element");
      if (!wme.live || record.preference == PreferenceId::kNone || !violation_.empty()) continue;
      if (record.slot() != SlotId::kNone && record.slot().record->changed) continue;  // It will be decided later.
      RequireLive(record.preference, "an element");
      const Preference& maker = memory_.preference(record.preference);
      Require(maker.id == wme.id && maker.attribute == wme.attribute && maker.value == wme.value,
              [&] { return "the creator of " + TextOf(wme.id, wme.attribute, wme.value) + " is for another element"; });
    }
  }

  void CheckMatches() {
    const MatchSet& matches = core_.rete.matches();
    matches.ForEachMatch([&](MatchId match) {
      const std::uint32_t rule = matches.ProductionOf(match);
      if (rule != MatchSet::kNil) ++rules_[rule];
      const InstantiationId instantiation = matches.InstantiationOf(match);
      if (matches.StateOf(match) != MatchState::kFired || instantiation == InstantiationId::kNone) return;
      Require(instantiation.record->live && instantiation.record->match == match,
              "a match belongs to an instantiation that is gone");
    });
    for (std::uint32_t rule = 0; rule < matches.rule_limit(); ++rule) {
      const auto found = rules_.find(rule);
      Require(matches.LiveCount(rule) == (found == rules_.end() ? 0 : found->second),
              "a rule miscounts its matches and instantiations");
    }
  }

  void CheckRules() {
    for (const ProductionId rule : core_.rules.loading_order()) {
      const ProductionPtr& production = core_.rete.production(rule);
      Require(production != nullptr, "a rule in the list of rules is gone");
      if (production == nullptr) return;
      ForEachSymbol(*production, [&](Symbol symbol) {
        Require(core_.symbols.IsLive(symbol), "a rule holds a symbol that is gone");
      });
    }
  }

  const AgentCore& core_;
  const WorkingMemory& memory_;
  std::string violation_;
  std::unordered_map<const Preference*, std::uint32_t> references_;
  std::unordered_map<std::uint32_t, std::uint32_t> elements_, rules_;
};

}  // namespace

std::string FindDanglingHandle(const AgentCore& core) {
  return HandleCheck(core).Run();
}

}  // namespace soarbox::kernel
