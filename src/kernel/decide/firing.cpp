// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/firing.h"

#include "kernel/base/known_symbols.h"
#include "kernel/decide/agent_core.h"
#include "kernel/rules/functions/builtin_functions.h"
#include "kernel/rules/print_production.h"

namespace soarbox::kernel {
namespace {

/// Appends a value of an action as Soar 9.6.3 shows it at run time, when variables have no names.
void AppendLoaded(std::string& out, const SymbolTable& symbols, const RhsValue& value) {
  if (value.kind == RhsValueKind::kBound) {
    out += "[RETE-loc]";
  } else if (value.kind == RhsValueKind::kNew) {
    out += "<unbound-variable>";
  } else if (value.kind == RhsValueKind::kFunction) {
    out.append("(").append(BuiltinFunctions()[value.function_index()].name);
    for (const RhsValue& argument : value.arguments()) {
      out += ' ';
      AppendLoaded(out, symbols, argument);
    }
    out += ')';
  } else {
    AppendRhsValue(out, symbols, value);
  }
}

/// Maximum number of elements of a firing (tested or copied) that learning considers.
constexpr std::size_t kMostTraced = 20'000;

/// The message of the trace about a preference that cannot be created.
std::string BadIdentifier(const SymbolTable& symbols, Symbol id, const Action& action) {
  std::string text = "Error: RHS of action           (";
  AppendLoaded(text, symbols, action.id);
  text += " ^";
  AppendLoaded(text, symbols, action.attribute);
  text += ' ';
  AppendLoaded(text, symbols, action.value);
  text.append(" ").append(PreferenceSign(action.preference));
  if (action.HasReferent()) {
    text += ' ';
    AppendLoaded(text, symbols, action.referent);
  }
  return text + ") makes a preference for " + ToString(symbols, id) + " (not an identifier)\n";
}

}  // namespace

Symbol Firing::TouchedAbove(const PendingMatch& match, GoalLevel level) const {
  const Production& rule = *core_.rete.production(match.production);
  if (rule.type == ProductionType::kTemplate) return {};
  const std::span<const WmeId> wmes = core_.rete.Wmes(match.match);
  for (const Action& action : rule.actions) {
    if (action.is_function_call || action.id.kind != RhsValueKind::kBound) continue;
    const Wme& wme = core_.memory.wme(wmes[action.id.site().positive_condition]);
    const Symbol id = FieldOf(wme, action.id.site().field);
    if (id.IsIdentifier() && core_.memory.level(id) <= level) return id;
  }
  return {};
}

void Firing::Fire(const PendingMatch& match, const Production& rule) {
  const InstantiationId id = core_.instantiations.Make();
  {
    Instantiation& instantiation = core_.instantiations[id];
    instantiation.production = match.production;
    instantiation.match = match.match;
    instantiation.goal = match.goal;
    instantiation.level = match.level;
    instantiation.o_support = match.o_support;
    instantiation.held = true;
  }
  const std::span<const WmeId> wmes = core_.rete.Wmes(match.match);
  if (wmes_.size() < wmes.size()) wmes_.resize(wmes.size());
  WmeId* const copy = wmes_.data();
  for (std::size_t n = 0; n < wmes.size(); ++n) copy[n] = wmes[n];
  core_.rete.matches().MarkFired(match.match, id);
  core_.rete.matches().HoldRule(match.production);
  if (match.level > 1) {
    TraceConditions(id, {copy, wmes.size()});
    if (core_.chunker.settings().learning()) core_.chunker.NoteFiring(id);
  }

  ++core_.counters.firings;
  ProductionRecord& record = core_.productions[Index(match.production)];
  record.CountFiring();

  if (core_.observers.Wants(Event::kAssertion)) TellMade(id);
  if (core_.observers.Wants(Event::kFiring)) TellFiring(id);
  match_level_ = match.level;
  o_support_ = match.o_support;
  RunActions(rule, id);
  if (core_.observers.Wants(Event::kFiring)) TellFired(id);
  core_.preferences.LinkToGoal(id);
  made_.push_back(id);
  if (match.level > 1) core_.chunker.Consider(id);
}

void Firing::TellMade(InstantiationId id) {
  const FiringInfo info = core_.descriptions.DescribeInstantiation(id);
  core_.observers.Notify(Event::kAssertion, [&](Observer& o) { o.OnInstantiationMade(core_.agent, info); });
}

void Firing::TellFiring(InstantiationId id) {
  const FiringInfo info = core_.descriptions.DescribeInstantiation(id);
  core_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnFiring(core_.agent, info); });
}

void Firing::TellFired(InstantiationId id) {
  std::vector<PreferenceId> made;
  for (PreferenceId p = core_.instantiations[id].preferences; p != PreferenceId::kNone;
       p = core_.memory.preference(p).next_of_instantiation) {
    made.push_back(p);
  }
  const FiringInfo info = core_.descriptions.DescribeInstantiation(id);
  core_.observers.Notify(Event::kFiring, [&](Observer& o) { o.OnFired(core_.agent, info, made); });
}

void Firing::TraceConditions(InstantiationId id, std::span<const WmeId> wmes) {
  const GoalLevel level = core_.instantiations[id].level;
  const std::span<ConditionTrace> traces = core_.instantiations.MakeTrace(id, wmes.size());
  for (std::size_t n = 0; n < wmes.size(); ++n) traces[n] = TraceOf(wmes[n], level);
  if (core_.selections.OfGoal(level) != SelectionKnowledge::kNone || core_.preferences.prohibits() != 0) {
    core_.chunker.NoteSelection(id);
  }
}

ConditionTrace Firing::TraceOf(WmeId wme, GoalLevel level) {
  const ConditionTrace trace = LookAt(wme, level);
  if (trace.preference != PreferenceId::kNone) core_.preferences.AddReference(trace.preference);
  core_.changes.AddReference(wme);
  return trace;
}

ConditionTrace Firing::LookAt(WmeId wme, GoalLevel level) const {
  // A justification may depend on an element that was removed since. The preference that created such an element may
  // have been removed, too.
  const WmeRecord& record = core_.memory.record(wme);
  PreferenceId preference = record.removing ? PreferenceId::kNone : record.preference;
  bool inherits = false;
  if (preference != PreferenceId::kNone) {
    inherits = core_.memory.preference(preference).level == level;
    if (!inherits) preference = CloneAtLevel(preference, level);
  }
  return {wme, core_.memory.level(core_.memory.wme(wme).id), inherits, preference};
}

void Firing::TraceCopied(InstantiationId id) {
  const GoalLevel level = core_.instantiations[id].level;
  std::vector<ConditionTrace> more;
  for (const RuleContext::Copied& copied : core_.context.copied()) {
    if (core_.instantiations[id].trace_count + more.size() == kMostTraced) break;
    if (copied.element != WmeId::kNone) more.push_back(TraceOf(copied.element, level));
  }
  core_.instantiations.ExtendTrace(id, more);
  core_.chunker.NoteCopied(id, core_.context.copied());
}

PreferenceId Firing::CloneAtLevel(PreferenceId preference, GoalLevel level) const {
  const WorkingMemory& memory = core_.memory;
  if (memory.preference(preference).level == level) return preference;
  for (PreferenceId p = memory.preference(preference).next_clone; p != PreferenceId::kNone;
       p = memory.preference(p).next_clone) {
    if (memory.preference(p).level == level) return p;
  }
  for (PreferenceId p = memory.preference(preference).previous_clone; p != PreferenceId::kNone;
       p = memory.preference(p).previous_clone) {
    if (memory.preference(p).level == level) return p;
  }
  return PreferenceId::kNone;
}

void Firing::RunActions(const Production& rule, InstantiationId id) {
  if (rule.type == ProductionType::kTemplate) return RunTemplate(rule, id);
  const std::size_t new_count = rule.new_identifiers.size();
  if (new_identifiers_.size() < new_count) new_identifiers_.resize(new_count);
  for (std::size_t n = 0; n < new_count; ++n) new_identifiers_[n] = Symbol();
  core_.context.SetFiring(id);
  std::uint16_t number = 0;
  for (const Action& action : rule.actions) {
    RunAction(action, number++, id);
    if (core_.context.HasCopied()) [[unlikely]]
      core_.context.MakeCopies();
  }
  core_.context.SetFiring(InstantiationId::kNone);
  if (core_.context.HasCopied()) [[unlikely]] {
    if (match_level_ > 1) TraceCopied(id);
    core_.context.ForgetCopied();
  }
}

void Firing::RunTemplate(const Production& rule, InstantiationId id) {
  if (rule.actions.size() != 1) return;
  core_.context.SetFiring(id);
  const Symbol value = Evaluate(rule.actions.front().referent);
  core_.context.SetFiring(InstantiationId::kNone);
  const Instantiation& instantiation = core_.instantiations[id];
  const std::size_t count = core_.rete.Wmes(instantiation.match).size();
  if (value) core_.reinforcement.templates().Instantiate(instantiation.production, rule, {wmes_.data(), count}, value);
}

void Firing::RunAction(const Action& action, std::uint16_t number, InstantiationId id) {
  if (action.is_function_call) {
    Evaluate(action.value);
    return;
  }
  level_ = match_level_;
  const Symbol object = Evaluate(action.id);
  if (!object) return;
  if (!object.IsIdentifier()) {
    core_.context.PrintError(BadIdentifier(core_.symbols, object, action));
    return;
  }
  // The new identifier is reachable from the object, so its initial level is that of the object.
  const IdentifierRecord& record = core_.memory.known_identifier(object);
  const bool is_goal = record.is_goal;
  level_ = record.level;
  const Symbol attribute = Evaluate(action.attribute);
  if (!attribute) return;
  const Symbol value = Evaluate(action.value);
  if (!value) return;
  PreferenceType type = action.preference;
  Symbol referent;
  if (action.HasReferent()) {
    referent = Evaluate(action.referent);
    if (!referent) return;
    // The parser reads `= x` as binary; only now is the value of x known.
    if (type == PreferenceType::kBinaryIndifferent && referent.IsNumber()) type = PreferenceType::kNumericIndifferent;
    if (type == PreferenceType::kNumericIndifferent) {
      referent = core_.reinforcement.values().Number(core_.instantiations[id].production, referent);
    }
  }
  // In slots other than a state's operator slot, only these two types count.
  if (type != PreferenceType::kAcceptable && type != PreferenceType::kReject &&
      !(is_goal && attribute == words::kOperator)) [[unlikely]] {
    return;
  }
  core_.preferences.Make(id, object, attribute, value, referent, type, o_support_, number);
}

Symbol Firing::BoundValue(BindingSite site) const {
  return FieldOf(core_.memory.wme(wmes_[site.positive_condition]), site.field);
}

Symbol Firing::EvaluateRare(const RhsValue& value) {
  if (value.kind == RhsValueKind::kNew) {
    Symbol& made = new_identifiers_[value.new_index()];
    if (!made) made = core_.memory.NewIdentifier(LetterOfIdentifier(core_.symbols.Text(value.symbol())), level_);
    return made;
  }
  // Arguments are on a stack, so that nested calls do not allocate.
  const std::size_t base = argument_stack_.size();
  bool all_known = true;
  for (const RhsValue& argument : value.arguments()) {
    const Symbol symbol = Evaluate(argument);
    argument_stack_.push_back(symbol);
    all_known = all_known && symbol;
  }
  // Arguments after one without a value are evaluated nevertheless, because they may print.
  if (!all_known) {
    argument_stack_.resize(base);
    return {};
  }
  const std::span<const Symbol> arguments(argument_stack_.data() + base, argument_stack_.size() - base);
  const Symbol result = kernel::Evaluate(core_.context, value.function_index(), arguments);
  argument_stack_.resize(base);
  core_.run.StopIfBroken();
  return result;
}

}  // namespace soarbox::kernel
