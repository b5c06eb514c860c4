// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/agent.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/engine.h"
#include "kernel/decide/invariants.h"
#include "kernel/imagery/imagery.h"

namespace soarbox::kernel {
namespace {

Diagnostic Refusal(std::string message) {
  Diagnostic diagnostic;
  diagnostic.message = std::move(message);
  return diagnostic;
}

}  // namespace

Agent::Agent(std::string name) : engine_(std::make_unique<Engine>(*this, std::move(name))) {
  engine_->Initialize(false);
}
Agent::~Agent() = default;

const std::string& Agent::name() const {
  return engine_->name;
}

// Rules ---------------------------------------------------------------------------------------------------------------

LoadOutcome Agent::LoadProduction(std::string_view body, const SourcePlace& place) {
  const RuleLanguage language = {engine_->settings.like, engine_->is_user_function};
  ParseOutcome parsed = ParseProduction(body, place, engine_->symbols, engine_->expected_values, language);
  LoadOutcome outcome;
  outcome.name = std::move(parsed.name);
  outcome.printed = std::move(parsed.messages);
  outcome.printed_late = std::move(parsed.late_messages);
  outcome.messages = std::move(parsed.diagnostics);
  if (!outcome.name.empty()) Replace(std::move(parsed.production), outcome, false);
  return outcome;
}

LoadOutcome Agent::AddProduction(ProductionPtr production, bool ignore_number) {
  LoadOutcome outcome;
  outcome.name = std::string(production->name);
  Replace(std::move(production), outcome, ignore_number);
  return outcome;
}

void Agent::Replace(ProductionPtr production, LoadOutcome& outcome, bool ignore_number) {
  if (!out_of_memory()) {
    PrepareMatch();
    try {
      ExciseNamed(outcome.name, outcome);
      if (production != nullptr) Enter(std::move(production), outcome, ignore_number);
      return;
    } catch (const std::bad_alloc&) {
      BreakDown(outcome.name);
    }
  }
  outcome.loaded = false;
  Diagnostic refusal =
      Refusal("there is no memory for the matches of " + outcome.name + ": the agent is halted for good");
  refusal.hint = "destroy the agent and make a new one";
  outcome.messages.push_back(std::move(refusal));
}

void Agent::ExciseNamed(std::string_view name, LoadOutcome& outcome) {
  const ProductionId older = FindProduction(name);
  if (older == ProductionId::kNone) return;
  Excise(older);
  outcome.replaced = true;
}

void Agent::Enter(ProductionPtr production, LoadOutcome& outcome, bool ignore_number) {
  Rete::AddOptions options;
  options.ignore_rl_value = ignore_number || settings().ignore_numbers_of_duplicates;
  const Rete::Added added = engine_->rete.AddProduction(production, engine_->memory.goal_view(), options);
  outcome.production = added.production;
  if (added.result == Rete::AddResult::kDuplicate) {
    outcome.duplicate_of = engine_->rete.production(added.production)->name;
    return;
  }
  outcome.loaded = true;
  engine_->rule_changes.NoteAdded(added.production, production);
}

void Agent::Excise(ProductionId id) {
  engine_->rule_changes.Excise(id);
}

ProductionId Agent::FindProduction(std::string_view name) const {
  return engine_->rule_changes.Find(name);
}

const Production& Agent::production(ProductionId id) const {
  return *engine_->rete.production(id);
}
const ProductionPtr& Agent::production_ptr(ProductionId id) const {
  return engine_->rete.production(id);
}
ProductionPtr Agent::ProductionAsLearned(ProductionId id) const {
  return engine_->reinforcement.values().AsLearned(id, engine_->rete.production(id));
}
const RlValue* Agent::LearnedValue(ProductionId id) const {
  return engine_->reinforcement.values().Find(id);
}
std::vector<ProductionId> Agent::Productions() const {
  return engine_->rules.loading_order();
}

std::uint32_t Agent::CountProductions(ProductionType type) const {
  if (type == ProductionType::kJustification) return static_cast<std::uint32_t>(engine_->justifier.Live().size());
  return engine_->rules.count(type);
}

std::uint64_t Agent::FiringCount(ProductionId id) const {
  return engine_->productions[Index(id)].firings();
}

void Agent::ResetFiringCounts() {
  for (ProductionRecord& record : engine_->productions) record.ResetFirings();
}

void Agent::SetBreak(ProductionId id, bool on) {
  engine_->productions[Index(id)].Set(ProductionRecord::kBreaks, on);
  engine_->rete.matches().SetInterrupts(Index(id), on);
  engine_->interrupts.erase(id);
}

bool Agent::HasBreak(ProductionId id) const {
  return engine_->productions[Index(id)].Is(ProductionRecord::kBreaks);
}

// Running -------------------------------------------------------------------------------------------------------------

/// Passes the settings that the match needs to it.
void Agent::PrepareMatch() {
  engine_->rete.LimitPartialMatches(settings().max_partial_matches);
  engine_->symbols.LimitTexts(settings().most_memory_bytes);
  engine_->rete.MixedSupportIsO(!settings().warn_of_mixed_support);
}

template <typename Work>
bool Agent::Guarded(Work work) {
  PrepareMatch();
  try {
    work();
    return true;
  } catch (const std::bad_alloc&) {
    BreakDown();
    return false;
  }
}

template <typename Work>
RunResult Agent::RunGuarded(Work work) {
  RunResult result;
  if (Guarded([&] { result = work(engine_->run); })) return result;
  RunResult broken;
  broken.reason = StopReason::kHalted;
  return broken;
}

RunResult Agent::Run(RunUnit unit, std::uint64_t count) {
  return RunGuarded([&](RunControl& run) { return run.Run(unit, count); });
}
RunResult Agent::Step(RunUnit unit, std::uint64_t most) {
  return RunGuarded([&](RunControl& run) { return run.Step(unit, most); });
}
RunResult Agent::RunToPhase(Phase phase) {
  return RunGuarded([&](RunControl& run) { return run.RunToPhase(phase); });
}
bool Agent::out_of_memory() const {
  return engine_->run.broken();
}

std::string_view Agent::breakdown() const {
  return breakdown_;
}

void Agent::BreakDown(std::string_view rule) {
  if (out_of_memory()) return;
  engine_->run.BreakDown();
  // The rule with the most partial matches is reported as the cause if they fill a large part of the memory. (If rules
  // share conditions, the first of them is named.)
  ProductionId heaviest = ProductionId::kNone;
  std::size_t most = MemoryBytes() / 4 / Rete::kTokenBytes;
  for (const ProductionId id : engine_->rules.loading_order()) {
    const std::size_t tokens = engine_->rete.CountTokens(id);
    if (tokens <= most) continue;
    most = tokens;
    heaviest = id;
  }
  const bool at_limit = engine_->rete.at_limit();
  // This frees memory, also for other agents.
  engine_->rete.Abandon();
  try {
    if (!rule.empty()) {
      breakdown_ = "there is no room for the matches of rule " + std::string(rule);
    } else if (heaviest != ProductionId::kNone) {
      breakdown_ =
          "rule " + std::string(production(heaviest).name) + " had " + std::to_string(most) + " partial matches";
    } else {
      breakdown_ =
          "rules whose conditions match in very many combinations, that add elements without end or that make ever "
          "longer texts are the usual cause";
    }
    if (at_limit) {
      breakdown_ += "; 'soar max-partial-matches' allows " + std::to_string(settings().max_partial_matches) + " in all";
    }
    const std::string text =
        "Error: agent " + name() + " ran out of memory and is halted for good: " + breakdown_ + ".  Destroy it.\n";
    engine_->observers.Notify(Event::kPrint, [&](Observer& o) { o.OnError(*this, text); });
  } catch (const std::bad_alloc&) {
    // There is no memory to report it; halted() and out_of_memory() return it.
  }
}
Phase Agent::next_phase() const {
  return engine_->run.phase();
}
bool Agent::in_middle_of_phase() const {
  return engine_->run.in_middle();
}
void Agent::RequestStop(std::string_view reason) {
  engine_->run.RequestStop(reason);
}
void Agent::ClearStopRequest() {
  engine_->run.ClearStop();
}
bool Agent::halted() const {
  return engine_->run.halted();
}
bool Agent::running() const {
  return engine_->run.running() && !out_of_memory();
}
void Agent::SetGoalToWatch(Symbol goal) {
  engine_->run.WatchGoal(goal);
}

void Agent::InitSoar() {
  if (engine_->run.running()) return;
  engine_->observers.Notify(Event::kRun, [&](Observer& o) { o.OnBeforeInit(*this); });
  ++engine_->counters.inits;
  ResetFiringCounts();
  if (!Guarded([&] { engine_->Initialize(true); })) return;
  engine_->observers.Notify(Event::kRun, [&](Observer& o) { o.OnAfterInit(*this); });
}

// Settings ------------------------------------------------------------------------------------------------------------

const AgentSettings& Agent::settings() const {
  return engine_->settings;
}
AgentSettings& Agent::mutable_settings() {
  return engine_->settings;
}
const ExplorationSettings& Agent::exploration() const {
  return engine_->exploration;
}
ExplorationSettings& Agent::mutable_exploration() {
  return engine_->exploration;
}
const ExpectedValues& Agent::expected_values() const {
  return engine_->expected_values;
}
ExpectedValues& Agent::mutable_expected_values() {
  return engine_->expected_values;
}
const RlSettings& Agent::reinforcement() const {
  return engine_->reinforcement.settings();
}
void Agent::SetReinforcement(const RlSettings& settings) {
  if (!out_of_memory()) engine_->reinforcement.Set(settings);
}
ChoiceGraph& Agent::choice_graph() {
  return engine_->reinforcement.choices();
}
const RlStatistics& Agent::reward() const {
  return engine_->reinforcement.statistics();
}
RandomStream& Agent::random() {
  return engine_->random;
}

void Agent::SelectOperator(std::string_view identifier) {
  engine_->forced_operator = identifier;
  if (!engine_->forced_operator.empty()) {
    char& letter = engine_->forced_operator.front();
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
}

std::string_view Agent::selected_operator() const {
  return engine_->forced_operator;
}
std::string Agent::PredictDecision() {
  return engine_->decision.Predict();
}
void Agent::SetAgentWrites(bool on) {
  engine_->agent_writes = on;
}

// Learning ------------------------------------------------------------------------------------------------------------

const LearnSettings& Agent::learning() const {
  return engine_->chunker.settings();
}
void Agent::ChangeLearning(const std::function<void(LearnSettings&)>& change) {
  change(engine_->chunker.mutable_settings());
  engine_->chunker.ModeChanged();
}
std::uint32_t Agent::instantiation_count() const {
  return engine_->instantiations.last_serial();
}

const LearnStatistics& Agent::learn_statistics() const {
  return engine_->chunker.statistics();
}
std::string_view Agent::FiringRule() const {
  const InstantiationId firing = engine_->context.firing();
  if (firing == InstantiationId::kNone) return {};
  const ProductionId rule = engine_->instantiations[firing].production;
  return rule == ProductionId::kNone ? std::string_view() : std::string_view(production(rule).name);
}
std::string_view Agent::NextRule() const {
  const MatchSet& matches = engine_->rete.matches();
  for (const MatchSet::List list :
       {MatchSet::List::kOAssertions, MatchSet::List::kIAssertions, MatchSet::List::kRetractions}) {
    const std::vector<PendingMatch> pending = matches.Pending(list);
    if (!pending.empty() && pending.front().production != ProductionId::kNone)
      return production(pending.front().production).name;
  }
  return {};
}
std::size_t Agent::learned_rule_count() const {
  return engine_->chunker.learned_count();
}
LearnedRules Agent::LearnedBySource() const {
  return engine_->chunker.LearnedBySource();
}
const Singletons& Agent::singletons() const {
  return engine_->chunker.singletons();
}
Singletons& Agent::mutable_singletons() {
  return engine_->chunker.singletons();
}
const ExplanationLog& Agent::explanations() const {
  return engine_->chunker.explanations();
}
ExplanationLog& Agent::mutable_explanations() {
  return engine_->chunker.explanations();
}
std::vector<Symbol> Agent::StatesForcedToLearn() const {
  return engine_->chunker.forced_states();
}
std::vector<Symbol> Agent::StatesNotToLearn() const {
  return engine_->chunker.excluded_states();
}

// Observing -----------------------------------------------------------------------------------------------------------

void Agent::AddObserver(Observer& observer, EventMask events) {
  engine_->observers.Add(observer, events);
}
void Agent::RemoveObserver(Observer& observer) {
  engine_->observers.Remove(observer);
}
EventMask Agent::observed() const {
  return engine_->observers.mask();
}

// Inspecting ----------------------------------------------------------------------------------------------------------

const SymbolTable& Agent::symbols() const {
  return engine_->symbols;
}
SymbolTable& Agent::mutable_symbols() {
  return engine_->symbols;
}
const WorkingMemory& Agent::memory() const {
  return engine_->memory;
}
const GoalStack& Agent::goals() const {
  return engine_->goals;
}
const Rete& Agent::rete() const {
  return engine_->rete;
}
const AgentCounters& Agent::counters() const {
  return engine_->counters;
}
std::string_view Agent::ProductionName(InstantiationId id) const {
  return engine_->descriptions.ProductionName(id);
}

std::span<const WmeId> Agent::MatchedWmes(InstantiationId id) const {
  const Instantiation& instantiation = engine_->instantiations[id];
  if (instantiation.match == MatchId::kNone) return {};
  return engine_->rete.Wmes(instantiation.match);
}

std::vector<ProductionPtr> Agent::Justifications() const {
  std::vector<ProductionPtr> rules;
  for (const std::uint32_t index : engine_->justifier.Live()) rules.push_back(engine_->justifier.AsRule(index, true));
  return rules;
}

ProductionPtr Agent::JustificationOf(InstantiationId id) const {
  const std::uint32_t index = engine_->instantiations[id].justification;
  return index == 0xFFFFFFFFu ? nullptr : engine_->justifier.AsRule(index, true);
}

bool Agent::ExciseJustification(std::string_view name) {
  return !engine_->run.running() && engine_->justifier.Excise(name);
}

WmeInfo Agent::Describe(WmeId id) const {
  return engine_->descriptions.Describe(id);
}
GoalInfo Agent::Describe(const Goal& goal) const {
  return engine_->descriptions.Describe(goal);
}
Symbol Agent::OperatorOf(const Goal& goal) const {
  return engine_->descriptions.OperatorOf(goal);
}

std::vector<PreferenceId> Agent::PreferencesOf(SlotId slot, PreferenceType type) const {
  std::vector<PreferenceId> found;
  const WorkingMemory& memory = engine_->memory;
  const Slot& record = memory.slot(slot);
  for (PreferenceId p = type == PreferenceType::kAcceptable ? record.acceptable : record.others;
       p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    if (memory.preference(p).type == type) found.push_back(p);
  }
  return found;
}

std::vector<Agent::CandidateChance> Agent::SelectionProbabilities(const Goal& goal) const {
  std::vector<CandidateChance> chances;
  const PreferenceSemantics::Outcome outcome = engine_->decision.Evaluate(goal);
  if (outcome.impasse != ImpasseType::kNone || outcome.candidates.empty()) return chances;
  const std::vector<double> probabilities = outcome.candidates.size() == 1
                                                ? std::vector<double>{1.0}
                                                : SelectionChances(outcome.candidates, engine_->exploration);
  for (std::size_t n = 0; n < outcome.candidates.size(); ++n) {
    const Candidate& candidate = outcome.candidates[n];
    chances.push_back(
        {candidate.preference, candidate.value, NumericValue(candidate, engine_->exploration), probabilities[n]});
  }
  return chances;
}

DecisionReport Agent::ExplainDecision(const Goal& goal) const {
  return engine_->decision.Explain(goal);
}

// Input and output ----------------------------------------------------------------------------------------------------

InputLink& Agent::input() {
  // Rules must be offered for sharing before input creates constants.
  if (engine_->rules_changed && !engine_->run.running()) [[unlikely]]
    engine_->OfferRules();
  return engine_->input;
}
const InputLink& Agent::input() const {
  return engine_->input;
}
const OutputLink& Agent::output() const {
  return engine_->output;
}
Symbol Agent::InputLinkIdentifier() const {
  return engine_->goal_changes.input_link();
}
Symbol Agent::OutputLinkIdentifier() const {
  return engine_->goal_changes.output_link();
}

Result<WmeId> Agent::AddWme(Symbol id, Symbol attribute, Symbol value, bool acceptable) {
  if (engine_->run.running()) return Refusal("working memory cannot be changed while the agent runs");
  if (!id.IsIdentifier() || !engine_->memory.identifier(id).live) {
    return Refusal("the element's identifier is not in working memory");
  }
  WmeId wme = WmeId::kNone;
  const bool added = Guarded([&] {
    wme = engine_->changes.AddInput(id, attribute, value, acceptable);
    engine_->elaboration.ApplyBufferedChanges();
  });
  if (!added) return Refusal("there is no memory for the matches of the element: the agent is halted for good");
  return wme;
}

Symbol Agent::NewIdentifier(char letter) {
  return engine_->memory.NewIdentifier(letter, 1);
}

Symbol Agent::NewIdentifier(char letter, std::uint64_t number, Symbol parent) {
  return engine_->memory.NewIdentifier(engine_->symbols.NewIdentifier(letter, number),
                                       engine_->memory.identifier(parent).level);
}

/// The preferences for a value that rules made stay: its element comes back when the slot is decided again. Then all
/// values are looked at, not only those that have changed.
static void NoteLostByHand(WorkingMemory& memory, SlotId id) {
  Slot& slot = memory.mutable_slot(id);
  slot.lost_by_hand = true;
  if (slot.is_operator) return;
  if (LargeSlot* const large = memory.Large(id)) large->all_changed = true;
}

Result<void> Agent::RemoveWme(WmeId wme) {
  if (engine_->run.running()) return Refusal("working memory cannot be changed while the agent runs");
  WorkingMemory& memory = engine_->memory;
  if (Index(wme) >= memory.wmes().size() || !memory.wme(wme).live) {
    return Refusal("there is no such element");
  }
  const WmeRecord& record = memory.record(wme);
  const bool removed = Guarded([&] {
    if (record.kind == WmeKind::kSlot && memory.slot(record.slot()).is_operator) {
      engine_->preferences.RemoveSelected(record.slot());  // The states below stay.
    } else {
      if (record.preference != PreferenceId::kNone) NoteLostByHand(memory, record.slot());
      engine_->changes.Lose(wme);
    }
    engine_->elaboration.ApplyWorkingMemoryChanges();
  });
  if (!removed) return Refusal("there is no memory for the matches without the element: the agent is halted for good");
  return {};
}

void Agent::SetUserFunctions(std::function<Result<Symbol>(Agent&, std::string_view, std::span<const Symbol>)> function,
                             std::function<bool(std::string_view)> is_there) {
  engine_->user_functions = std::move(function);
  engine_->is_user_function = std::move(is_there);
}

void Agent::SetCommandRunner(std::function<std::string(Agent&, std::string_view)> runner) {
  engine_->command_runner = std::move(runner);
}

LongTerm& Agent::long_term() {
  return engine_->long_term;
}
const LongTerm& Agent::long_term() const {
  return engine_->long_term;
}

Imagery& Agent::imagery() {
  if (engine_->imagery == nullptr) {
    engine_->imagery = std::make_unique<Imagery>(
        Imagery::Uses{engine_->symbols, engine_->memory, engine_->goals, engine_->changes, engine_->preferences,
                      engine_->elaboration, engine_->modules, engine_->observers, *this});
  }
  return *engine_->imagery;
}
const Imagery* Agent::find_imagery() const {
  return engine_->imagery.get();
}

// Memory --------------------------------------------------------------------------------------------------------------

std::size_t Agent::MemoryBytes() const {
  return sizeof(Engine) + engine_->symbols.MemoryBytes() + engine_->memory.MemoryBytes() +
         engine_->links.MemoryBytes() + engine_->instantiations.MemoryBytes() + engine_->rete.MemoryBytes() +
         engine_->modules.MemoryBytes() + engine_->learned_rule_bytes;
}

std::size_t Agent::SharedMemoryBytes() const {
  return engine_->rete.NetworkBytes();
}
std::string Agent::CheckInvariants() const {
  const std::string violation = FindViolation(*engine_);
  return violation.empty() ? FindDanglingHandle(*engine_) : violation;
}

}  // namespace soarbox::kernel
