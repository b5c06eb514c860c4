// SPDX-License-Identifier: BSD-2-Clause
#include "cli/trace_printer.h"

#include <fmt/format.h>

#include <algorithm>

#include "cli/object_printer.h"
#include "cli/printed_rule.h"
#include "cli/rl_update_log.h"
#include "cli/session.h"
#include "cli/stack_printer.h"
#include "diagnostics/name_table.h"
#include "kernel/decide/exploration.h"
#include "kernel/longterm/episodic_memory.h"
#include "kernel/longterm/long_term.h"
#include "kernel/longterm/semantic_memory.h"
#include "kernel/rules/print_production.h"

namespace soarbox::cli {
namespace {

using kernel::Agent;
using kernel::Event;
using kernel::FiringInfo;
using kernel::FiringType;
using kernel::GoalInfo;
using kernel::Phase;
using kernel::WmeInfo;

const char* TypeName(FiringType type) {
  return type == FiringType::kPe ? "PE" : "IE";
}

/// The input phase's lines end with a blank.
const char* PhaseTitle(Phase phase) {
  static constexpr const char* kNames[] = {"Input Phase --- ", "Propose Phase ---", "Decision Phase ---",
                                           "Application Phase ---", "Output Phase ---"};
  return NameIn(kNames, phase);
}

std::string Level(kernel::GoalLevel level) {
  return level > 1 ? fmt::format(" [level {}]", level) : std::string();
}

}  // namespace

TraceFlag FlagOf(const FiringInfo& info) {
  if (!info.rule) return TraceFlag::kJustifications;
  switch (info.rule->type) {
    case kernel::ProductionType::kUser:
      return TraceFlag::kUserRules;
    case kernel::ProductionType::kDefault:
      return TraceFlag::kDefaultRules;
    case kernel::ProductionType::kChunk:
      return TraceFlag::kChunks;
    case kernel::ProductionType::kJustification:
      return TraceFlag::kJustifications;
    case kernel::ProductionType::kTemplate:
      return TraceFlag::kTemplates;
  }
  return TraceFlag::kUserRules;
}

TracePrinter::~TracePrinter() {
  session_.agent().RemoveObserver(*this);
}

void TracePrinter::Update() {
  const TraceSettings& trace = session_.trace();
  kernel::EventMask mask = Event::kPrint | Event::kRun;
  const auto want = [&](bool on, Event event) {
    if (on) mask = mask | event;
  };
  const bool firings = trace.On(TraceFlag::kUserRules) || trace.On(TraceFlag::kDefaultRules) ||
                       trace.On(TraceFlag::kChunks) || trace.On(TraceFlag::kJustifications) ||
                       trace.On(TraceFlag::kTemplates) || trace.On(TraceFlag::kWaterfall) ||
                       !session_.watched_rules().empty();
  want(trace.On(TraceFlag::kPhases), Event::kPhase);
  want(trace.On(TraceFlag::kPhases) || trace.On(TraceFlag::kWaterfall), Event::kElaboration);
  want(firings, Event::kFiring);
  want(trace.On(TraceFlag::kWmes), Event::kWme);
  want(trace.On(TraceFlag::kPreferences) || (firings && trace.wme_detail() != WmeDetail::kNone), Event::kPreference);
  const bool decisions =
      trace.On(TraceFlag::kDecisions) || trace.On(TraceFlag::kConsistency) || trace.On(TraceFlag::kGds);
  want(decisions, Event::kDecision);
  want(decisions, Event::kDecisionTrace);
  want(trace.On(TraceFlag::kGds) || trace.On(TraceFlag::kGdsWmes), Event::kGds);
  want(trace.On(TraceFlag::kAssertions), Event::kAssertion);
  want(trace.learning() > 0, Event::kLearning);
  want(trace.On(TraceFlag::kChunkWarnings), Event::kNotLearned);
  backtrace_.Listen(trace.On(TraceFlag::kBacktracing));
  want(trace.On(TraceFlag::kIndifferent), Event::kExploration);
  want(trace.On(TraceFlag::kRl), Event::kReinforcement);
  want(trace.On(TraceFlag::kWma), Event::kActivation);
  kernel::LongTerm& long_term = session_.agent().long_term();
  if (trace.On(TraceFlag::kSmem) || kernel::SemanticMemory::Find(long_term) != nullptr) {
    kernel::SemanticMemory::Of(long_term).SetTrace(trace.On(TraceFlag::kSmem),
                                                   session_.agent().settings().like != kernel::SoarVersion::k963);
  }
  if (trace.On(TraceFlag::kEpmem) || kernel::EpisodicMemory::Find(long_term) != nullptr) {
    kernel::EpisodicMemory::Of(long_term).SetTrace(trace.On(TraceFlag::kEpmem));
  }
  session_.agent().AddObserver(*this, mask);
}

void TracePrinter::Print(const std::string& text) {
  session_.stream().Print(text);
}

void TracePrinter::OnPhaseBegin(const Agent&, Phase phase) {
  Print(fmt::format("\n--- {}\n", PhaseTitle(phase)));
}

void TracePrinter::OnPhaseEnd(const Agent&, Phase phase) {
  Print(fmt::format("\n--- END {}\n", PhaseTitle(phase)));
}

void TracePrinter::OnPreferencePhase(const Agent& agent, FiringType type, kernel::GoalLevel level) {
  if (!session_.trace().On(TraceFlag::kPhases) || agent.next_phase() != Phase::kApply) return;
  Print(fmt::format("\t--- Firing Productions ({}) For State At Depth {} ---\n", TypeName(type), level));
}

void TracePrinter::OnInnerElaboration(const Agent& agent, kernel::GoalLevel level, kernel::Symbol goal) {
  if (!session_.trace().On(TraceFlag::kWaterfall)) return;
  Print(fmt::format("\n--- Inner Elaboration Phase, active level {} goal {} ---\n", level,
                    goal ? SymbolText(agent, goal) : std::string("#")));
}

void TracePrinter::OnWorkingMemoryPhase(const Agent& agent, FiringType type) {
  if (!session_.trace().On(TraceFlag::kPhases) || agent.next_phase() != Phase::kApply) return;
  Print(fmt::format("\t--- Change Working Memory ({}) ---\n", TypeName(type)));
}

bool TracePrinter::ShowsFiring(const FiringInfo& info) const {
  const std::vector<std::string>& watched = session_.watched_rules();
  return session_.trace().On(FlagOf(info)) || std::find(watched.begin(), watched.end(), info.name) != watched.end();
}

void TracePrinter::PrintMatched(const Agent& agent, const FiringInfo& info) {
  const WmeDetail detail = session_.trace().wme_detail();
  if (detail == WmeDetail::kNone) return;
  if (detail == WmeDetail::kTimetags) {
    for (const kernel::WmeId wme : info.wmes) Print(fmt::format(" {}", agent.memory().wme(wme).timetag));
  } else {
    for (const kernel::WmeId wme : info.wmes) Print(MatchedText(agent, wme, info.level) + "\n");
  }
  Print(" -->\n");
}

void TracePrinter::OnFiring(const Agent& agent, const FiringInfo& info) {
  if (!ShowsFiring(info)) return;
  Print(fmt::format("\nFiring {}\n", RuleName(agent, info.name)));
  PrintMatched(agent, info);
}

void TracePrinter::OnFired(const Agent& agent, const FiringInfo& info,
                           std::span<const kernel::PreferenceId> preferences) {
  if (session_.trace().wme_detail() == WmeDetail::kNone || !ShowsFiring(info)) return;
  for (const kernel::PreferenceId id : preferences) PrintPreference(agent, id);
}

void TracePrinter::PrintPreference(const Agent& agent, kernel::PreferenceId id) {
  const kernel::Preference& preference = agent.memory().preference(id);
  session_.stream().FreshLine();
  Print(" " + PreferenceText(agent, preference) + Level(preference.level) + "\n");
}

void TracePrinter::OnInhibited(const Agent& agent, const FiringInfo& info) {
  if (!session_.trace().On(TraceFlag::kWaterfall)) return;
  Print(
      fmt::format("*** Waterfall: aborting firing because ({} * *) level {} is on or higher (lower int) "
                  "than change level {}\n",
                  SymbolText(agent, info.touched), agent.memory().level(info.touched), info.change_level));
}

void TracePrinter::OnRetracting(const Agent& agent, const FiringInfo& info) {
  if (!ShowsFiring(info)) return;
  Print(fmt::format("\nRetracting {}\n", RuleName(agent, info.name)));
  retracting_ = session_.trace().wme_detail() != WmeDetail::kNone;
  PrintMatched(agent, info);
}

void TracePrinter::OnRetracted(const Agent&, const FiringInfo&) {
  retracting_ = false;
}

bool TracePrinter::PassesFilters(const Agent& agent, const WmeInfo& wme, bool added) const {
  const auto fits = [&](const std::string& pattern, kernel::Symbol symbol) {
    return pattern == "*" || pattern == SymbolText(agent, symbol) ||
           pattern == kernel::ToString(agent.symbols(), symbol, false);
  };
  for (const WmeFilter& filter : session_.wme_filters()) {
    if (!(added ? filter.adds : filter.removes)) continue;
    if (!fits(filter.id, wme.id) || !fits(filter.attribute, wme.attribute) || !fits(filter.value, wme.value)) {
      return false;
    }
  }
  return true;
}

void TracePrinter::OnWmeAdded(const Agent& agent, const WmeInfo& wme) {
  if (PassesFilters(agent, wme, true)) Print("=>WM: " + WmeText(agent, wme, true, true) + "\n");
}

void TracePrinter::OnWmeRemoved(const Agent& agent, const WmeInfo& wme) {
  if (PassesFilters(agent, wme, false)) Print("<=WM: " + WmeText(agent, wme) + "\n");
}

void TracePrinter::PrintPreferenceChange(const Agent& agent, kernel::PreferenceId id, char sign,
                                         std::string_view remark) {
  const kernel::Preference& preference = agent.memory().preference(id);
  session_.stream().FreshLine();
  Print(fmt::format("{} {}{} ({}){}\n", sign, PreferenceText(agent, preference), Level(preference.level),
                    RuleName(agent, agent.ProductionName(preference.instantiation)), remark));
}

void TracePrinter::OnPreferenceAdded(const Agent& agent, kernel::PreferenceId id) {
  if (session_.trace().On(TraceFlag::kPreferences)) PrintPreferenceChange(agent, id, '+');
}

void TracePrinter::OnPreferenceIgnored(const Agent& agent, kernel::PreferenceId id) {
  if (session_.trace().On(TraceFlag::kPreferences)) {
    PrintPreferenceChange(agent, id, '+', " ALREADY SUPPORTED ON TOP LEVEL.  IGNORING.");
  }
}

void TracePrinter::OnPreferenceRemoved(const Agent& agent, kernel::PreferenceId id) {
  if (retracting_) PrintPreference(agent, id);
  if (session_.trace().On(TraceFlag::kPreferences)) PrintPreferenceChange(agent, id, '-');
}

void TracePrinter::OnDecision(const Agent& agent, const GoalInfo& goal, std::uint64_t decision) {
  if (!session_.trace().On(TraceFlag::kDecisions)) return;
  const std::string cycle = std::to_string(decision);
  Print("\n" + (goal.op ? OperatorLine(agent, goal, cycle) : StateLine(agent, goal, cycle)));
}

void TracePrinter::OnStateRemoved(const Agent& agent, const GoalInfo& goal, kernel::GoalRemoval why) {
  if (!session_.trace().On(TraceFlag::kConsistency)) return;
  const char* reason = nullptr;
  switch (why) {
    case kernel::GoalRemoval::kDecision:
      reason = "of a decision.";
      break;
    case kernel::GoalRemoval::kWrongImpasseType:
      reason = "it's the wrong type of impasse.";
      break;
    case kernel::GoalRemoval::kOperatorRemoval:
      reason = "of an operator removal.";
      break;
    case kernel::GoalRemoval::kGdsChange:
    case kernel::GoalRemoval::kInconsistent:
    case kernel::GoalRemoval::kWithSuperstate:
    case kernel::GoalRemoval::kInit:
      return;
  }
  session_.stream().FreshLine();
  Print(fmt::format("Removing state {} because {}\n", SymbolText(agent, goal.goal), reason));
}

void TracePrinter::OnOperatorRemoved(const Agent& agent, const GoalInfo&, kernel::OperatorRemoval why,
                                     const WmeInfo& wme) {
  if (!session_.trace().On(TraceFlag::kConsistency) || why != kernel::OperatorRemoval::kProposalGone) return;
  Print("\n        REMOVING: Operator from context slot (proposal no longer matches): " + WmeText(agent, wme) + "\n");
}

void TracePrinter::OnInconsistentDecision(const Agent& agent, const GoalInfo& goal) {
  if (!session_.trace().On(TraceFlag::kConsistency)) return;
  const std::string id = SymbolText(agent, goal.goal);
  Print(fmt::format(
      "Removing substates of {0} because the operator last selected in {0} is not\n"
      "consistent with the current preferences.\n\n"
      "{1}          Decision for goal [{0}] is inconsistent.  Replacing it with....\n",
      id, goal.op ? "" : "       REMOVING CONTEXT SLOT: Slot Identifier [" + id + "] and attribute [operator]\n\n"));
}

void TracePrinter::OnGdsAdded(const Agent& agent, const GoalInfo& goal, const WmeInfo& wme) {
  if (!session_.trace().On(TraceFlag::kGdsWmes)) return;
  session_.stream().FreshLine();
  Print(fmt::format("Adding to GDS for {}: {}\n", SymbolText(agent, goal.goal), WmeText(agent, wme)));
}

void TracePrinter::OnGdsViolation(const Agent& agent, const GoalInfo& goal, const WmeInfo& wme) {
  const std::string id = SymbolText(agent, goal.goal);
  if (session_.trace().On(TraceFlag::kGds)) {
    session_.stream().FreshLine();
    Print(fmt::format("Removing state {} because element in GDS changed. WME: {}\n", id, WmeText(agent, wme)));
    Print(fmt::format("\n    REMOVING GOAL [{}] due to change in GDS WME {}\n", id, WmeText(agent, wme)));
  }
}

void TracePrinter::OnPrint(const Agent&, std::string_view text) {
  if (session_.output().agent_writes) session_.stream().Print(text);
}

void TracePrinter::OnError(const Agent&, std::string_view text) {
  // The messages of log, trace, dont-learn and force-learn start on a new line; all others continue the current line.
  for (const std::string_view beginning :
       {"Error: First argument of agent's (", "Error: non-identifier (", "Error: identifier passed to "}) {
    if (text.starts_with(beginning)) session_.stream().FreshLine();
  }
  session_.stream().Print(text);
}

void TracePrinter::OnLog(const Agent&, int channel, std::string_view text) {
  const std::vector<bool>& channels = session_.output().log_channels;
  const auto index = static_cast<std::size_t>(channel - 1);
  if (!session_.output().agent_writes) return;
  if (channel >= 1 && index < channels.size() && channels[index]) session_.stream().Print(text);
}

void TracePrinter::OnTraceText(const Agent&, int level, std::string_view text) {
  if (level <= session_.trace().level()) session_.stream().Print(text);
}

void TracePrinter::OnWarning(const Agent& agent, kernel::WarningKind kind, std::string_view text) {
  switch (kind) {
    case kernel::WarningKind::kGoalStackLimit:
      Print(
          fmt::format("\nGoal stack depth exceeded {} on a no-change impasse.\n"
                      "Soar appears to be in an infinite loop.  \n"
                      "Continuing to subgoal may cause Soar to \n"
                      "exceed the program stack of your system.\n",
                      agent.settings().max_goal_depth));
      return;
    case kernel::WarningKind::kMaxElaborationsPropose:
      if (!session_.output().warnings) return;
      Print("\nWarning: reached max-elaborations; proceeding to decide phase.");
      return;
    case kernel::WarningKind::kMaxElaborationsApply:
      if (!session_.output().warnings) return;
      Print("\nWarning: reached max-elaborations; proceeding to output phase.");
      return;
    case kernel::WarningKind::kAddedAndRemoved:
      if (session_.trace().On(TraceFlag::kWmes)) {
        Print(fmt::format("WARNING: WME added and removed in same phase : {}\n", text));
      }
      return;
    case kernel::WarningKind::kLearnedRule:
      session_.stream().FreshLine();
      Print(std::string(text));
      return;
    case kernel::WarningKind::kMaxDecisionTime:
    case kernel::WarningKind::kOther:
      if (session_.output().warnings) session_.stream().Print(text);
      return;
  }
}

void TracePrinter::OnRuleInterrupt(const Agent& agent, kernel::ProductionId rule, std::uint32_t count) {
  Print(
      fmt::format("\n*** Production match-time interrupt (:interrupt), probably from {}\n"
                  "    [Phase] (Interrupt, Stop) is [{}] ({},1)\n",
                  RuleName(agent, agent.production(rule).name), static_cast<int>(agent.next_phase()), count + 1));
}

void TracePrinter::OnInterrupt(const Agent&, std::string_view reason) {
  if (reason == "goal stack limit") {
    Print("\nSystem halted.\n");
    session_.stream().PrintUncounted("Interrupt received.Interrupt received.");
    return;
  }
  if (reason.starts_with("(interrupt)")) {
    // The action (interrupt). Soar prints an empty line for it only if the run is by phases.
    if (reason.size() > std::string_view("(interrupt)").size()) Print("\n\n");
  } else {
    Print("\n" + std::string(reason) + (reason.empty() ? "" : "\n"));
  }
  session_.stream().PrintUncounted("Interrupt received.");
}

void TracePrinter::OnHalt(const Agent&) {
  Print("\nSystem halted.\n");
  session_.stream().PrintUncounted("Interrupt received.This Agent halted.");
}

void TracePrinter::OnInstantiationMade(const Agent& agent, const FiringInfo& info) {
  Print(fmt::format("\nNew match of {} in state {} (level {}).  Creating instantiation.\n", RuleName(agent, info.name),
                    info.goal ? SymbolText(agent, info.goal) : std::string("none"), info.level));
}

void TracePrinter::OnInstantiationAsserted(const Agent& agent, const FiringInfo& info) {
  Print(fmt::format("\n      asserting instantiation: {}\n", RuleName(agent, info.name)));
}

void TracePrinter::OnLearning(const Agent&, std::string_view name) {
  Print(fmt::format("\n\nLearning new rule {}\n", name));
}

void TracePrinter::OnLearned(const Agent& agent, const FiringInfo& info) {
  if (session_.trace().learning() < 2) return;
  const kernel::ProductionPtr literal = agent.JustificationOf(info.instantiation);
  if (literal == nullptr && info.rule == nullptr) return;
  std::string rule = RuleText(agent, literal != nullptr ? *literal : *info.rule, false);
  rule.pop_back();  // Without the empty line after it.
  Print("\n" + rule);
}

void TracePrinter::OnDuplicateLearned(const Agent&, std::string_view name, std::string_view original) {
  Print(fmt::format("Ignoring {} because it is a duplicate of {}\n", name, original));
}

void TracePrinter::OnFollowed(const Agent& agent, kernel::WmeId wme) {
  const kernel::Wme& element = agent.memory().wme(wme);
  const auto text = [&](kernel::Symbol symbol) {
    return symbol.IsFloat() ? fmt::format("{:g}", agent.symbols().FloatValue(symbol))
                            : kernel::ToString(agent.symbols(), symbol, false);
  };
  // Soar 9.6.3 prints the attribute instead of an object.
  Print(fmt::format("WMA @{}: add {} {} {} {}\n", agent.counters().decision_phases, element.timetag,
                    SymbolText(agent, element.id), text(element.attribute),
                    text(element.value.IsIdentifier() ? element.attribute : element.value)));
}

void TracePrinter::OnFollowedGone(const Agent& agent, std::uint64_t timetag) {
  Print(fmt::format("WMA @{}: remove {}\n", agent.counters().decision_phases, timetag));
}

void TracePrinter::OnUses(const Agent& agent, std::uint64_t timetag, std::uint64_t uses) {
  Print(fmt::format("WMA @{}: activate {} {}\n", agent.counters().decision_phases, timetag, uses));
}

void TracePrinter::OnNotLearned(const Agent& agent, kernel::NotLearned why, const FiringInfo& info) {
  const auto left_out = [&](std::string_view reason) {
    Print(fmt::format("\nWill not attempt to learn a chunk for match of {} because state {} {}", info.name,
                      SymbolText(agent, info.goal), reason));
  };
  switch (why) {
    case kernel::NotLearned::kExcluded:
      left_out("was flagged to prevent learning");
      return;
    case kernel::NotLearned::kNotForced:
      left_out("was not flagged for learning");
      return;
    case kernel::NotLearned::kNotLowest:
      left_out("is not the bottom state");
      return;
    case kernel::NotLearned::kTooMany:
      session_.stream().FreshLine();
      Print("Warning: Maximum number of chunks reached.  Skipping opportunity to learn new rule.\n");
      return;
    case kernel::NotLearned::kTooManyAlike:
      session_.stream().FreshLine();
      Print(
          fmt::format("Warning: Rule has produced maximum number of duplicate chunks this decision cycle.  Skipping "
                      "opportunity to learn new rule.\n"
                      "         Rule that has reached the max-dupes limit: {}\n",
                      info.name));
      return;
    case kernel::NotLearned::kUnconditional:
      Print(
          fmt::format("\nWarning: Soar has created a chunk or justification with no conditions.  Ignoring.\n\n"
                      "         Any results created will lose support when the sub-state disappears.\n"
                      "         To avoid this issue, the problem-solving in the sub-state must\n"
                      "         positively test at least one item in the super-state.\n\n"
                      "Rule firing that led to invalid chunk: {}\n",
                      info.name));
      return;
  }
}

void TracePrinter::OnLocalNegation(const Agent& agent, const kernel::Production& negation) {
  std::string text = "\n*** Rule learned that used negative reasoning about local sub-state.***\n";
  AppendNegation(text, agent, negation.conditions.front());
  Print(text + "\n");
}

void TracePrinter::OnCandidate(const Agent& agent, kernel::Symbol candidate, double value, double probability) {
  const kernel::ExplorationPolicy policy = agent.exploration().policy;
  if (policy != kernel::ExplorationPolicy::kEpsilonGreedy && policy != kernel::ExplorationPolicy::kBoltzmann) return;
  Print(fmt::format("\n Candidate {}:  Value (Sum) = {:f}", SymbolText(agent, candidate), value));
  if (policy == kernel::ExplorationPolicy::kBoltzmann) Print(fmt::format(", (Prob) = {:f}", probability));
}

void TracePrinter::OnRlUpdate(const Agent& agent, const kernel::RlUpdate& update) {
  Print(RlUpdateText(agent, update) + "\n");
}

void TracePrinter::OnRewardGap(const Agent& agent, kernel::Symbol state, bool begins) {
  Print(fmt::format("gap {} ({})", begins ? "started" : "ended", SymbolText(agent, state)));
}

std::string PreferenceText(const Agent& agent, const kernel::Preference& preference, bool support) {
  std::string text =
      fmt::format("({} ^{} {} {}", SymbolText(agent, preference.id), SymbolText(agent, preference.attribute),
                  SymbolText(agent, preference.value), kernel::PreferenceSign(preference.type));
  if (preference.referent) text += " " + SymbolText(agent, preference.referent);
  if (support && preference.o_supported) text += "  :O ";
  return text + ")";
}

}  // namespace soarbox::cli
