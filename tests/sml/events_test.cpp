// SPDX-License-Identifier: BSD-2-Clause
// The order of events, as in Soar 9.6.3.
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "sml_Client.h"
#include "sml_test_files.h"

namespace {

using namespace sml;

using Log = std::vector<std::string>;

void OnRun(smlRunEventId id, void* log, Agent*, smlPhase phase) {
  static_cast<Log*>(log)->push_back(std::string(Events().ConvertToString(id)) + "(" + std::to_string(phase) + ")");
}

void OnSystem(smlSystemEventId id, void* log, Kernel*) {
  static_cast<Log*>(log)->push_back(Events().ConvertToString(id));
}

void OnUpdate(smlUpdateEventId id, void* log, Kernel*, smlRunFlags flags) {
  static_cast<Log*>(log)->push_back(std::string(Events().ConvertToString(id)) + "(" + std::to_string(flags) + ")");
}

struct Listener {
  Listener()
      : kernel(Kernel::CreateKernelInCurrentThread(false, Kernel::kSuppressListener)), agent(kernel->CreateAgent("a")) {
    for (int id = smlEVENT_SYSTEM_START; id <= smlEVENT_INTERRUPT_CHECK; ++id) {
      kernel->RegisterForSystemEvent(static_cast<smlSystemEventId>(id), OnSystem, &log);
    }
    kernel->RegisterForUpdateEvent(smlEVENT_AFTER_ALL_OUTPUT_PHASES, OnUpdate, &log);
    kernel->RegisterForUpdateEvent(smlEVENT_AFTER_ALL_GENERATED_OUTPUT, OnUpdate, &log);
  }
  void Listen(Agent* to, int first, int last) {
    for (int id = first; id <= last; ++id) to->RegisterForRunEvent(static_cast<smlRunEventId>(id), OnRun, &log);
  }
  Log Take() {
    Log taken;
    taken.swap(log);
    return taken;
  }

  Log log;
  std::unique_ptr<Kernel> kernel;
  Agent* agent;
};

TEST(EventOrder, AFreshRunOfOneDecisionGoesPhaseByPhaseToTheStopPhase) {
  Listener listener;
  listener.Listen(listener.agent, smlEVENT_BEFORE_PHASE_EXECUTED, smlEVENT_AFTER_RUNNING);
  listener.agent->RunSelf(1);
  EXPECT_EQ(listener.Take(), (Log{"system-start",
                                  "before-run-starts(0)",
                                  "before-running(0)",
                                  "before-decision-cycle(0)",
                                  "before-input-phase(0)",
                                  "before-phase-executed(0)",
                                  "after-phase-executed(0)",
                                  "after-input-phase(0)",
                                  "after-running(1)",
                                  "before-running(1)",
                                  "before-propose-phase(1)",
                                  "before-phase-executed(1)",
                                  "after-phase-executed(1)",
                                  "after-propose-phase(1)",
                                  "after-running(2)",
                                  "before-running(2)",
                                  "before-decide-phase(2)",
                                  "before-phase-executed(2)",
                                  "after-phase-executed(2)",
                                  "after-decide-phase(2)",
                                  "after-running(3)",
                                  "after-run-ends(3)",
                                  "system-stop"}));
}

TEST(EventOrder, OfAPhaseEventAndTheOneForAllPhasesTheLaterRegisteredComesFirst) {
  Listener listener;
  listener.agent->RegisterForRunEvent(smlEVENT_BEFORE_INPUT_PHASE, OnRun, &listener.log);
  listener.agent->RegisterForRunEvent(smlEVENT_BEFORE_PHASE_EXECUTED, OnRun, &listener.log);
  listener.agent->RunSelf(1, sml_PHASE);
  const Log log = listener.Take();
  ASSERT_GE(log.size(), 5u);
  EXPECT_EQ(log[3], "before-phase-executed(0)");
  EXPECT_EQ(log[4], "before-input-phase(0)");
}

TEST(EventOrder, RunsAreBracketedWhetherOrNotPhasesAreHeard) {
  for (const bool phases : {false, true}) {
    Listener listener;
    if (phases)
      listener.agent->RegisterForRunEvent(
          smlEVENT_BEFORE_INPUT_PHASE, [](smlRunEventId, void*, Agent*, smlPhase) {}, nullptr);
    listener.agent->RunSelf(1);
    listener.Take();
    listener.Listen(listener.agent, smlEVENT_BEFORE_RUN_STARTS, smlEVENT_AFTER_RUNNING);
    listener.agent->RunSelf(2);
    EXPECT_EQ(listener.Take(), (Log{"system-start",
                                    "before-run-starts(3)",
                                    "interrupt-check",
                                    "before-agents-run-step",
                                    "before-running(3)",
                                    "after-running(0)",
                                    "after-all-output-phases(1)",
                                    "before-agents-run-step",
                                    "before-running(0)",
                                    "after-running(0)",
                                    "after-all-output-phases(1)",
                                    "after-all-generated-output(1)",
                                    "before-running(0)",
                                    "after-running(1)",
                                    "before-running(1)",
                                    "after-running(2)",
                                    "before-running(2)",
                                    "after-running(3)",
                                    "after-run-ends(3)",
                                    "system-stop"}));
  }
}

TEST(EventOrder, AgentsTakeTurnsByPhasesInTheOrderOfTheirNames) {
  Listener listener;
  Agent* other = listener.kernel->CreateAgent("B");
  for (Agent* agent : {listener.agent, other}) {
    agent->RegisterForRunEvent(
        smlEVENT_BEFORE_RUNNING,
        [](smlRunEventId, void* log, Agent* runs, smlPhase phase) {
          static_cast<Log*>(log)->push_back(runs->GetAgentName() + std::to_string(phase));
        },
        &listener.log);
  }
  listener.kernel->RunAllAgents(3, sml_PHASE);
  EXPECT_EQ(listener.Take(),
            (Log{"system-start", "interrupt-check", "before-agents-run-step", "B0", "a0", "before-agents-run-step",
                 "B1", "a1", "before-agents-run-step", "B2", "a2", "system-stop"}));
}

TEST(EventOrder, InputThatAHandlerMakesBeforeTheInputPhaseIsTakenInThatPhase) {
  Listener listener;
  listener.agent->RegisterForRunEvent(
      smlEVENT_BEFORE_INPUT_PHASE,
      [](smlRunEventId, void*, Agent* agent, smlPhase) { agent->CreateIntWME(agent->GetInputLink(), "seen", 1); },
      nullptr);
  listener.agent->RunSelf(1, sml_PHASE);
  EXPECT_NE(std::string(listener.agent->ExecuteCommandLine("print i2")).find("^seen 1"), std::string::npos);
}

TEST(EventOrder, TheResultInsideARunIsThatOfTheRunBefore) {
  Listener listener;
  std::vector<std::string> seen;
  const auto note = [](smlRunEventId event, void* data, Agent* agent, smlPhase) {
    const char* const name = event == smlEVENT_BEFORE_RUN_STARTS    ? "starts"
                             : event == smlEVENT_BEFORE_INPUT_PHASE ? "input"
                                                                    : "ends";
    static_cast<std::vector<std::string>*>(data)->push_back(
        std::string(name) + " " + std::to_string(agent->GetResultOfLastRun()) + " " +
        std::to_string(agent->GetRunState()) + " " + (agent->GetKernel()->IsSoarRunning() ? "running" : "still"));
  };
  for (const smlRunEventId event : {smlEVENT_BEFORE_RUN_STARTS, smlEVENT_BEFORE_INPUT_PHASE, smlEVENT_AFTER_RUN_ENDS}) {
    listener.agent->RegisterForRunEvent(event, note, &seen);
  }
  const auto run = [&](int decisions) {
    seen.clear();
    listener.agent->RunSelf(decisions);
    return seen;
  };
  // Results: 3 completed, 4 completed and interrupted, 2 interrupted, 0 error. States: 0 stopped, 1 interrupted, 2
  // running.
  EXPECT_EQ(run(1), (std::vector<std::string>{"starts 3 0 still", "input 3 2 running", "ends 3 0 running"}));
  const int stopper = listener.agent->RegisterForRunEvent(
      smlEVENT_AFTER_OUTPUT_PHASE, [](smlRunEventId, void*, Agent* agent, smlPhase) { agent->StopSelf(); }, nullptr);
  run(5);
  listener.agent->UnregisterForRunEvent(stopper);
  EXPECT_EQ(listener.agent->GetResultOfLastRun(), sml_RUN_COMPLETED_AND_INTERRUPTED);
  EXPECT_EQ(run(1).front(), "starts 4 1 still");
  listener.agent->ExecuteCommandLine("sp {stop*it (state <s> ^superstate nil) --> (interrupt)}");
  run(5);
  EXPECT_EQ(listener.agent->GetResultOfLastRun(), sml_RUN_INTERRUPTED);
  listener.agent->ExecuteCommandLine("sp {end*it (state <s> ^superstate nil) --> (halt)}");
  run(5);
  EXPECT_EQ(listener.agent->GetResultOfLastRun(), sml_RUN_ERROR);
}

TEST(EventOrder, HaltInterruptsAndHalts) {
  Listener listener;
  listener.agent->ExecuteCommandLine("sp {end*it (state <s> ^superstate nil) --> (halt)}");
  listener.Listen(listener.agent, smlEVENT_AFTER_INTERRUPT, smlEVENT_AFTER_HALTED);
  EXPECT_NE(std::string(listener.agent->RunSelfForever()).find("An agent halted during the run."), std::string::npos);
  const Log log = listener.Take();
  // The agent halts at the end of the propose phase, before the decide phase, like Soar's.
  EXPECT_NE(std::find(log.begin(), log.end(), "after-halted(2)"), log.end());
  EXPECT_EQ(listener.agent->GetRunState(), sml_RUNSTATE_HALTED);
  listener.agent->InitSoar();
  EXPECT_EQ(listener.agent->GetRunState(), sml_RUNSTATE_STOPPED);
}

/// The tags of a trace, one after another: "<phase><firing_production>...".
std::string TraceOf(const std::vector<const char*>& lines) {
  std::string trace;
  const std::unique_ptr<Kernel> kernel(Kernel::CreateKernelInCurrentThread(true, Kernel::kSuppressListener));
  Agent* agent = kernel->CreateAgent("traced");
  agent->RegisterForXMLEvent(
      smlEVENT_XML_TRACE_OUTPUT,
      [](smlXMLEventId, void* text, Agent*, ClientXML* xml) {
        for (int i = 0; i < xml->GetNumberChildren(); ++i) {
          ClientXML child;
          xml->GetChild(&child, i);
          *static_cast<std::string*>(text) += std::string("<") + child.GetTagName() + ">";
        }
      },
      &trace);
  for (const char* line : lines) agent->ExecuteCommandLine(line);
  return trace;
}

TEST(XmlTrace, FiringsInDetailShowTheirPreferencesAndRetractionsEndWithAMarker) {
  constexpr const char* kOnce =
      "sp {once*only (state <s> ^superstate nil -^done) --> (<s> ^operator <o> +) (<o> ^name finish)}";
  constexpr const char* kApply = "sp {apply*finish (state <s> ^operator.name finish) --> (<s> ^done yes)}";
  const std::string brief = TraceOf({kOnce, kApply, "watch 0", "trace --user", "run 4 -p"});
  EXPECT_EQ(brief.find("<preference>"), std::string::npos) << brief;
  EXPECT_NE(brief.find("<retracting_production><actionsidemarker>"), std::string::npos) << brief;
  const std::string detailed = TraceOf({kOnce, kApply, "watch 0", "trace --user", "trace --timetags", "run 4 -p"});
  EXPECT_NE(detailed.find("<firing_production><actionsidemarker><preference><preference>"), std::string::npos)
      << detailed;
  EXPECT_NE(detailed.find("<retracting_production><actionsidemarker><preference><preference>"), std::string::npos)
      << detailed;
}

TEST(XmlTrace, CandidatesAreTracedOnlyByPoliciesThatWeighThemAll) {
  constexpr const char* kOne =
      "sp {propose*one (state <s> ^superstate nil) --> (<s> ^operator <o> + = 3) (<o> ^name one)}";
  constexpr const char* kTwo =
      "sp {propose*two (state <s> ^superstate nil) --> (<s> ^operator <o> + = 4) (<o> ^name two)}";
  EXPECT_EQ(TraceOf({kOne, kTwo, "trace --indifferent", "run 1"}).find("<candidate>"), std::string::npos);
  EXPECT_NE(TraceOf({kOne, kTwo, "trace --indifferent", "decide indifferent-selection --boltzmann", "run 1"})
                .find("<candidate>"),
            std::string::npos);
}

TEST(EventRegistration, TheSameHandlerTwiceIsOneAndUnknownIdsAreErrors) {
  Listener listener;
  const int id = listener.agent->RegisterForRunEvent(smlEVENT_AFTER_OUTPUT_PHASE, OnRun, &listener.log);
  EXPECT_GT(id, 0);
  EXPECT_EQ(listener.agent->RegisterForRunEvent(smlEVENT_AFTER_OUTPUT_PHASE, OnRun, &listener.log), id);
  EXPECT_TRUE(listener.agent->UnregisterForRunEvent(id));
  EXPECT_FALSE(listener.agent->UnregisterForRunEvent(id));
  EXPECT_TRUE(listener.agent->HadError());
  listener.agent->RunSelf(2);
  for (const std::string& entry : listener.Take()) EXPECT_EQ(entry.find("after-output-phase"), std::string::npos);
}

TEST(Filter, ThatAClientRegistersSeesCommandLinesAndMayChangeThem) {
  Listener listener;
  std::string seen;
  const int id = listener.kernel->RegisterForClientMessageEvent(
      sml_Names::kFilterName, [&seen](smlRhsEventId, Agent*, char const*, char const* line) -> std::string {
        seen = line;
        return "<filter command=\"echo changed\"/>";
      });
  const std::string answer = listener.agent->ExecuteCommandLine("print s1");
  EXPECT_NE(seen.find("command=\"print s1\""), std::string::npos) << seen;
  EXPECT_NE(answer.find("changed"), std::string::npos) << answer;
  EXPECT_TRUE(listener.kernel->UnregisterForClientMessageEvent(id));
  EXPECT_NE(std::string(listener.agent->ExecuteCommandLine("print s1")).find("S1 ^"), std::string::npos);
}

TEST(PrintedText, ComesBeforeTheEventThatEndsTheOutputPhase) {
  Listener listener;
  listener.agent->ExecuteCommandLine("soar stop-phase input");
  Log log;
  listener.agent->RegisterForPrintEvent(
      smlEVENT_PRINT, [](smlPrintEventId, void* to, Agent*, char const*) { static_cast<Log*>(to)->push_back("print"); },
      &log);
  listener.agent->RegisterForRunEvent(smlEVENT_AFTER_OUTPUT_PHASE, OnRun, &log);
  listener.agent->RunSelf(2);
  ASSERT_GE(log.size(), 4u);
  EXPECT_EQ(log[0], "print");
  EXPECT_NE(log[1], "print");
  EXPECT_EQ(log[2], "print");
  EXPECT_NE(log[3], "print");
}

}  // namespace
