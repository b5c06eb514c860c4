// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/agent.h"

#include <algorithm>
#include <cctype>
#include <new>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_core.h"
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

Agent::Agent(std::string name) : core_(std::make_unique<AgentCore>(*this, std::move(name))) {
  core_->Initialize(false);
}
Agent::~Agent() = default;

const std::string& Agent::name() const {
  return core_->name;
}

// Rules ---------------------------------------------------------------------------------------------------------------

LoadOutcome Agent::LoadProduction(std::string_view body, const SourcePlace& place) {
  const RuleLanguage language = {core_->settings.like, core_->is_user_function};
  ParseOutcome parsed = ParseProduction(body, place, core_->symbols, core_->expected_values, language);
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
  const Rete::Added added = core_->rete.AddProduction(production, core_->memory.goal_view(), options);
  outcome.production = added.production;
  if (added.result == Rete::AddResult::kDuplicate) {
    outcome.duplicate_of = core_->rete.production(added.production)->name;
    return;
  }
  outcome.loaded = true;
  core_->rule_changes.NoteAdded(added.production, production);
}

void Agent::Excise(ProductionId id) {
  core_->rule_changes.Excise(id);
}

ProductionId Agent::FindProduction(std::string_view name) const {
  return core_->rule_changes.Find(name);
}

const Production& Agent::production(ProductionId id) const {
  return *core_->rete.production(id);
}
const ProductionPtr& Agent::production_ptr(ProductionId id) const {
  return core_->rete.production(id);
}
ProductionPtr Agent::ProductionAsLearned(ProductionId id) const {
  return core_->reinforcement.values().AsLearned(id, core_->rete.production(id));
}
const RlValue* Agent::LearnedValue(ProductionId id) const {
  return core_->reinforcement.values().Find(id);
}
std::vector<ProductionId> Agent::Productions() const {
  return core_->rules.loading_order();
}

std::uint32_t Agent::CountProductions(ProductionType type) const {
  if (type == ProductionType::kJustification) return static_cast<std::uint32_t>(core_->justifier.Live().size());
  return core_->rules.count(type);
}

std::uint64_t Agent::FiringCount(ProductionId id) const {
  return core_->productions[Index(id)].firings();
}

void Agent::ResetFiringCounts() {
  for (ProductionRecord& record : core_->productions) record.ResetFirings();
}

void Agent::SetBreak(ProductionId id, bool on) {
  core_->productions[Index(id)].Set(ProductionRecord::kBreaks, on);
  core_->rete.matches().SetInterrupts(Index(id), on);
  core_->interrupts.erase(id);
}

bool Agent::HasBreak(ProductionId id) const {
  return core_->productions[Index(id)].Is(ProductionRecord::kBreaks);
}

// Running -------------------------------------------------------------------------------------------------------------

/// Passes the settings that the match needs to it.
void Agent::PrepareMatch() {
  core_->rete.LimitPartialMatches(settings().max_partial_matches);
  core_->symbols.LimitTexts(settings().most_memory_bytes);
  core_->rete.MixedSupportIsO(!settings().warn_of_mixed_support);
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
  if (Guarded([&] { result = work(core_->run); })) return result;
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
  return core_->run.broken();
}

std::string_view Agent::breakdown() const {
  return breakdown_;
}

void Agent::BreakDown(std::string_view rule) {
  if (out_of_memory()) return;
  core_->run.BreakDown();
  // The rule with the most partial matches is reported as the cause if they fill a large part of the memory. (If rules
  // share conditions, the first of them is named.)
  ProductionId heaviest = ProductionId::kNone;
  std::size_t most = MemoryBytes() / 4 / Rete::kTokenBytes;
  for (const ProductionId id : core_->rules.loading_order()) {
    const std::size_t tokens = core_->rete.CountTokens(id);
    if (tokens <= most) continue;
    most = tokens;
    heaviest = id;
  }
  const bool at_limit = core_->rete.at_limit();
  // This frees memory, also for other agents.
  core_->rete.Abandon();
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
    core_->observers.Notify(Event::kPrint, [&](Observer& o) { o.OnError(*this, text); });
  } catch (const std::bad_alloc&) {
    // There is no memory to report it; halted() and out_of_memory() return it.
  }
}
Phase Agent::next_phase() const {
  return core_->run.phase();
}
bool Agent::in_middle_of_phase() const {
  return core_->run.in_middle();
}
void Agent::RequestStop(std::string_view reason) {
  core_->run.RequestStop(reason);
}
void Agent::ClearStopRequest() {
  core_->run.ClearStop();
}
bool Agent::halted() const {
  return core_->run.halted();
}
bool Agent::running() const {
  return core_->run.running() && !out_of_memory();
}
void Agent::SetGoalToWatch(Symbol goal) {
  core_->run.WatchGoal(goal);
}

void Agent::InitSoar() {
  if (core_->run.running()) return;
  core_->observers.Notify(Event::kRun, [&](Observer& o) { o.OnBeforeInit(*this); });
  ++core_->counters.inits;
  ResetFiringCounts();
  if (!Guarded([&] { core_->Initialize(true); })) return;
  core_->observers.Notify(Event::kRun, [&](Observer& o) { o.OnAfterInit(*this); });
}

// Settings ------------------------------------------------------------------------------------------------------------

const AgentSettings& Agent::settings() const {
  return core_->settings;
}
AgentSettings& Agent::mutable_settings() {
  return core_->settings;
}
const ExplorationSettings& Agent::exploration() const {
  return core_->exploration;
}
ExplorationSettings& Agent::mutable_exploration() {
  return core_->exploration;
}
const ExpectedValues& Agent::expected_values() const {
  return core_->expected_values;
}
ExpectedValues& Agent::mutable_expected_values() {
  return core_->expected_values;
}
const RlSettings& Agent::reinforcement() const {
  return core_->reinforcement.settings();
}
void Agent::SetReinforcement(const RlSettings& settings) {
  if (!out_of_memory()) core_->reinforcement.Set(settings);
}
ChoiceGraph& Agent::choice_graph() {
  return core_->reinforcement.choices();
}
const RlStatistics& Agent::reward() const {
  return core_->reinforcement.statistics();
}
RandomStream& Agent::random() {
  return core_->random;
}

void Agent::SelectOperator(std::string_view identifier) {
  core_->forced_operator = identifier;
  if (!core_->forced_operator.empty()) {
    char& letter = core_->forced_operator.front();
    letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  }
}

std::string_view Agent::selected_operator() const {
  return core_->forced_operator;
}
std::string Agent::PredictDecision() {
  return core_->decision.Predict();
}
void Agent::SetAgentWrites(bool on) {
  core_->agent_writes = on;
}

// Learning ------------------------------------------------------------------------------------------------------------

const LearnSettings& Agent::learning() const {
  return core_->chunker.settings();
}
void Agent::ChangeLearning(const std::function<void(LearnSettings&)>& change) {
  change(core_->chunker.mutable_settings());
  core_->chunker.ModeChanged();
}
std::uint32_t Agent::instantiation_count() const {
  return core_->instantiations.last_serial();
}

const LearnStatistics& Agent::learn_statistics() const {
  return core_->chunker.statistics();
}
std::string_view Agent::FiringRule() const {
  const InstantiationId firing = core_->context.firing();
  if (firing == InstantiationId::kNone) return {};
  const ProductionId rule = core_->instantiations[firing].production;
  return rule == ProductionId::kNone ? std::string_view() : std::string_view(production(rule).name);
}
std::string_view Agent::NextRule() const {
  const MatchSet& matches = core_->rete.matches();
  for (const MatchSet::List list :
       {MatchSet::List::kOAssertions, MatchSet::List::kIAssertions, MatchSet::List::kRetractions}) {
    const std::vector<PendingMatch> pending = matches.Pending(list);
    if (!pending.empty() && pending.front().production != ProductionId::kNone)
      return production(pending.front().production).name;
  }
  return {};
}
std::size_t Agent::learned_rule_count() const {
  return core_->chunker.learned_count();
}
LearnedRules Agent::LearnedBySource() const {
  return core_->chunker.LearnedBySource();
}
const Singletons& Agent::singletons() const {
  return core_->chunker.singletons();
}
Singletons& Agent::mutable_singletons() {
  return core_->chunker.singletons();
}
const ExplanationLog& Agent::explanations() const {
  return core_->chunker.explanations();
}
ExplanationLog& Agent::mutable_explanations() {
  return core_->chunker.explanations();
}
std::vector<Symbol> Agent::StatesForcedToLearn() const {
  return core_->chunker.forced_states();
}
std::vector<Symbol> Agent::StatesNotToLearn() const {
  return core_->chunker.excluded_states();
}

// Observing -----------------------------------------------------------------------------------------------------------

void Agent::AddObserver(Observer& observer, EventMask events) {
  core_->observers.Add(observer, events);
}
void Agent::RemoveObserver(Observer& observer) {
  core_->observers.Remove(observer);
}
EventMask Agent::observed() const {
  return core_->observers.mask();
}

// Inspecting ----------------------------------------------------------------------------------------------------------

const SymbolTable& Agent::symbols() const {
  return core_->symbols;
}
SymbolTable& Agent::mutable_symbols() {
  return core_->symbols;
}
const WorkingMemory& Agent::memory() const {
  return core_->memory;
}
const GoalStack& Agent::goals() const {
  return core_->goals;
}
const Rete& Agent::rete() const {
  return core_->rete;
}
const AgentCounters& Agent::counters() const {
  return core_->counters;
}
std::string_view Agent::ProductionName(InstantiationId id) const {
  return core_->descriptions.ProductionName(id);
}

std::span<const WmeId> Agent::MatchedWmes(InstantiationId id) const {
  const Instantiation& instantiation = core_->instantiations[id];
  if (instantiation.match == MatchId::kNone) return {};
  return core_->rete.Wmes(instantiation.match);
}

std::vector<ProductionPtr> Agent::Justifications() const {
  std::vector<ProductionPtr> rules;
  for (const std::uint32_t index : core_->justifier.Live()) rules.push_back(core_->justifier.AsRule(index, true));
  return rules;
}

ProductionPtr Agent::JustificationOf(InstantiationId id) const {
  const std::uint32_t index = core_->instantiations[id].justification;
  return index == 0xFFFFFFFFu ? nullptr : core_->justifier.AsRule(index, true);
}

bool Agent::ExciseJustification(std::string_view name) {
  return !core_->run.running() && core_->justifier.Excise(name);
}

WmeInfo Agent::Describe(WmeId id) const {
  return core_->descriptions.Describe(id);
}
GoalInfo Agent::Describe(const Goal& goal) const {
  return core_->descriptions.Describe(goal);
}
Symbol Agent::OperatorOf(const Goal& goal) const {
  return core_->descriptions.OperatorOf(goal);
}

std::vector<PreferenceId> Agent::PreferencesOf(SlotId slot, PreferenceType type) const {
  std::vector<PreferenceId> found;
  const WorkingMemory& memory = core_->memory;
  const Slot& record = memory.slot(slot);
  for (PreferenceId p = type == PreferenceType::kAcceptable ? record.acceptable : record.others;
       p != PreferenceId::kNone; p = memory.preference(p).next_in_slot) {
    if (memory.preference(p).type == type) found.push_back(p);
  }
  return found;
}

std::vector<Agent::CandidateChance> Agent::SelectionProbabilities(const Goal& goal) const {
  std::vector<CandidateChance> chances;
  const PreferenceSemantics::Outcome outcome = core_->decision.Evaluate(goal);
  if (outcome.impasse != ImpasseType::kNone || outcome.candidates.empty()) return chances;
  const std::vector<double> probabilities = outcome.candidates.size() == 1
                                                ? std::vector<double>{1.0}
                                                : SelectionChances(outcome.candidates, core_->exploration);
  for (std::size_t n = 0; n < outcome.candidates.size(); ++n) {
    const Candidate& candidate = outcome.candidates[n];
    chances.push_back(
        {candidate.preference, candidate.value, NumericValue(candidate, core_->exploration), probabilities[n]});
  }
  return chances;
}

DecisionReport Agent::ExplainDecision(const Goal& goal) const {
  return core_->decision.Explain(goal);
}

// Input and output ----------------------------------------------------------------------------------------------------

InputLink& Agent::input() {
  // Rules must be offered for sharing before input creates constants.
  if (core_->rules_changed && !core_->run.running()) [[unlikely]]
    core_->OfferRules();
  return core_->input;
}
const InputLink& Agent::input() const {
  return core_->input;
}
const OutputLink& Agent::output() const {
  return core_->output;
}
Symbol Agent::InputLinkIdentifier() const {
  return core_->goal_changes.input_link();
}
Symbol Agent::OutputLinkIdentifier() const {
  return core_->goal_changes.output_link();
}

Result<WmeId> Agent::AddWme(Symbol id, Symbol attribute, Symbol value, bool acceptable) {
  if (core_->run.running()) return Refusal("working memory cannot be changed while the agent runs");
  if (!id.IsIdentifier() || !core_->memory.identifier(id).live) {
    return Refusal("the element's identifier is not in working memory");
  }
  WmeId wme = WmeId::kNone;
  const bool added = Guarded([&] {
    wme = core_->changes.AddInput(id, attribute, value, acceptable);
    core_->elaboration.ApplyBufferedChanges();
  });
  if (!added) return Refusal("there is no memory for the matches of the element: the agent is halted for good");
  return wme;
}

Symbol Agent::NewIdentifier(char letter) {
  return core_->memory.NewIdentifier(letter, 1);
}

Symbol Agent::NewIdentifier(char letter, std::uint64_t number, Symbol parent) {
  return core_->memory.NewIdentifier(core_->symbols.NewIdentifier(letter, number),
                                     core_->memory.identifier(parent).level);
}

/// Preferences for the value of the removed element stay, so the element is added again when the slot is decided the
/// next time. That decision must check all values, not only those that have changed.
static void NoteLostByHand(WorkingMemory& memory, SlotId id) {
  Slot& slot = memory.mutable_slot(id);
  slot.lost_by_hand = true;
  if (slot.is_operator) return;
  if (LargeSlot* const large = memory.Large(id)) large->all_changed = true;
}

Result<void> Agent::RemoveWme(WmeId wme) {
  if (core_->run.running()) return Refusal("working memory cannot be changed while the agent runs");
  WorkingMemory& memory = core_->memory;
  if (Index(wme) >= memory.wmes().size() || !memory.wme(wme).live) {
    return Refusal("there is no such element");
  }
  const WmeRecord& record = memory.record(wme);
  const bool removed = Guarded([&] {
    if (record.kind == WmeKind::kSlot && memory.slot(record.slot()).is_operator) {
      core_->preferences.RemoveSelected(record.slot());  // Substates stay.
    } else {
      if (record.preference != PreferenceId::kNone) NoteLostByHand(memory, record.slot());
      core_->changes.Lose(wme);
    }
    core_->elaboration.ApplyWorkingMemoryChanges();
  });
  if (!removed) return Refusal("there is no memory for the matches without the element: the agent is halted for good");
  return {};
}

void Agent::SetUserFunctions(std::function<Result<Symbol>(Agent&, std::string_view, std::span<const Symbol>)> function,
                             std::function<bool(std::string_view)> is_there) {
  core_->user_functions = std::move(function);
  core_->is_user_function = std::move(is_there);
}

void Agent::SetCommandRunner(std::function<std::string(Agent&, std::string_view)> runner) {
  core_->command_runner = std::move(runner);
}

LongTerm& Agent::long_term() {
  return core_->long_term;
}
const LongTerm& Agent::long_term() const {
  return core_->long_term;
}

Imagery& Agent::imagery() {
  if (core_->imagery == nullptr) {
    core_->imagery = std::make_unique<Imagery>(Imagery::Uses{core_->symbols, core_->memory, core_->goals,
                                                             core_->changes, core_->preferences, core_->elaboration,
                                                             core_->modules, core_->observers, *this});
  }
  return *core_->imagery;
}
const Imagery* Agent::find_imagery() const {
  return core_->imagery.get();
}

// Memory --------------------------------------------------------------------------------------------------------------

std::size_t Agent::MemoryBytes() const {
  return sizeof(AgentCore) + core_->symbols.MemoryBytes() + core_->memory.MemoryBytes() + core_->links.MemoryBytes() +
         core_->instantiations.MemoryBytes() + core_->rete.MemoryBytes() + core_->modules.MemoryBytes() +
         core_->learned_rule_bytes;
}

std::size_t Agent::SharedMemoryBytes() const {
  return core_->rete.NetworkBytes();
}
std::string Agent::CheckInvariants() const {
  const std::string violation = FindViolation(*core_);
  return violation.empty() ? FindDanglingHandle(*core_) : violation;
}

}  // namespace soarbox::kernel
