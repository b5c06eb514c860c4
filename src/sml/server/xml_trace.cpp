// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/xml_trace.h"

#include <cstdint>
#include <string_view>

#include "cli/object_printer.h"
#include "cli/rl_update_log.h"
#include "cli/stack_printer.h"
#include "cli/trace_printer.h"
#include "kernel/base/known_symbols.h"
#include "kernel/decide/exploration.h"
#include "kernel/rules/print_production.h"
#include "sml/server/hosted_agent.h"
#include "sml/wire/message.h"

namespace soarbox::server {

using cli::TraceFlag;
using kernel::Event;

namespace {

/// Maximum size in bytes of a trace that no client takes; a larger one is discarded.
constexpr std::size_t kMaxBytes = 16u << 20;

const char* TypeName(kernel::FiringType type) {
  return type == kernel::FiringType::kPe ? "PE" : "IE";
}

}  // namespace

void XmlTracer::Set(const kernel::Agent& agent, std::string_view name, kernel::Symbol symbol) {
  symbol_.clear();
  kernel::AppendTo(symbol_, agent.symbols(), symbol, true);
  pen_.Set(name, symbol_);
}

/// <wme attr id [preference] tag valtype value>
void XmlTracer::AddWme(const kernel::Agent& agent, const kernel::WmeInfo& wme) {
  pen_.Begin("wme");
  Set(agent, "attr", wme.attribute);
  Set(agent, "id", wme.id);
  if (wme.acceptable) pen_.Set("preference", "+");
  pen_.Set("tag", wme.timetag).Set("valtype", cli::ValueTypeName(wme.value));
  Set(agent, "value", wme.value);
  pen_.End("wme");
}

void XmlTracer::AddText(std::string_view tag, std::string_view text) {
  pen_.Begin(tag).Set("string", text).End(tag);
}

XmlTracer::~XmlTracer() {
  if (subscribed_) hosted_.agent().RemoveObserver(*this);
}

void XmlTracer::SetOn(bool on) {
  if (on == on_) return;
  on_ = on;
  pieces_.clear();
  Refresh();
}

void XmlTracer::Refresh() {
  if (!on_) {
    if (subscribed_) hosted_.agent().RemoveObserver(*this);
    subscribed_ = false;
    return;
  }
  const cli::TraceSettings& trace = hosted_.session().trace();
  const auto on = [&](TraceFlag flag) { return trace.On(flag); };
  // The output phase is always observed, because the trace is sent at its start.
  kernel::EventMask mask = Event::kPrint | Event::kRun;
  mask = mask | Event::kPhase;
  if (on(TraceFlag::kPhases)) mask = mask | Event::kElaboration;
  if (on(TraceFlag::kUserRules) || on(TraceFlag::kDefaultRules) || on(TraceFlag::kChunks) ||
      on(TraceFlag::kJustifications) || on(TraceFlag::kTemplates)) {
    mask = mask | Event::kFiring;
    if (Detailed()) mask = mask | Event::kPreference;
  }
  if (on(TraceFlag::kWmes)) mask = mask | Event::kWme;
  if (on(TraceFlag::kPreferences)) mask = mask | Event::kPreference;
  if (on(TraceFlag::kDecisions) || on(TraceFlag::kConsistency)) mask = mask | Event::kDecision | Event::kDecisionTrace;
  if (on(TraceFlag::kIndifferent)) mask = mask | Event::kExploration;
  if (on(TraceFlag::kRl)) mask = mask | Event::kReinforcement;
  hosted_.agent().AddObserver(*this, mask);
  subscribed_ = true;
}

bool XmlTracer::Take(std::string& pieces) {
  if (pieces_.empty()) return false;
  pieces.clear();
  pieces.swap(pieces_);
  return true;
}

void XmlTracer::OnPhaseBegin(const kernel::Agent&, kernel::Phase phase) {
  if (pieces_.size() > kMaxBytes) pieces_.clear();
  if (hosted_.session().trace().On(TraceFlag::kPhases))
    pen_.Begin("phase").Set("name", cli::PhaseName(phase)).End("phase");
  if (phase == kernel::Phase::kOutput) hosted_.FlushXmlTrace();
}

void XmlTracer::OnPhaseEnd(const kernel::Agent&, kernel::Phase phase) {
  if (!hosted_.session().trace().On(TraceFlag::kPhases)) return;
  pen_.Begin("phase").Set("name", cli::PhaseName(phase)).Set("status", "end").End("phase");
}

void XmlTracer::OnPreferencePhase(const kernel::Agent& agent, kernel::FiringType type, kernel::GoalLevel level) {
  if (agent.next_phase() != kernel::Phase::kApply) return;
  pen_.Begin("subphase").Set("firing_type", TypeName(type)).Set("level_num", std::uint64_t{level});
  pen_.Set("name", "firingprods").End("subphase");
}

void XmlTracer::OnWorkingMemoryPhase(const kernel::Agent& agent, kernel::FiringType type) {
  if (agent.next_phase() != kernel::Phase::kApply) return;
  pen_.Begin("subphase").Set("firing_type", TypeName(type)).Set("name", "changingwm").End("subphase");
}

bool XmlTracer::ShowsFiring(const kernel::FiringInfo& info) const {
  return hosted_.session().trace().On(cli::FlagOf(info));
}

bool XmlTracer::Detailed() const {
  return hosted_.session().trace().wme_detail() != cli::WmeDetail::kNone;
}

void XmlTracer::AddRule(std::string_view tag, const kernel::Agent& agent, const kernel::FiringInfo& info) {
  pen_.Begin(tag).Begin("production").Set("prodname", info.name);
  if (Detailed()) {
    for (const kernel::WmeId wme : info.wmes) {
      pen_.Begin("wme").Set("tag", agent.memory().wme(wme).timetag).End("wme");
    }
  }
  pen_.End("production").End(tag);
}

void XmlTracer::OnFiring(const kernel::Agent& agent, const kernel::FiringInfo& info) {
  if (!ShowsFiring(info)) return;
  AddRule("firing_production", agent, info);
  if (Detailed()) pen_.Begin("actionsidemarker").End("actionsidemarker");
}

void XmlTracer::OnFired(const kernel::Agent& agent, const kernel::FiringInfo& info,
                        std::span<const kernel::PreferenceId> preferences) {
  if (!Detailed() || !ShowsFiring(info)) return;
  for (const kernel::PreferenceId id : preferences) AddPreference(agent, id);
}

void XmlTracer::OnRetracting(const kernel::Agent& agent, const kernel::FiringInfo& info) {
  if (!ShowsFiring(info)) return;
  AddRule("retracting_production", agent, info);
  pen_.Begin("actionsidemarker").End("actionsidemarker");
  retracting_ = Detailed();
}

void XmlTracer::OnRetracted(const kernel::Agent&, const kernel::FiringInfo&) {
  retracting_ = false;
}

void XmlTracer::OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo& wme) {
  pen_.Begin("adding_wme");
  AddWme(agent, wme);
  pen_.End("adding_wme");
}

void XmlTracer::OnWmeRemoved(const kernel::Agent& agent, const kernel::WmeInfo& wme) {
  pen_.Begin("removing_wme");
  AddWme(agent, wme);
  pen_.End("removing_wme");
}

void XmlTracer::AddPreference(const kernel::Agent& agent, kernel::PreferenceId id) {
  const kernel::Preference& preference = agent.memory().preference(id);
  pen_.Begin("preference");
  Set(agent, "attr", preference.attribute);
  Set(agent, "id", preference.id);
  if (preference.o_supported) pen_.Set("o_supported", ":O");
  pen_.Set("pref_type", kernel::PreferenceSign(preference.type));
  if (preference.referent) Set(agent, "referent", preference.referent);
  Set(agent, "value", preference.value);
  pen_.End("preference");
}

void XmlTracer::OnPreferenceAdded(const kernel::Agent& agent, kernel::PreferenceId id) {
  if (hosted_.session().trace().On(TraceFlag::kPreferences)) AddPreference(agent, id);
}

void XmlTracer::OnPreferenceIgnored(const kernel::Agent& agent, kernel::PreferenceId id) {
  OnPreferenceAdded(agent, id);
}

void XmlTracer::OnPreferenceRemoved(const kernel::Agent& agent, kernel::PreferenceId id) {
  if (retracting_) AddPreference(agent, id);
  if (hosted_.session().trace().On(TraceFlag::kPreferences)) AddPreference(agent, id);
}

void XmlTracer::OnDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal, std::uint64_t decision) {
  if (!hosted_.session().trace().On(TraceFlag::kDecisions)) return;
  const std::uint64_t level = goal.level - 1u;
  if (goal.op) {
    pen_.Begin("operator");
    Set(agent, "current_operator_id", goal.op);
    pen_.Set("decision_cycle_count", decision);
    if (const kernel::Symbol name = agent.memory().ValueOf(goal.op, kernel::words::kName)) Set(agent, "name", name);
    pen_.Set("stack_level", level).End("operator");
    return;
  }
  pen_.Begin("state");
  Set(agent, "current_state_id", goal.goal);
  pen_.Set("decision_cycle_count", decision);
  if (goal.impasse != kernel::ImpasseType::kNone) {
    pen_.Set("impasse_object", goal.on_operator ? "operator" : "state")
        .Set("impasse_type", cli::ImpasseName(goal.impasse));
  }
  if (const kernel::Symbol name = agent.memory().ValueOf(goal.goal, kernel::words::kName)) Set(agent, "name", name);
  pen_.Set("stack_level", level).End("state");
}

void XmlTracer::OnOperatorRemoved(const kernel::Agent& agent, const kernel::GoalInfo&, kernel::OperatorRemoval why,
                                  const kernel::WmeInfo& wme) {
  if (!hosted_.session().trace().On(TraceFlag::kConsistency) || why != kernel::OperatorRemoval::kProposalGone) return;
  AddWme(agent, wme);
}

void XmlTracer::OnPrint(const kernel::Agent&, std::string_view text) {
  AddText("rhs_write", text);
}

void XmlTracer::OnWarning(const kernel::Agent&, kernel::WarningKind, std::string_view text) {
  AddText("warning", text);
}

void XmlTracer::OnInterrupt(const kernel::Agent&, std::string_view reason) {
  AddText("message", reason.empty() || reason.starts_with("(interrupt)") ? "Interrupt received." : reason);
}

void XmlTracer::OnHalt(const kernel::Agent&) {
  AddText("message", "Interrupt received.");
  AddText("message", "This Agent halted.");
}

void XmlTracer::OnCandidate(const kernel::Agent& agent, kernel::Symbol candidate, double value, double probability) {
  const kernel::ExplorationPolicy policy = agent.exploration().policy;
  if (policy != kernel::ExplorationPolicy::kEpsilonGreedy && policy != kernel::ExplorationPolicy::kBoltzmann) return;
  pen_.Begin("candidate");
  if (policy == kernel::ExplorationPolicy::kBoltzmann) pen_.Set("exp", wire::FixedDouble(probability));
  Set(agent, "name", candidate);
  pen_.Set("type", "sum").Set("value", wire::FixedDouble(value)).End("candidate");
}

void XmlTracer::OnRlUpdate(const kernel::Agent& agent, const kernel::RlUpdate& update) {
  AddText("message", cli::RlUpdateText(agent, update));
}

void XmlTracer::OnRewardGap(const kernel::Agent& agent, kernel::Symbol state, bool begins) {
  AddText("warning",
          std::string("gap ") + (begins ? "started" : "ended") + " (" + kernel::ToString(agent.symbols(), state) + ")");
}

}  // namespace soarbox::server
