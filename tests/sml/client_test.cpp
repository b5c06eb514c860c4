// SPDX-License-Identifier: BSD-2-Clause
// The client API in one process, as programs use it.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "sml_Client.h"
#include "sml_test_files.h"

namespace {

using namespace sml;

struct Program {
  explicit Program(bool new_thread = false)
      : kernel(new_thread ? Kernel::CreateKernelInNewThread(Kernel::kSuppressListener)
                          : Kernel::CreateKernelInCurrentThread(false, Kernel::kSuppressListener)),
        rules("sml_client_test", kMoverRules) {
    agent = kernel->CreateAgent("mover");
    EXPECT_TRUE(agent->LoadProductions(rules.path().c_str())) << agent->GetLastErrorDescription();
    agent->ExecuteCommandLine("watch 0");
  }

  std::unique_ptr<Kernel> kernel;
  RuleFile rules;
  Agent* agent;
};

/// The loop of the thesis' sandbox agents: update, run, read commands, complete them.
TEST(ClientLoop, AnAgentActsOnEveryInputAndItsCommandsAreCompleted) {
  for (const bool new_thread : {false, true}) {
    Program program(new_thread);
    Agent* pAgent = program.agent;
    pAgent->SetBlinkIfNoChange(TRUE);
    Identifier* pInputLink = pAgent->GetInputLink();
    FloatElement* pWME1 = pAgent->CreateFloatWME(pInputLink, "distance", 0);
    std::vector<std::string> names;
    for (const double distance : {10.0, 10.0, 2.0, 50.25}) {
      pAgent->Update(pWME1, distance);
      pAgent->RunSelfTilOutput();
      const int numberCommands = pAgent->GetNumberCommands();
      for (int i = 0; i < numberCommands; i++) {
        Identifier* pCommand = pAgent->GetCommand(i);
        names.push_back(pCommand->GetCommandName());
        EXPECT_STREQ(pCommand->GetParameterValue("MODE"), "walk");
        pCommand->AddStatusComplete();
      }
    }
    EXPECT_EQ(names, (std::vector<std::string>{"forward", "forward", "stop", "forward"}));
    EXPECT_FALSE(pAgent->HadError()) << pAgent->GetLastErrorDescription();
  }
}

TEST(ClientInput, TimeTagsAndNamesAreTheClientsOwnAndBelongToTheKernel) {
  Program program;
  Identifier* link = program.agent->GetInputLink();
  EXPECT_EQ(link, program.agent->GetInputLink());
  EXPECT_EQ(link->GetTimeTag(), -2);
  EXPECT_STREQ(link->GetAttribute(), "input-link");
  EXPECT_STREQ(link->GetValueAsString(), "I2");
  FloatElement* third = link->CreateFloatWME("third", 1.0 / 3);
  EXPECT_EQ(third->GetTimeTag(), -3);
  EXPECT_STREQ(third->GetValueAsString(), "0.3333333333333333");
  Identifier* plane = program.agent->CreateIdWME(link, "Plane");
  EXPECT_STREQ(plane->GetValueAsString(), "p2");
  EXPECT_STREQ(program.agent->CreateIdWME(link, "9lives")->GetValueAsString(), "a3");
  program.agent->Update(third, 0.5);
  EXPECT_EQ(third->GetTimeTag(), -6);
  Agent* other = program.kernel->CreateAgent("other");
  EXPECT_EQ(other->GetInputLink()->GetTimeTag(), -7);

  EXPECT_STREQ(program.agent->ConvertIdentifier("p2"), "p2");
  program.agent->RunSelf(1);
  EXPECT_STREQ(program.agent->ConvertIdentifier("p2"), "P1");
}

TEST(ClientInput, StructureIsSharedCreatedAndDestroyed) {
  Program program;
  Agent* agent = program.agent;
  Identifier* link = agent->GetInputLink();
  Identifier* plane = agent->CreateIdWME(link, "plane");
  agent->CreateStringWME(plane, "type", "F-18");
  IntElement* count = plane->CreateIntWME("n", 7);
  Identifier* copy = agent->CreateSharedIdWME(link, "copy", plane);
  EXPECT_EQ(agent->CreateSharedIdWME(link, "plane", plane), nullptr) << "the element itself";
  Identifier* again = agent->CreateSharedIdWME(link, "copy", plane);
  ASSERT_NE(again, nullptr) << "as in Soar, there may be two of one attribute and value";
  EXPECT_EQ(link->GetNumberChildren(), 3);
  agent->RunSelf(1);
  const auto copies = [&] {
    const std::string text = agent->ExecuteCommandLine("print --internal i2");
    int count = 0;
    for (std::size_t at = text.find("^copy"); at != std::string::npos; at = text.find("^copy", at + 1)) ++count;
    return count;
  };
  EXPECT_EQ(copies(), 2);
  EXPECT_TRUE(again->DestroyWME());
  agent->RunSelf(1);
  EXPECT_EQ(copies(), 1);
  EXPECT_EQ(copy->GetNumberChildren(), 2);
  EXPECT_EQ(plane->FindByAttribute("N", 0), count);
  agent->RunSelf(1);
  EXPECT_NE(std::string(agent->ExecuteCommandLine("print --depth 2 i2")).find("^type F-18"), std::string::npos);

  EXPECT_TRUE(plane->DestroyWME());
  EXPECT_EQ(copy->GetNumberChildren(), 2);
  EXPECT_TRUE(copy->DestroyWME());
  EXPECT_EQ(link->GetNumberChildren(), 0);
  EXPECT_FALSE(link->DestroyWME());
  agent->RunSelf(1);
  EXPECT_EQ(std::string(agent->ExecuteCommandLine("print --depth 2 i2")).find("F-18"), std::string::npos);
}

TEST(ClientInput, ChildrenAreWalkedBothWaysWhileOthersComeAndGo) {
  Program program;
  Identifier* thing = program.agent->GetInputLink()->CreateIdWME("thing");
  EXPECT_TRUE(thing->GetChildrenBegin() == thing->GetChildrenEnd());
  std::vector<IntElement*> parts;
  for (int n = 0; n < 5; ++n) parts.push_back(thing->CreateIntWME("part", n));
  const auto values = [&] {
    std::vector<long long> found;
    for (Identifier::ChildrenIter child = thing->GetChildrenBegin(); child != thing->GetChildrenEnd(); ++child) {
      found.push_back((*child)->ConvertToIntElement()->GetValue());
    }
    return found;
  };
  for (const int gone : {0, 4, 2}) EXPECT_TRUE(parts[static_cast<std::size_t>(gone)]->DestroyWME());
  EXPECT_EQ(values(), (std::vector<long long>{1, 3}));
  for (int n = 5; n < 50; ++n)
    thing->CreateIntWME("part", n);  // Some of them have the memory addresses of removed ones.
  EXPECT_EQ(thing->GetNumberChildren(), 47);
  EXPECT_EQ(values().front(), 1);
  EXPECT_EQ(values().back(), 49);
  Identifier::ChildrenIter last = thing->GetChildrenEnd();
  EXPECT_EQ((*--last)->ConvertToIntElement()->GetValue(), 49);
  EXPECT_EQ((*std::prev(last, 46))->ConvertToIntElement()->GetValue(), 1);
  EXPECT_EQ(std::distance(thing->GetChildrenBegin(), thing->GetChildrenEnd()), 47);
  EXPECT_EQ(thing->GetChild(46), *last);
  EXPECT_EQ(thing->GetChild(47), nullptr);
}

TEST(ClientInput, TextsAndAttributesOfAnyLengthAndNumberStayAsTheyWereGiven) {
  Program program;
  Identifier* link = program.agent->GetInputLink();
  // More and longer attributes than agents share.
  std::vector<StringElement*> made;
  for (std::size_t n = 0; n < 6000; ++n) {
    made.push_back(link->CreateStringWME(("a" + std::to_string(n) + std::string(n % 90, '-')).c_str(),
                                         std::string(n % 40, 'x').c_str()));
  }
  for (std::size_t n = 0; n < made.size(); ++n) {
    ASSERT_EQ(made[n]->GetAttribute(), "a" + std::to_string(n) + std::string(n % 90, '-'));
    ASSERT_EQ(made[n]->GetValue(), std::string(n % 40, 'x'));
  }
  StringElement* text = made.front();
  for (const std::size_t size : {15u, 16u, 14u, 100u, 17u, 0u, 101u}) {
    program.agent->Update(text, std::string(size, 'y').c_str());
    EXPECT_EQ(text->GetValue(), std::string(size, 'y'));
    program.agent->Update(text, text->GetValue());
    EXPECT_STREQ(text->GetValueAsString(), text->GetValue());
  }
  for (StringElement* element : made) EXPECT_TRUE(element->DestroyWME());
  EXPECT_EQ(link->GetNumberChildren(), 0);
  EXPECT_STREQ(link->CreateStringWME("a0", "again")->GetAttribute(), "a0");
}

TEST(ClientInput, StaleHandlesAreErrorsAndNotCrashes) {
  Program program;
  Agent* agent = program.agent;
  FloatElement* gone = agent->CreateFloatWME(agent->GetInputLink(), "x", 1.0);
  Identifier* place = agent->CreateIdWME(agent->GetInputLink(), "place");
  StringElement* inside = place->CreateStringWME("name", "here");
  EXPECT_TRUE(agent->DestroyWME(gone));
  EXPECT_TRUE(agent->DestroyWME(place));
  EXPECT_FALSE(agent->DestroyWME(gone));
  EXPECT_TRUE(agent->HadError());
  EXPECT_NE(std::string(agent->GetLastErrorDescription()).find("removed"), std::string::npos);
  gone->Update(2.0);
  inside->Update("there");
  EXPECT_EQ(place->CreateIntWME("n", 1), nullptr);
  EXPECT_EQ(place->GetNumberChildren(), 0);
  EXPECT_EQ(agent->CreateIdWME(nullptr, "x"), nullptr);
  agent->RunSelf(1);

  Agent* other = program.kernel->CreateAgent("other");
  EXPECT_EQ(agent->CreateIntWME(other->GetInputLink(), "n", 1), nullptr);
  EXPECT_TRUE(program.kernel->DestroyAgent(other));
  EXPECT_FALSE(program.kernel->IsAgentValid(other));
  EXPECT_FALSE(program.kernel->DestroyAgent(other));
  EXPECT_EQ(other->GetInputLink() == nullptr || other->CreateIntWME(other->GetInputLink(), "n", 1) == nullptr, true);
  EXPECT_STREQ(other->RunSelf(1), "The agent has been destroyed");
}

TEST(ClientInput, ChangesWaitForTheCommitWhenAutoCommitIsOff) {
  Program program;
  program.kernel->SetAutoCommit(false);
  Agent* agent = program.agent;
  FloatElement* distance = agent->CreateFloatWME(agent->GetInputLink(), "distance", 1.0);
  FloatElement* never = agent->CreateFloatWME(agent->GetInputLink(), "never", 1.0);
  agent->DestroyWME(never);
  agent->Update(distance, 10.0);
  EXPECT_TRUE(agent->IsCommitRequired());
  EXPECT_STREQ(agent->RunSelfTilOutput(), "Need to commit changes before calling a run method");
  EXPECT_TRUE(agent->Commit());
  agent->RunSelfTilOutput();
  ASSERT_EQ(agent->GetNumberCommands(), 1);
  EXPECT_STREQ(agent->GetCommand(0)->GetCommandName(), "forward");
  EXPECT_EQ(std::string(agent->ExecuteCommandLine("print i2")).find("never"), std::string::npos);
}

TEST(ClientOutput, CommandsAreListedOnceAndHandlersHearOfThemAfterNotifications) {
  Program program;
  Agent* agent = program.agent;
  std::vector<std::string> heard;
  agent->AddOutputHandler(
      "forward",
      [](void* data, Agent*, char const* name, WMElement* wme) {
        static_cast<std::vector<std::string>*>(data)->push_back(std::string(name) + " " + wme->GetValueAsString());
      },
      &heard);
  agent->RegisterForOutputNotification(
      [](void* data, Agent* told) {
        static_cast<std::vector<std::string>*>(data)->push_back("changes " +
                                                                std::to_string(told->GetNumberOutputLinkChanges()));
      },
      &heard);
  EXPECT_EQ(agent->GetOutputLink(), nullptr);
  agent->CreateFloatWME(agent->GetInputLink(), "distance", 10.0);
  agent->RunSelfTilOutput();
  ASSERT_EQ(heard.size(), 2u);
  EXPECT_EQ(heard[0], "changes 3");
  EXPECT_EQ(heard[1].substr(0, 8), "forward ");
  ASSERT_NE(agent->GetOutputLink(), nullptr);
  EXPECT_EQ(agent->GetNumberCommands(), 1);
  EXPECT_EQ(agent->GetCommand(1), nullptr);
  EXPECT_TRUE(agent->IsOutputLinkChangeAdd(0));
  EXPECT_STREQ(agent->GetCommand(0)->FindByAttribute("speed", 0)->GetValueType(), "double");
  // After the next apply phase the command is no longer new.
  agent->RunSelf(2);
  EXPECT_EQ(agent->GetNumberCommands(), 0);
}

TEST(ClientOutput, InitSoarKeepsInputAndDropsOutput) {
  Program program;
  Agent* agent = program.agent;
  FloatElement* distance = agent->CreateFloatWME(agent->GetInputLink(), "distance", 10.0);
  agent->RunSelfTilOutput();
  ASSERT_EQ(agent->GetNumberCommands(), 1);
  const long long tag = distance->GetTimeTag();
  EXPECT_STREQ(agent->InitSoar(), "\nAgent reinitialized.\n");
  EXPECT_EQ(agent->GetNumberCommands(), 0);
  EXPECT_EQ(distance->GetTimeTag(), tag);
  agent->RunSelfTilOutput();
  ASSERT_EQ(agent->GetNumberCommands(), 1);
  EXPECT_STREQ(agent->GetCommand(0)->GetCommandName(), "forward");
  agent->Update(distance, 1.0);
  EXPECT_FALSE(agent->HadError()) << agent->GetLastErrorDescription();
}

TEST(ClientErrors, LoadingAFaultyFileNamesFileLineAndColumnAndLoadsTheRest) {
  Program program;
  const RuleFile faulty(
      "sml_faulty",
      "sp {good*rule (state <s> ^superstate nil) --> (<s> ^a b)}\nsp {bad*rule (state <s> ^x <y>) (<s> ^a b)}\n");
  EXPECT_FALSE(program.agent->LoadProductions(faulty.path().c_str()));
  EXPECT_TRUE(program.agent->HadError());
  const std::string text = program.agent->GetLastErrorDescription();
  EXPECT_NE(text.find(faulty.path() + ":2:"), std::string::npos) << text;
  EXPECT_TRUE(program.agent->IsProductionLoaded("good*rule"));
  EXPECT_FALSE(program.agent->LoadProductions("no/such/file.soar"));
  EXPECT_NE(std::string(program.agent->GetLastErrorDescription()).find("no/such/"), std::string::npos);
  EXPECT_FALSE(program.kernel->HadError());
  EXPECT_EQ(program.kernel->CreateAgent("mover"), nullptr);
  EXPECT_STREQ(program.kernel->GetLastErrorDescription(),
               "Trying to create an agent that already exists in the kernel.");
}

/// Number of occurrences of `part` in `text`.
std::size_t Count(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
  return count;
}

TEST(ClientErrors, OfManyFaultyRulesEachIsToldOnceAndSoAreTheWarningsOfTheOthers) {
  Program program;
  constexpr int kLines = 3000;
  std::string rules;
  for (int line = 1; line <= kLines; ++line) {
    const std::string number = std::to_string(line);
    // The error in the first one is printed, the remark about the second is not.
    rules += "sp {rule*" + number + " (state <s> ^superstate nil) --> (" +
             (line % 2 == 1 ? "<unknown" + number + "> ^name value" : "<s> ^name n" + number) + ")}\n";
  }
  const RuleFile faulty("sml_many_faulty", rules);
  EXPECT_FALSE(program.agent->LoadProductions(faulty.path().c_str()));
  const std::string text = program.agent->GetLastErrorDescription();
  EXPECT_EQ(Count(text, ": error: "), kLines / 2);
  EXPECT_EQ(Count(text, ": warning: "), kLines / 2);
  std::vector<int> told(kLines + 1);
  const std::string place = faulty.path() + ":";
  for (std::size_t at = text.find(place); at != std::string::npos; at = text.find(place, at + place.size())) {
    ++told.at(std::stoul(text.substr(at + place.size(), 10)));
  }
  EXPECT_EQ(std::count(told.begin() + 1, told.end(), 1), kLines);
}

TEST(ClientErrors, ATakenPortIsAnErrorThatNamesItAndTheKernelStillWorks) {
  const std::unique_ptr<Kernel> first(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
  ASSERT_FALSE(first->HadError()) << first->GetLastErrorDescription();
  const int port = first->GetListenerPort();
  EXPECT_GT(port, 0);
  const std::unique_ptr<Kernel> second(Kernel::CreateKernelInNewThread(port));
  EXPECT_TRUE(second->HadError());
  EXPECT_NE(std::string(second->GetLastErrorDescription()).find(std::to_string(port)), std::string::npos);
  EXPECT_EQ(second->GetListenerPort(), 0);
  ASSERT_NE(second->CreateAgent("agent"), nullptr);
  EXPECT_FALSE(second->HadError());
}

TEST(ClientKernels, ThreeKernelsWithAgentsOfTheSameNameCoexist) {
  std::vector<std::unique_ptr<Kernel>> kernels;
  for (int i = 0; i < 3; ++i) {
    kernels.emplace_back(Kernel::CreateKernelInNewThread(Kernel::kUseAnyPort));
    ASSERT_FALSE(kernels.back()->HadError());
    Agent* agent = kernels.back()->CreateAgent("agent");
    ASSERT_NE(agent, nullptr);
    agent->ExecuteCommandLine(
        ("sp {mine (state <s> ^superstate nil) --> (<s> ^kernel " + std::to_string(i) + ")}").c_str());
  }
  for (int i = 0; i < 3; ++i) {
    Agent* agent = kernels[static_cast<std::size_t>(i)]->GetAgent("agent");
    agent->RunSelf(1);
    EXPECT_NE(std::string(agent->ExecuteCommandLine("print s1")).find("^kernel " + std::to_string(i)),
              std::string::npos);
  }
}

TEST(ClientRuns, RunningOneAgentDoesNotTouchTheOthers) {
  Program program;
  Agent* other = program.kernel->CreateAgent("another");
  program.agent->RunSelf(3);
  EXPECT_GT(program.agent->GetDecisionCycleCounter(), 0);
  EXPECT_EQ(other->GetDecisionCycleCounter(), 0);
  EXPECT_FALSE(other->WasAgentOnRunList());
  program.kernel->RunAllAgents(2);
  EXPECT_EQ(other->GetDecisionCycleCounter(), 2);
  EXPECT_TRUE(other->WasAgentOnRunList());
  EXPECT_EQ(other->GetResultOfLastRun(), sml_RUN_COMPLETED);
}

TEST(ClientRuns, RunTextsCountAsSoarCounts) {
  Program program;
  EXPECT_STREQ(program.agent->RunSelf(1), "\n\n--> 1 decision cycle executed. No rules fired. ");
  EXPECT_STREQ(program.agent->RunSelf(1), "\n\n--> 2 decision cycles executed. No rules fired. ");
  EXPECT_STREQ(program.agent->RunSelf(1), "\n\n--> 1 decision cycle executed. No rules fired. ");
  EXPECT_STREQ(program.agent->RunSelf(-1), "Count must be positive.");
  EXPECT_FALSE(program.agent->GetLastCommandLineResult());
  const std::unique_ptr<Kernel> direct(Kernel::CreateKernelInCurrentThread(true, Kernel::kSuppressListener));
  EXPECT_STREQ(direct->CreateAgent("a")->RunSelf(1), "DirectRun completed");
}

TEST(ClientRuns, AnotherThreadCanStopARunWithoutEnd) {
  Program program(true);
  program.agent->ExecuteCommandLine("excise --all");
  program.agent->ExecuteCommandLine(kCounterRules);
  std::thread stopper([&] {
    while (!program.kernel->IsSoarRunning()) std::this_thread::yield();
    program.kernel->StopAllAgents();
  });
  program.agent->RunSelfForever();
  stopper.join();
  EXPECT_EQ(program.agent->GetRunState(), sml_RUNSTATE_INTERRUPTED);
  EXPECT_EQ(program.agent->GetResultOfLastRun(), sml_RUN_COMPLETED_AND_INTERRUPTED);
}

TEST(ClientRuns, HandlersMayDestroyTheirAgentAndStartNoSecondRun) {
  Program program;
  std::string nested;
  program.agent->RegisterForRunEvent(
      smlEVENT_AFTER_DECIDE_PHASE,
      [](smlRunEventId, void* data, Agent* agent, smlPhase) {
        *static_cast<std::string*>(data) = agent->RunSelf(1);
        agent->GetKernel()->DestroyAgent(agent);
      },
      &nested);
  program.agent->RunSelf(5);
  EXPECT_EQ(nested, "Soar is already running");
  EXPECT_EQ(program.kernel->GetNumberAgents(), 0);
}

TEST(ClientCommands, HandlersMayDestroyTheirAgentInTheMiddleOfACommand) {
  const std::unique_ptr<Kernel> kernel(Kernel::CreateKernelInCurrentThread(false, Kernel::kSuppressListener));
  const auto on_print = [](smlPrintEventId, void*, Agent* agent, char const*) {
    agent->GetKernel()->DestroyAgent(agent);
  };
  const auto on_rule = [](smlProductionEventId, void*, Agent* agent, char const*, char const*) {
    agent->GetKernel()->DestroyAgent(agent);
  };
  Agent* printing = kernel->CreateAgent("printing");
  printing->RegisterForPrintEvent(smlEVENT_PRINT, on_print, nullptr);
  kernel->CreateAgent("second")->RegisterForPrintEvent(smlEVENT_PRINT, on_print, nullptr);
  kernel->ExecuteCommandLine("run 2", "printing");
  EXPECT_EQ(kernel->GetNumberAgents(), 0);

  Agent* loading = kernel->CreateAgent("loading");
  loading->RegisterForProductionEvent(smlEVENT_AFTER_PRODUCTION_ADDED, on_rule, nullptr);
  kernel->ExecuteCommandLine("sp {one (state <s> ^superstate nil) --> (<s> ^x y)}\nrun 1\ninit-soar\nprint s1",
                             "loading");
  EXPECT_EQ(kernel->GetNumberAgents(), 0);

  kernel->CreateAgent("starting");
  kernel->RegisterForAgentEvent(
      smlEVENT_BEFORE_AGENT_REINITIALIZED,
      [](smlAgentEventId, void*, Agent* agent) { agent->GetKernel()->DestroyAgent(agent); }, nullptr);
  kernel->ExecuteCommandLine("init-soar", "starting");
  EXPECT_EQ(kernel->GetNumberAgents(), 0);
  EXPECT_NE(kernel->CreateAgent("starting"), nullptr);
  EXPECT_FALSE(kernel->HadError());
}

TEST(ClientFunctions, RulesCallTheProgramAndClientsSendMessages) {
  Program program;
  program.kernel->AddRhsFunction("shout", [](smlRhsEventId, Agent*, char const* name, char const* argument) {
    return std::string(name) + "<" + argument + ">";
  });
  program.agent->ExecuteCommandLine("sp {call (state <s> ^superstate nil) --> (<s> ^answer (exec shout a |b c| 3))}");
  program.agent->RunSelf(1);
  EXPECT_NE(std::string(program.agent->ExecuteCommandLine("print s1")).find("|shout<ab c3>|"), std::string::npos)
      << program.agent->ExecuteCommandLine("print s1");
  EXPECT_EQ(program.kernel->SendClientMessage(program.agent, "nobody", "hi"), "**NOBODY RESPONDED**");
  const int id = program.kernel->RegisterForClientMessageEvent(
      "somebody", [](smlRhsEventId, Agent* agent, char const*, char const* message) {
        return std::string(agent->GetAgentName()) + ":" + message;
      });
  EXPECT_EQ(program.kernel->SendClientMessage(program.agent, "somebody", "hi"), "mover:hi");
  EXPECT_TRUE(program.kernel->UnregisterForClientMessageEvent(id));
  EXPECT_FALSE(program.kernel->UnregisterForClientMessageEvent(id));
}

TEST(ClientXml, StructuredAnswersAreReadByName) {
  Program program;
  ClientAnalyzedXML answer;
  EXPECT_TRUE(program.agent->ExecuteCommandLineXML("print s1", &answer));
  EXPECT_TRUE(answer.IsSML());
  ASSERT_NE(answer.GetArgString("message"), nullptr);
  EXPECT_EQ(answer.GetArgInt("no-such", 7), 7);
  ClientAnalyzedXML refused;
  EXPECT_FALSE(program.agent->ExecuteCommandLineXML("bogus", &refused));
  EXPECT_NE(refused.GetErrorTag(), nullptr);
}

TEST(ClientXml, TheTraceComesInPieces) {
  Program program;
  program.agent->ExecuteCommandLine("watch 1");
  std::vector<std::string> operators;
  program.agent->RegisterForXMLEvent(
      smlEVENT_XML_TRACE_OUTPUT,
      [](smlXMLEventId, void* data, Agent*, ClientXML* xml) {
        ClientXML child;
        for (int i = 0; xml->GetChild(&child, i); ++i) {
          ClientTraceXML* trace = child.ConvertToTraceXML();
          if (trace->IsTagOperator()) static_cast<std::vector<std::string>*>(data)->push_back(trace->GetOperatorName());
        }
      },
      &operators);
  program.agent->CreateFloatWME(program.agent->GetInputLink(), "distance", 10.0);
  program.agent->RunSelfTilOutput();
  EXPECT_EQ(operators, std::vector<std::string>{"forward"});
}

TEST(ClientCommands, EchoCommandsShowsEveryLineAndItsAnswerToWhoeverListens) {
  Program program;
  std::string echoed;
  program.agent->RegisterForPrintEvent(
      smlEVENT_ECHO,
      [](smlPrintEventId, void* data, Agent*, char const* text) { *static_cast<std::string*>(data) += text; }, &echoed,
      false);
  program.agent->ExecuteCommandLine("echo quiet");
  EXPECT_EQ(echoed, "");
  program.agent->ExecuteCommandLine("output echo-commands on");
  program.agent->ExecuteCommandLine("echo loud");
  EXPECT_EQ(echoed, "echo loudloud\n");
}

/// The input of a client is recorded, and replayed without the client.
TEST(ClientInput, RecordedPerceptsGiveTheSameRunAgain) {
  const std::string file = (std::filesystem::temp_directory_path() / "sml_client_percepts.txt").string();
  const auto live = [&](const std::string& command, bool with_client) {
    Program program;
    Agent* agent = program.agent;
    std::string trace;
    agent->RegisterForPrintEvent(
        smlEVENT_PRINT,
        [](smlPrintEventId, void* data, Agent*, char const* text) { *static_cast<std::string*>(data) += text; },
        &trace);
    agent->ExecuteCommandLine(command.c_str());
    EXPECT_TRUE(agent->GetLastCommandLineResult());
    agent->ExecuteCommandLine("watch 5");
    FloatElement* distance = with_client ? agent->CreateFloatWME(agent->GetInputLink(), "distance", 0) : nullptr;
    for (int cycle = 0; cycle < 12; ++cycle) {
      if (distance) agent->Update(distance, cycle % 7);
      agent->RunSelf(1);
      const int commands = with_client ? agent->GetNumberCommands() : 0;
      for (int i = 0; i < commands; ++i) agent->GetCommand(i)->AddStatusComplete();
    }
    if (with_client) agent->ExecuteCommandLine("capture-input --close");
    return trace;
  };
  const std::string recorded = live("capture-input --open " + file, true);
  EXPECT_EQ(live("replay-input --open " + file, false), recorded);
  EXPECT_NE(recorded.find("stop"), std::string::npos);
  std::filesystem::remove(file);
}

}  // namespace
