// SPDX-License-Identifier: BSD-2-Clause
#include "sml/server/xml_trace.h"

#include <algorithm>
#include <string>

#include "cli/trace_printer.h"
#include "kernel/base/words.h"
#include "sml/server/hosted_agent.h"
#include "sml/wire/message.h"

namespace soarbox::server {

using cli::TraceFlag;
using kernel::Event;

namespace {

/// A trace that nobody takes is cut off at this many elements.
constexpr std::size_t kMaxElements = 100'000;

const char* PhaseName(kernel::Phase phase) {
  switch (phase) {
    case kernel::Phase::kInput: return "input";
    case kernel::Phase::kPropose: return "propose";
    case kernel::Phase::kDecide: return "decision";
    case kernel::Phase::kApply: return "apply";
    case kernel::Phase::kOutput: return "output";
  }
  return "";
}

const char* ImpasseName(kernel::ImpasseType impasse) {
  switch (impasse) {
    case kernel::ImpasseType::kTie: return "tie";
    case kernel::ImpasseType::kConflict: return "conflict";
    case kernel::ImpasseType::kConstraintFailure: return "constraint-failure";
    case kernel::ImpasseType::kNoChange: return "no-change";
    case kernel::ImpasseType::kNone: break;
  }
  return "none";
}

const char* TypeName(kernel::FiringType type) { return type == kernel::FiringType::kPe ? "PE" : "IE"; }

TraceFlag FlagOf(const kernel::FiringInfo& info) {
  if (!info.rule) return TraceFlag::kJustifications;
  switch (info.rule->type) {
    case kernel::ProductionType::kUser: return TraceFlag::kUserRules;
    case kernel::ProductionType::kDefault: return TraceFlag::kDefaultRules;
    case kernel::ProductionType::kChunk: return TraceFlag::kChunks;
    case kernel::ProductionType::kJustification: return TraceFlag::kJustifications;
    case kernel::ProductionType::kTemplate: return TraceFlag::kTemplates;
  }
  return TraceFlag::kUserRules;
}

std::string Text(const kernel::Agent& agent, kernel::Symbol symbol) { return kernel::ToString(agent.symbols(), symbol); }

}  // namespace

const char* ValueTypeName(kernel::Symbol symbol) {
  if (symbol.IsIdentifier()) return "id";
  if (symbol.IsInteger()) return "int";
  if (symbol.IsFloat()) return "double";
  return "string";
}

wire::Element WmeElement(const kernel::Agent& agent, const kernel::WmeInfo& wme, bool with_tag) {
  wire::Element element("wme");
  element.Set("attr", Text(agent, wme.attribute)).Set("id", Text(agent, wme.id));
  if (wme.acceptable) element.Set("preference", "+");
  if (with_tag) element.Set("tag", std::to_string(wme.timetag));
  element.Set("valtype", ValueTypeName(wme.value)).Set("value", Text(agent, wme.value));
  return element;
}

XmlTracer::~XmlTracer() {
  if (subscribed_) hosted_.agent().RemoveObserver(*this);
}

void XmlTracer::SetOn(bool on) {
  if (on == on_) return;
  on_ = on;
  trace_->children.clear();
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
  // The output phase is always watched: at its start the trace is sent.
  kernel::EventMask mask = Event::kPrint | Event::kRun;
  mask = mask | Event::kPhase;
  if (on(TraceFlag::kPhases)) mask = mask | Event::kElaboration;
  if (on(TraceFlag::kUserRules) || on(TraceFlag::kDefaultRules) || on(TraceFlag::kChunks) ||
      on(TraceFlag::kJustifications) || on(TraceFlag::kTemplates)) {
    mask = mask | Event::kFiring;
  }
  if (on(TraceFlag::kWmes)) mask = mask | Event::kWme;
  if (on(TraceFlag::kPreferences)) mask = mask | Event::kPreference;
  if (on(TraceFlag::kDecisions) || on(TraceFlag::kConsistency)) mask = mask | Event::kDecision;
  if (on(TraceFlag::kIndifferent)) mask = mask | Event::kExploration;
  hosted_.agent().AddObserver(*this, mask);
  subscribed_ = true;
}

std::shared_ptr<const wire::Element> XmlTracer::Take() {
  if (trace_->children.empty()) return nullptr;
  std::shared_ptr<wire::Element> taken = std::make_shared<wire::Element>("trace");
  taken.swap(trace_);
  return taken;
}

void XmlTracer::OnPhaseBegin(const kernel::Agent&, kernel::Phase phase) {
  if (trace_->children.size() > kMaxElements) trace_->children.clear();
  if (hosted_.session().trace().On(TraceFlag::kPhases)) trace_->Add("phase").Set("name", PhaseName(phase));
  if (phase == kernel::Phase::kOutput) hosted_.FlushXmlTrace();
}

void XmlTracer::OnPhaseEnd(const kernel::Agent&, kernel::Phase phase) {
  if (!hosted_.session().trace().On(TraceFlag::kPhases)) return;
  trace_->Add("phase").Set("name", PhaseName(phase)).Set("status", "end");
}

void XmlTracer::OnPreferencePhase(const kernel::Agent& agent, kernel::FiringType type, kernel::GoalLevel level) {
  if (agent.next_phase() != kernel::Phase::kApply) return;
  trace_->Add("subphase").Set("firing_type", TypeName(type)).Set("level_num", std::to_string(level)).Set("name", "firingprods");
}

void XmlTracer::OnWorkingMemoryPhase(const kernel::Agent& agent, kernel::FiringType type) {
  if (agent.next_phase() != kernel::Phase::kApply) return;
  trace_->Add("subphase").Set("firing_type", TypeName(type)).Set("name", "changingwm");
}

bool XmlTracer::ShowsFiring(const kernel::FiringInfo& info) const { return hosted_.session().trace().On(FlagOf(info)); }

void XmlTracer::AddRule(const char* tag, const kernel::Agent& agent, const kernel::FiringInfo& info) {
  wire::Element& production = trace_->Add(tag).Add("production").Set("prodname", std::string(info.name));
  const cli::WmeDetail detail = hosted_.session().trace().wme_detail();
  if (detail == cli::WmeDetail::kNone) return;
  for (const kernel::WmeId wme : info.wmes) {
    production.Add("wme").Set("tag", std::to_string(agent.memory().wme(wme).timetag));
  }
}

void XmlTracer::OnFiring(const kernel::Agent& agent, const kernel::FiringInfo& info) {
  if (!ShowsFiring(info)) return;
  AddRule("firing_production", agent, info);
  if (hosted_.session().trace().wme_detail() != cli::WmeDetail::kNone) trace_->Add("actionsidemarker");
}

void XmlTracer::OnRetracting(const kernel::Agent& agent, const kernel::FiringInfo& info) {
  if (!ShowsFiring(info)) return;
  AddRule("retracting_production", agent, info);
  if (hosted_.session().trace().On(TraceFlag::kPreferences)) trace_->Add("actionsidemarker");
}

void XmlTracer::OnWmeAdded(const kernel::Agent& agent, const kernel::WmeInfo& wme) {
  trace_->Add("adding_wme").children.push_back(WmeElement(agent, wme));
}

void XmlTracer::OnWmeRemoved(const kernel::Agent& agent, const kernel::WmeInfo& wme) {
  trace_->Add("removing_wme").children.push_back(WmeElement(agent, wme));
}

void XmlTracer::AddPreference(const kernel::Agent& agent, kernel::PreferenceId id) {
  const kernel::Preference& preference = agent.memory().preference(id);
  wire::Element& element = trace_->Add("preference");
  element.Set("attr", Text(agent, preference.attribute)).Set("id", Text(agent, preference.id));
  if (preference.o_supported) element.Set("o_supported", ":O");
  element.Set("pref_type", std::string(1, cli::PreferenceCharacter(preference.type)));
  if (preference.referent) element.Set("referent", Text(agent, preference.referent));
  element.Set("value", Text(agent, preference.value));
}

void XmlTracer::OnPreferenceAdded(const kernel::Agent& agent, kernel::PreferenceId id) { AddPreference(agent, id); }

void XmlTracer::OnPreferenceRemoved(const kernel::Agent& agent, kernel::PreferenceId id) { AddPreference(agent, id); }

void XmlTracer::OnDecision(const kernel::Agent& agent, const kernel::GoalInfo& goal, std::uint64_t decision) {
  if (!hosted_.session().trace().On(TraceFlag::kDecisions)) return;
  const std::string level = std::to_string(goal.level - 1);
  if (goal.op) {
    wire::Element& element = trace_->Add("operator");
    element.Set("current_operator_id", Text(agent, goal.op)).Set("decision_cycle_count", std::to_string(decision));
    const kernel::Symbol name = agent.memory().ValueOf(goal.op, kernel::words::kName);
    if (name) element.Set("name", Text(agent, name));
    element.Set("stack_level", level);
    return;
  }
  wire::Element& element = trace_->Add("state");
  element.Set("current_state_id", Text(agent, goal.goal)).Set("decision_cycle_count", std::to_string(decision));
  if (goal.impasse != kernel::ImpasseType::kNone) {
    element.Set("impasse_object", goal.on_operator ? "operator" : "state").Set("impasse_type", ImpasseName(goal.impasse));
  }
  element.Set("stack_level", level);
  const kernel::Symbol name = agent.memory().ValueOf(goal.goal, kernel::words::kName);
  if (name) element.Set("name", Text(agent, name));
}

void XmlTracer::OnOperatorRemoved(const kernel::Agent& agent, const kernel::GoalInfo&, kernel::OperatorRemoval why,
                                  const kernel::WmeInfo& wme) {
  if (!hosted_.session().trace().On(TraceFlag::kConsistency) || why != kernel::OperatorRemoval::kProposalGone) return;
  trace_->children.push_back(WmeElement(agent, wme));
}

void XmlTracer::OnPrint(const kernel::Agent&, std::string_view text) {
  trace_->Add("rhs_write").Set("string", std::string(text));
}

void XmlTracer::OnWarning(const kernel::Agent&, kernel::WarningKind, std::string_view text) {
  trace_->Add("warning").Set("string", std::string(text));
}

void XmlTracer::OnInterrupt(const kernel::Agent&, std::string_view reason) {
  trace_->Add("message").Set("string", reason.empty() ? "Interrupt received." : std::string(reason));
}

void XmlTracer::OnHalt(const kernel::Agent&) { trace_->Add("message").Set("string", "This Agent halted."); }

void XmlTracer::OnCandidate(const kernel::Agent& agent, kernel::Symbol candidate, double value, double probability) {
  trace_->Add("candidate")
      .Set("exp", wire::FixedDouble(probability))
      .Set("name", Text(agent, candidate))
      .Set("type", "sum")
      .Set("value", wire::FixedDouble(value));
}

}  // namespace soarbox::server
