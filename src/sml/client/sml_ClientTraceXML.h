// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstring>

#include "sml_ClientXML.h"

namespace sml {

/// A part of a structured trace. IsTag...() returns its kind; Get...() returns an attribute, or NULL if it does not
/// exist.
class EXPORT ClientTraceXML : public ClientXML {
 public:
  ClientTraceXML();
  explicit ClientTraceXML(soarxml::ElementXML const& element);
  ~ClientTraceXML() override;

  bool IsTagTrace() const { return IsTag("trace"); }
  bool IsTagState() const { return IsTag("state"); }
  bool IsTagOperator() const { return IsTag("operator"); }
  bool IsTagRhsWrite() const { return IsTag("rhs_write"); }
  bool IsTagPhase() const { return IsTag("phase"); }
  bool IsTagSubphase() const { return IsTag("subphase"); }
  bool IsTagFiringProduction() const { return IsTag("firing_production"); }
  bool IsTagRetractingProduction() const { return IsTag("retracting_production"); }
  bool IsTagLearning() const { return IsTag("learning"); }
  bool IsTagProduction() const { return IsTag("production"); }
  bool IsTagConditions() const { return IsTag("conditions"); }
  bool IsTagCondition() const { return IsTag("condition"); }
  bool IsTagConjunctiveNegationCondition() const { return IsTag("conjunctive-negation-condition"); }
  bool IsTagActions() const { return IsTag("actions"); }
  bool IsTagAction() const { return IsTag("action"); }
  bool IsTagAddWme() const { return IsTag("adding_wme"); }
  bool IsTagRemoveWme() const { return IsTag("removing_wme"); }
  bool IsTagWme() const { return IsTag("wme"); }
  bool IsTagPreference() const { return IsTag("preference"); }
  bool IsTagActionSideMarker() const { return IsTag("actionsidemarker"); }
  bool IsTagLocal() const { return IsTag("local"); }
  bool IsTagLocals() const { return IsTag("locals"); }
  bool IsTagGrounds() const { return IsTag("grounds"); }
  bool IsTagNegated() const { return IsTag("negated"); }
  bool IsTagBacktrace() const { return IsTag("backtrace"); }
  bool IsTagOSKPreference() const { return IsTag("osk-preference"); }
  bool IsTagBacktraceResult() const { return IsTag("result"); }
  bool IsTagLocalNegation() const { return IsTag("local-negation"); }
  bool IsTagCandidate() const { return IsTag("candidate"); }
  bool IsTagError() const { return IsTag("error"); }
  bool IsTagWarning() const { return IsTag("warning"); }
  bool IsTagMessage() const { return IsTag("message"); }
  bool IsTagVerbose() const { return IsTag("verbose"); }

  bool IsSubphaseNameFiringProductions() const { return IsPhaseNamed("firingprods"); }
  bool IsSubphaseNameChangingWorkingMemory() const { return IsPhaseNamed("changingwm"); }

  char const* GetString() const { return GetAttribute("string"); }
  char const* GetDecisionCycleCount() const { return GetAttribute("decision_cycle_count"); }
  char const* GetStateID() const { return GetAttribute("current_state_id"); }
  char const* GetImpasseObject() const { return GetAttribute("impasse_object"); }
  char const* GetImpasseType() const { return GetAttribute("impasse_type"); }
  char const* GetStackLevel() const { return GetAttribute("stack_level"); }
  char const* GetOperatorID() const { return GetAttribute("current_operator_id"); }
  char const* GetOperatorName() const { return GetAttribute("name"); }
  char const* GetPhaseName() const { return GetAttribute("name"); }
  char const* GetPhaseStatus() const { return GetAttribute("status"); }
  char const* GetFiringType() const { return GetAttribute("firing_type"); }
  char const* GetLevelNum() const { return GetAttribute("level_num"); }
  char const* GetProductionName() const { return GetAttribute("prodname"); }
  char const* GetProductionDoc() const { return GetAttribute("documentation"); }
  char const* GetProductionType() const { return GetAttribute("type"); }
  char const* GetProductionDeclaredSupport() const { return GetAttribute("declared-support"); }
  char const* GetConditionTest() const { return GetAttribute("test"); }
  char const* GetConditionId() const { return GetAttribute("id"); }
  char const* GetCondition() const { return GetAttribute("condition"); }
  char const* GetActionId() const { return GetAttribute("id"); }
  char const* GetAction() const { return GetAttribute("action"); }
  char const* GetFunction() const { return GetAttribute("function"); }
  char const* GetWmeID() const { return GetAttribute("id"); }
  char const* GetWmeAttribute() const { return GetAttribute("attr"); }
  char const* GetWmeValue() const { return GetAttribute("value"); }
  char const* GetWmeTimeTag() const { return GetAttribute("tag"); }
  char const* GetWmePreference() const { return GetAttribute("preference"); }
  char const* GetPreferenceID() const { return GetAttribute("id"); }
  char const* GetPreferenceAttribute() const { return GetAttribute("attr"); }
  char const* GetPreferenceValue() const { return GetAttribute("value"); }
  char const* GetPreferenceTimeTag() const { return GetAttribute("tag"); }
  char const* GetPreferenceType() const { return GetAttribute("pref_type"); }
  char const* GetPreferenceOSupported() const { return GetAttribute("o_supported"); }
  char const* GetPreferenceReferent() const { return GetAttribute("referent"); }
  char const* GetBacktraceAlreadyBacktraced() const { return GetAttribute("already-backtraced"); }
  char const* GetBacktraceSymbol1() const { return GetAttribute("symbol1"); }
  char const* GetBacktraceSymbol2() const { return GetAttribute("symbol2"); }
  char const* GetCandidateName() const { return GetAttribute("name"); }
  char const* GetCandidateType() const { return GetAttribute("type"); }
  char const* GetCandidateValue() const { return GetAttribute("value"); }
  char const* GetCandidateExpValue() const { return GetAttribute("exp"); }

 private:
  bool IsPhaseNamed(char const* name) const {
    char const* found = GetPhaseName();
    return found && std::strcmp(found, name) == 0;
  }
};

}  // namespace sml
