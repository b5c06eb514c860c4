// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/chunker.h"

#include <algorithm>
#include <map>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/agent_settings.h"
#include "kernel/decide/descriptions.h"
#include "kernel/decide/firing.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/decide/modules.h"
#include "kernel/decide/observers.h"
#include "kernel/decide/preference_changes.h"
#include "kernel/decide/rule_changes.h"
#include "kernel/decide/run_control.h"
#include "kernel/learn/justification.h"
#include "kernel/learn/selection_knowledge.h"
#include "kernel/match/rete.h"
#include "kernel/memory/wme_changes.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {

Chunker::Chunker(const Uses& uses)
    : uses_(uses),
      singletons_({uses.memory, uses.goals, uses.symbols}),
      reader_({uses.memory, uses.goals, uses.instantiations, uses.rete, uses.goal_changes, uses.justifier}),
      results_({uses.memory, uses.instantiations, uses.symbols, uses.firing}),
      backtracer_({uses.agent, uses.memory, uses.goals, uses.instantiations, uses.rete, uses.productions,
                   uses.goal_changes, uses.firing, uses.selections, uses.justifier, uses.observers, uses.descriptions,
                   settings_, statistics_}),
      analysis_({uses.memory, uses.goals, uses.instantiations, singletons_, *this}, reader_),
      carried_({uses.memory, uses.instantiations, uses.justifier}, reader_, analysis_),
      builder_({uses.symbols, uses.memory, uses.goals, uses.instantiations, uses.expected_values, uses.observers,
                statistics_},
               reader_, analysis_, carried_),
      planner_({uses.memory, uses.instantiations, statistics_}, reader_, analysis_, carried_),
      log_({uses.symbols, uses.memory, uses.goals, uses.instantiations, uses.rete, uses.counters, uses.descriptions,
            *this, statistics_},
           reader_, analysis_, builder_) {
  uses_.modules.Attach(*this, Modules::kLast);
}

Chunker::~Chunker() = default;

void Chunker::ModeChanged() {
  // Elements that were created earlier have not been reported.
  if (settings_.automatic_singletons || notes_elements_) singletons_.NoteAll();
  notes_elements_ = settings_.learning() && settings_.automatic_singletons;
  uses_.changes.TellOfAttributes(notes_elements_);
  AskForHooks();
}

void Chunker::AskForHooks() {
  ModuleHooks hooks = 0;
  if (settings_.learning() || !dont_learn_.empty() || !force_learn_.empty() || !item_firings_.empty()) {
    hooks = static_cast<ModuleHooks>(ModuleHook::kStates);
  }
  if (notes_elements_) hooks = hooks | ModuleHook::kAttributes;
  uses_.modules.SetHooks(*this, hooks);
}

void Chunker::SetLearning(Symbol state, bool learn) {
  std::vector<Symbol>& states = learn ? force_learn_ : dont_learn_;
  if (std::ranges::find(states, state) == states.end()) states.push_back(state);
  AskForHooks();
}

void Chunker::RuleExcised(ProductionId rule) {
  learned_.erase(rule);
  uses_.justifier.ForgetDuplicates(rule);
}

void Chunker::StateRemoved(GoalLevel level) {
  const Symbol state = uses_.goals.at(level).id;
  std::erase(dont_learn_, state);
  std::erase(force_learn_, state);
}

void Chunker::Mark(const std::function<void(Symbol)>& mark) {
  uses_.justifier.ForEachLiteral(mark);
  singletons_.ForEachSymbol(mark);
}

void Chunker::AfterInit() {
  dont_learn_.clear();
  force_learn_.clear();
  results_.Clear();
  backtracer_.Clear();
  reader_.Clear();
  log_.Clear();
  explanation_.trace_number = 0;
  cycle_ = ~std::uint64_t{0};
  next_identity_ = 1;
  next_number_ = 0;
  statistics_ = {};
  AskForHooks();
}

// Identities ----------------------------------------------------------------------------------------------------------

void Chunker::StateMade(GoalLevel level) {
  if (level == 2) item_firings_.clear();
  if (!settings_.learning() || level < 2) return;
  uses_.goals.at(level).has_identities = true;
  if (level == 2) next_identity_ = 1;
  if (substate_identity_.size() <= level) substate_identity_.resize(level + 1u, 0);
  substate_identity_[level] = next_identity_;
  CountIdentities(2);  // For the state and its superstate.
}

void Chunker::CountIdentities(std::uint32_t count) {
  next_identity_ += count;
  statistics_.identities_created += count;
}

void Chunker::ItemsMade(std::uint32_t firings) {
  if (!settings_.learning()) return;
  first_item_ = {uses_.instantiations.last_serial() + 1, next_identity_ + 1};
  CountIdentities(2 * firings);
}

void Chunker::ItemMade(WmeId item, std::uint32_t index) {
  if (settings_.learning()) item_firings_[item] = {first_item_.serial + index, first_item_.identity + 2 * index};
}

const Chunker::ItemFiring* Chunker::FiringOfItem(WmeId item) const {
  const auto found = item_firings_.find(item);
  return found == item_firings_.end() ? nullptr : &found->second;
}

std::uint32_t Chunker::NumberOfSpecial(IdentityGraph::Key key) const {
  if (FiringReader::IsItem(key)) {
    const ItemFiring* const firing = FiringOfItem(FiringReader::ItemOf(key));
    return firing != nullptr ? firing->identity : 0;
  }
  if (!FiringReader::IsSuperstateLink(key)) return 0;
  const std::uint32_t level = key.place / 2u;
  return level < substate_identity_.size() ? substate_identity_[level] + key.place % 2u : 0;
}

void Chunker::NoteFiring(InstantiationId id) {
  Instantiation& instantiation = uses_.instantiations[id];
  instantiation.has_identities = true;
  instantiation.first_identity = next_identity_;
  reader_.BeginAnalysis();
  std::uint32_t created = reader_.CountIdentities(id);
  if (const Production* const rule = reader_.Rule(id)) {
    created += static_cast<std::uint32_t>(rule->new_identifiers.size());
  }
  CountIdentities(created);
  reader_.EndAnalysis();
}

void Chunker::NoteCopied(InstantiationId id, std::span<const RuleContext::Copied> copied) {
  reader_.NoteCopied(id, copied);
  if (!uses_.instantiations[id].has_identities) return;
  // Each identifier in the copied elements counts as an identity.
  std::uint32_t created = 0;
  for (const RuleContext::Copied& element : copied) {
    created += 1u + (element.attribute.IsIdentifier() ? 1u : 0u) + (element.value.IsIdentifier() ? 1u : 0u);
  }
  CountIdentities(created);
}

void Chunker::NoteSelection(InstantiationId id) {
  Instantiation& instantiation = uses_.instantiations[id];
  const std::uint32_t selection = uses_.selections.OfGoal(instantiation.level);
  if (instantiation.selection != SelectionKnowledge::kNone) return;
  const Symbol goal = uses_.goals.at(instantiation.level).id;
  const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(id);
  bool tests_selected = false;
  if (selection != SelectionKnowledge::kNone) {
    tests_selected = std::ranges::any_of(traces, [&](const ConditionTrace& trace) {
      const Wme& wme = uses_.memory.wme(trace.wme);
      return wme.id == goal && wme.attribute == words::kOperator && !wme.acceptable;
    });
  }
  if (uses_.preferences.prohibits() != 0) {
    // As in Soar 9.6.3, all prohibit preferences in the slot of the created element count. They may even be about
    // another element or an element of a higher state.
    std::vector<PreferenceId> prohibits;
    for (std::size_t n = traces.size(); n-- > 0;) uses_.selections.CollectProhibits(traces[n].wme, prohibits);
    if (!prohibits.empty()) {
      instantiation.selection =
          uses_.selections.With(std::move(prohibits), tests_selected ? selection : SelectionKnowledge::kNone);
      return;
    }
  }
  if (!tests_selected) return;
  instantiation.selection = selection;
  uses_.selections.AddReference(selection);
}

// Considering a firing ------------------------------------------------------------------------------------------------

void Chunker::BeginCycle() {
  if (cycle_ == uses_.counters.decision_cycles) return;
  cycle_ = uses_.counters.decision_cycles;
  rules_in_cycle_ = justifications_in_cycle_ = 0;
}

void Chunker::TellNotLearned(InstantiationId firing, NotLearned why) const {
  if (!uses_.observers.Wants(Event::kNotLearned)) return;
  const FiringInfo info = uses_.descriptions.DescribeInstantiation(firing);
  uses_.observers.Notify(Event::kNotLearned, [&](Observer& o) { o.OnNotLearned(uses_.agent, why, info); });
}

bool Chunker::IsLeftOut(InstantiationId firing) const {
  const Instantiation& instantiation = uses_.instantiations[firing];
  const auto named = [&](const std::vector<Symbol>& states) {
    return std::ranges::find(states, instantiation.goal) != states.end();
  };
  switch (settings_.mode) {
    case LearnMode::kNever:
      return true;
    case LearnMode::kAlways:
      break;
    case LearnMode::kOnly:
      if (named(force_learn_)) break;
      TellNotLearned(firing, NotLearned::kNotForced);
      return true;
    case LearnMode::kExcept:
      if (!named(dont_learn_)) break;
      TellNotLearned(firing, NotLearned::kExcluded);
      return true;
  }
  if (!settings_.bottom_only || !uses_.goals.at(instantiation.level).learned_below) return false;
  TellNotLearned(firing, NotLearned::kNotLowest);
  return true;
}

void Chunker::Consider(InstantiationId id) {
  BeginCycle();
  for (InstantiationId current = id; uses_.instantiations[current].level > 1;) {
    left_out_ = IsLeftOut(current);
    if (settings_.learning() && rules_in_cycle_ >= settings_.max_chunks) {
      ++statistics_.over_max_chunks;
      TellNotLearned(current, NotLearned::kTooMany);
      return;
    }
    explanation_.level = uses_.instantiations[current].level;
    explanation_.base = current;
    ++explanation_.trace_number;
    reader_.BeginAnalysis();
    if (!results_.Collect(current, explanation_)) return;
    if (uses_.justifier.HasTooManyDuplicates(current, settings_.max_duplicates)) {
      ++statistics_.over_max_duplicates;
      TellNotLearned(current, NotLearned::kTooManyAlike);
      return;
    }
    for (auto above = static_cast<GoalLevel>(explanation_.level - 1); above > 0; --above) {
      uses_.goals.at(above).learned_below = true;
    }
    current = Learn(current);
    reader_.EndAnalysis();
    if (current == InstantiationId::kNone) return;
  }
}

bool Chunker::MayLearn() const {
  if (left_out_) return false;
  if (explanation_.local_negation && !settings_.allow_local_negations) return false;
  if (explanation_.long_term_memory && !settings_.allow_opaque) return false;
  return !explanation_.quiescence;
}

InstantiationId Chunker::Learn(InstantiationId base) {
  const bool learning = settings_.learning();
  const bool explained = log_.WantsChunkOf(base);
  explanation_number_ = explained ? log_.TakeNumber() : 0;
  ++statistics_.analyzed;
  backtracer_.Trace(explanation_, learning);
  GoalLevel goal_level = explanation_.lowest_ground;
  if (goal_level == 0) {
    if (explanation_.grounds.empty()) {
      ++statistics_.without_grounds;
      uses_.instantiations.SkipSerials(1);
      TellNotLearned(base, NotLearned::kUnconditional);
      if (settings_.warning_interrupt) Interrupt("Chunking issue detected:  Rule learned had no conditions.");
      return InstantiationId::kNone;
    }
    goal_level = static_cast<GoalLevel>(explanation_.level - 1);
  }
  if (explanation_.local_negation && settings_.warning_interrupt && !settings_.allow_local_negations) {
    Interrupt("Chunking issue detected:  Problem-solving contained negated reasoning about sub-state structures.");
  }
  if (learning) {
    analysis_.Analyze(explanation_, explained || log_.noting);
    statistics_.identities_joined += analysis_.graph().joins();
    if (explained) statistics_.identities_literalized += analysis_.CountLiteralized();
    if (explanation_.quiescence) ++statistics_.tested_quiescence;
    bool failed = false;
    if (MayLearn()) {
      const InstantiationId made = BuildChunk(base, goal_level, failed);
      if (!failed) return made;
    }
    Justifier::Making making;
    making.name = NewName(base, false, !failed);
    making.origin = OriginOf(base);
    making.plan = std::make_unique<IdentityPlan>(planner_.Plan(explanation_));
    making.tests = planner_.Tests(explanation_, !failed);
    making.functions = planner_.Functions(explanation_, *making.plan);
    making.negated_classes = planner_.NegatedClasses(explanation_);
    if (log_.justifications && explained) {
      log_.Add(explanation_, explanation_number_, {making.name, nullptr, InstantiationId::kNone, goal_level, false});
    }
    return CountJustification(uses_.justifier.Build(explanation_, goal_level, std::move(making)));
  }
  if (explanation_.quiescence) ++statistics_.tested_quiescence;
  return CountJustification(uses_.justifier.Build(explanation_, goal_level, {}));
}

InstantiationId Chunker::CountJustification(InstantiationId made) {
  if (explanation_.local_negation) ++statistics_.justifications_with_local_negation;
  if (explanation_.long_term_memory) ++statistics_.justifications_with_long_term_memory;
  ++(made == InstantiationId::kNone ? statistics_.duplicates : statistics_.justifications);
  return made;
}

// Names ---------------------------------------------------------------------------------------------------------------

Chunker::Origin Chunker::OriginOf(InstantiationId firing) const {
  const Instantiation& instantiation = uses_.instantiations[firing];
  if (instantiation.justification != Instantiation::kNoJustification) {
    const Justifier::Record& record = uses_.justifier.record(instantiation.justification);
    return {record.base, record.depth};
  }
  const auto found = learned_.find(instantiation.production);
  if (found != learned_.end()) return found->second;
  return {std::string(uses_.descriptions.ProductionName(firing)), 0};
}

LearnedRules Chunker::LearnedBySource() const {
  std::map<std::string_view, std::size_t> counts;
  for (const auto& [rule, origin] : learned_) ++counts[origin.base];
  LearnedRules most;
  most.count = learned_.size();
  for (const auto& [source, count] : counts) {
    if (count <= most.of_source) continue;
    most.source = source;
    most.of_source = count;
  }
  return most;
}

std::string Chunker::NewName(InstantiationId base, bool is_chunk, bool counts) {
  const std::string kind = is_chunk ? "chunk" : "justify";
  std::uint32_t& count = is_chunk ? rules_in_cycle_ : justifications_in_cycle_;
  if (counts) ++count;
  if (settings_.numbered_names) {
    if (!is_chunk) return kind + std::to_string(uses_.justifier.TakeNumber());
    // Numbers increase by two, as in Soar 9.6.3, or by one as long as the name is in use.
    for (++next_number_;; ++next_number_) {
      const std::string name = kind + std::to_string(next_number_);
      if (uses_.rule_changes.Find(name) != ProductionId::kNone) continue;
      ++next_number_;
      return name;
    }
  }
  const Origin origin = OriginOf(base);
  std::string name = kind;
  if (origin.depth > 0) name += "x" + std::to_string(origin.depth + 1);
  name += "*" + origin.base;
  // The impasse that created the state above the one in which the rule matched.
  const GoalLevel level = uses_.instantiations[base].level;
  if (level > 2) {
    switch (uses_.goals.at(static_cast<GoalLevel>(level - 1)).impasse) {
      case ImpasseType::kConstraintFailure:
        name += "*Failure";
        break;
      case ImpasseType::kConflict:
        name += "*Conflict";
        break;
      case ImpasseType::kTie:
        name += "*Tie";
        break;
      case ImpasseType::kNoChange:
        name += "*OpNoChange";
        break;
      case ImpasseType::kNone:
        break;
    }
  }
  name += "*t";
  if (uses_.counters.inits > 0) name += std::to_string(uses_.counters.inits + 1) + "-";
  name += std::to_string(uses_.counters.decision_cycles + 1) + "-" + std::to_string(count);
  std::string unique = name;
  for (int number = 2; uses_.rule_changes.Find(unique) != ProductionId::kNone; ++number) {
    unique = name + "-" + std::to_string(number);
  }
  return unique;
}

void Chunker::Tell(const std::string& name) {
  uses_.observers.Notify(Event::kLearning, [&](Observer& o) { o.OnLearning(uses_.agent, name); });
}

void Chunker::Interrupt(const std::string& reason) {
  uses_.run.InterruptAfterPhase(reason);
}

// Adding a learned rule -----------------------------------------------------------------------------------------------

InstantiationId Chunker::BuildChunk(InstantiationId base, GoalLevel goal_level, bool& failed) {
  const std::string name = NewName(base, true, true);
  Tell(name);
  const RuleBuilder::Outcome outcome = builder_.Build(explanation_, name, goal_level);
  if (outcome == RuleBuilder::Outcome::kFailed) {
    failed = true;
    ++statistics_.unrepairable;
    if (settings_.warning_interrupt) {
      Interrupt("Chunking issue detected. Soar could not repair a rule with ungrounded conditions or actions.");
    }
    return InstantiationId::kNone;
  }
  if (outcome == RuleBuilder::Outcome::kRepaired) {
    ++statistics_.repaired;
    if (settings_.warning_interrupt) {
      Interrupt(
          "Chunking issue detected. Soar has learned a rule with with ungrounded condition(s). Repair required.\n"
          "   This is likely caused by a condition that tested a working memory element \n"
          "   that was created in the sub-state but later became connected to the \n"
          "   super-state because it was a child of an identifier that was an element\n"
          "   of a previous result in that same sub-state.");
    }
  }
  return Enter(base, outcome == RuleBuilder::Outcome::kRepaired);
}

InstantiationId Chunker::Enter(InstantiationId base, bool repaired) {
  const ProductionPtr& rule = builder_.rule();
  const std::span<const GoalLevel> goal_levels = uses_.memory.goal_levels();
  GoalLevel goal_level = 0;
  for (const WmeId wme : builder_.elements()) {
    goal_level = std::max(goal_level, goal_levels[uses_.memory.wme(wme).id.index()]);
  }
  if (goal_level == 0) goal_level = static_cast<GoalLevel>(explanation_.level - 1);
  // Also counted for duplicates.
  if (explanation_.local_negation) ++statistics_.chunks_with_local_negation;
  if (explanation_.long_term_memory) ++statistics_.chunks_with_long_term_memory;
  const InstantiationId id = uses_.instantiations.Make();
  Rete::AddOptions options;
  options.ignore_rl_value = uses_.settings.ignore_numbers_of_duplicates;
  options.refracted = builder_.elements();
  options.instantiation = id;
  const Rete::Added added = uses_.rete.AddProduction(rule, uses_.memory.goal_view(), options);
  if (added.result == Rete::AddResult::kDuplicate) {
    uses_.instantiations.Free(id);
    ++statistics_.duplicates;
    const std::string original(uses_.rete.production(added.production)->name);
    uses_.observers.Notify(Event::kLearning,
                           [&](Observer& o) { o.OnDuplicateLearned(uses_.agent, rule->name, original); });
    uses_.justifier.CountDuplicate(base);
    // Frees unused results. These firings leave no preferences, because the existing rule itself fires.
    for (const PreferenceId result : explanation_.results) uses_.preferences.FreeIfUnused(result);
    log_.CountDuplicate(original);
    return InstantiationId::kNone;
  }
  const bool explained = explanation_number_ != 0;
  const ExplanationLog::Made made{rule->name, rule, id, goal_level, repaired};
  if (explained) {
    log_.Add(explanation_, explanation_number_, made);
    // Rules that are learned from this one are recorded, too.
    if (!log_.all) log_.watched_learned.emplace_back(rule->name);
  }
  if (log_.noting) log_.Note(explanation_, made);
  uses_.rule_changes.NoteAdded(added.production, rule);
  ++statistics_.chunks;
  ++uses_.counters.chunks;
  {
    Origin origin = OriginOf(base);
    ++origin.depth;
    learned_[added.production] = std::move(origin);
  }
  {
    Instantiation& instantiation = uses_.instantiations[id];
    instantiation.production = added.production;
    instantiation.match = added.refracted;
    instantiation.goal = uses_.goals.at(goal_level).id;
    instantiation.level = goal_level;
    instantiation.held = true;
    instantiation.has_identities = true;
    instantiation.local_negation = explanation_.local_negation;
    instantiation.long_term_memory = explanation_.long_term_memory;
  }
  uses_.rete.matches().HoldRule(added.production);
  if (added.refracted == MatchId::kNone) ++statistics_.did_not_match;
  results_.Check(explanation_);
  if (goal_level > 1) {
    uses_.firing.TraceConditions(id, builder_.elements());
    reader_.NoteTurned(id, builder_.turned_tests());
    NoteFiring(id);
  }
  if (uses_.observers.Wants(Event::kLearning)) {
    const FiringInfo info = uses_.descriptions.DescribeInstantiation(id);
    uses_.observers.Notify(Event::kLearning, [&](Observer& o) { o.OnLearned(uses_.agent, info); });
  }
  // The learned rule's own instance gives its results o-support if they apply or elaborate an operator above.
  const Symbol goal = uses_.goals.at(goal_level).id;
  const bool o_support = !uses_.justifier.Proposes(base) &&
                         std::ranges::any_of(explanation_.operator_grounds,
                                             [&](WmeId ground) { return uses_.memory.wme(ground).id == goal; });
  uses_.instantiations[id].o_support = o_support;
  uses_.justifier.MakeClones(explanation_, id, builder_.action_of_result(), o_support);
  uses_.preferences.LinkToGoal(id);
  uses_.firing.made().push_back(id);
  if (settings_.interrupt) {
    Interrupt("Soar learned a new rule.");
  } else if (explained && settings_.explain_interrupt) {
    Interrupt("Soar learned a new rule from a watched production.");
  }
  return id;
}

}  // namespace soarbox::kernel
