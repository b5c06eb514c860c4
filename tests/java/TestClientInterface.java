// SPDX-License-Identifier: BSD-2-Clause
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.CountDownLatch;
import sml.Agent;
import sml.ClientAnalyzedXML;
import sml.ClientTraceXML;
import sml.ClientXML;
import sml.ElementXML;
import sml.FloatElement;
import sml.Identifier;
import sml.IntElement;
import sml.Kernel;
import sml.StringElement;
import sml.WMElement;
import sml.smlAgentEventId;
import sml.smlPhase;
import sml.smlPrintEventId;
import sml.smlProductionEventId;
import sml.smlRunEventId;
import sml.smlRunState;
import sml.smlRunStepSize;
import sml.smlStringEventId;
import sml.smlSystemEventId;
import sml.smlUpdateEventId;
import sml.smlXMLEventId;
import sml.sml_Names;

/** The client interface of Soar in Java: names, elements, handlers, and both kinds of kernels. */
public class TestClientInterface {
  static final String COUNTER =
      "sp {propose*count (state <s> ^superstate nil -^stop) --> (<s> ^operator <o> + =) (<o> ^name count)}\n"
      + "sp {apply*count (state <s> ^operator.name count ^io.output-link <out>) --> (<out> ^count <c>) (<c> ^by 1)}\n";

  Kernel kernel = Kernel.CreateKernelInNewThread(Kernel.kUseAnyPort);
  Agent agent = kernel.CreateAgent("scout");

  public static void main(String[] arguments) throws Exception {
    System.exit(Check.runAll(TestClientInterface.class, TestClientInterface::new, test -> test.kernel.Shutdown()));
  }

  void load(String rules) throws IOException {
    Path file = Files.createTempFile("rules", ".soar");
    try {
      Files.write(file, rules.getBytes(StandardCharsets.UTF_8));
      Check.that(agent.LoadProductions(file.toString()), agent.GetLastErrorDescription());
    } finally {
      Files.delete(file);
    }
  }

  public void testConstantsHaveTheirNumbers() {
    Check.equal(Kernel.kDefaultSMLPort, 12121);
    Check.equal(Kernel.GetDefaultPort(), 12121);
    Check.equal(smlRunEventId.smlEVENT_AFTER_RUNNING.swigValue(), 36);
    Check.equal(smlPrintEventId.smlEVENT_PRINT.swigValue(), 47);
    Check.equal(smlRunEventId.smlRUN_EVENT_BAD.swigValue(), -1);
    Check.equal(smlRunStepSize.sml_UNTIL_OUTPUT.swigValue(), 3);
    Check.equal(smlPhase.swigToEnum(4), smlPhase.sml_OUTPUT_PHASE);
    Check.equal(sml_Names.getKSoarVersionValue(), "9.6.3");
    Check.equal(kernel.GetSoarKernelVersion(), "9.6.3");
    Check.that(sml.sml.IsPrintEventID(47) && !sml.sml.IsPrintEventID(36), "events know their family");
  }

  public void testInputIsMadeChangedAndRemoved() {
    Identifier link = agent.GetInputLink();
    Identifier place = link.CreateIdWME("place");
    IntElement x = place.CreateIntWME("x", 3000000000L);
    FloatElement y = agent.CreateFloatWME(place, "y", 2.5);
    StringElement name = place.CreateStringWME("name", "gate");
    agent.RunSelf(1);
    Check.contains(agent.ExecuteCommandLine("print p1").replace("\n", " "), "^x 3000000000 ^y 2.5");
    x.Update(4);
    agent.Update(y, 0.5);
    Check.that(name.DestroyWME(), "removed");
    agent.RunSelf(1);
    Check.equal(x.GetValue(), 4L);
    Check.equal(y.GetValue(), 0.5);
    Check.that(!agent.ExecuteCommandLine("print p1").contains("gate"), "it is gone");
  }

  public void testChildrenHaveTheClassOfTheirValue() {
    Identifier link = agent.GetInputLink();
    link.CreateIdWME("a");
    link.CreateIntWME("b", 1);
    link.CreateFloatWME("c", 1);
    link.CreateStringWME("d", "e");
    List<Class<?>> classes = new ArrayList<>();
    for (int i = 0; i < link.GetNumberChildren(); ++i) classes.add(link.GetChild(i).getClass());
    Check.equal(classes, Arrays.asList(Identifier.class, IntElement.class, FloatElement.class, StringElement.class));
    Check.equal(link.GetChild(4), null);
    Check.equal(link.FindByAttribute("z", 0), null);
    WMElement b = link.FindByAttribute("b", 0);
    Check.equal(b.ConvertToIntElement().GetValue(), 1L);
    Check.equal(b.ConvertToIdentifier(), null);
    Check.equal(link.GetParameterValue("d"), "e");
  }

  public void testTextOfAnyLanguageReturnsUnchanged() {
    String noUtf8 = "a\uDCFFb";  // The byte 0xFF.
    for (String text : new String[] {"Grüße", "水", "\uD83D\uDE00 smile", "a b", "", noUtf8}) {
      Check.equal(agent.GetInputLink().CreateStringWME("text", text).GetValue(), text);
    }
    Check.equal(agent.GetInputLink().CreateStringWME("text", "a\uD800b").GetValue(), "a\uFFFDb");
  }

  public void testCommandsAreReadAndAnswered() throws IOException {
    load(COUNTER);
    agent.RunSelfTilOutput();
    Check.that(agent.Commands(), "there are commands");
    Check.equal(agent.GetNumberCommands(), 1);
    Identifier command = agent.GetCommand(0);
    Check.equal(command.GetCommandName() + " " + command.GetParameterValue("by"), "count 1");
    command.AddStatusComplete();
    agent.RunSelf(1);
    Check.equal(command.GetParameterValue("status"), "complete");
  }

  public void testStructuredAnswersAreObjectsOfTheirOwn() {
    ClientAnalyzedXML answer = new ClientAnalyzedXML();
    Check.that(agent.ExecuteCommandLineXML("stats", answer), "it is answered");
    Check.that(answer.GetArgInt(sml_Names.getKParamStatsCycleCountDecision(), -1) >= 0, answer.GenerateXMLString(true));
    ElementXML result = answer.GetResultTag();
    answer.delete();
    Check.that(result.IsTag("result"), "the part is still there");
    String text = result.GenerateXMLString(true);
    ElementXML.DeleteString(text);
    ClientXML.DeleteString(null);
    Check.contains(text, "<result");
    ElementXML own = new ElementXML();
    Check.that(own.SetTagName("a", true), "named");
    own.addAttribute("b", "7");
    try {
      Check.equal(own.getAttributeIntThrows("b"), 7);
    } catch (Exception missing) {
      throw new AssertionError(missing);
    }
    Check.contains(Check.fails(Exception.class, () -> own.getAttributeThrows("c")), "a has no attribute c");
    Check.equal(ElementXML.ParseXMLFromString("<a"), null);
    Check.that(!ElementXML.GetLastParseErrorDescription().isEmpty(), "and it says why");
  }

  public void testEveryFamilyCallsItsHandlerWithItsArguments() throws IOException {
    Map<String, String> seen = new TreeMap<>();
    Map<String, Object> own = new TreeMap<>();
    Object data = new Object();
    ClientXML[] given = new ClientXML[1];
    ClientXML[] kept = new ClientXML[1];
    agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECISION_CYCLE, (event, mine, who, phase) -> {
      own.put("run", mine);
      seen.putIfAbsent("run", event + " " + who.GetAgentName() + " " + smlPhase.swigToEnum(phase));
    }, data);
    agent.RegisterForProductionEvent(smlProductionEventId.smlEVENT_AFTER_PRODUCTION_FIRED,
        (event, mine, who, rule, instantiation) -> {
          own.put("production", mine);
          if (rule.startsWith("propose")) seen.put("production", event + " " + rule + " " + instantiation);
        }, data);
    agent.RegisterForPrintEvent(smlPrintEventId.smlEVENT_PRINT, (event, mine, who, text) -> {
      own.put("print", mine);
      if (text.contains("(count)")) seen.put("print", event + " " + who.GetAgentName());
    }, data);
    agent.RegisterForXMLEvent(smlXMLEventId.smlEVENT_XML_TRACE_OUTPUT, (event, mine, who, xml) -> {
      own.put("xml", mine);
      given[0] = xml;
      kept[0] = new ClientXML(xml);
      seen.put("xml", event + " " + xml.GetTagName());
    }, data);
    agent.RegisterForOutputNotification((mine, who) -> {
      own.put("notification", mine);
      seen.put("notification", who.GetAgentName() + " " + who.GetNumberCommands());
    }, data);
    agent.AddOutputHandler("count", (mine, who, attribute, element) -> {
      own.put("output", mine);
      seen.put("output", who + " " + attribute + " " + element.ConvertToIdentifier().GetParameterValue("by"));
    }, data);
    kernel.RegisterForSystemEvent(smlSystemEventId.smlEVENT_SYSTEM_START, (event, mine, which) -> {
      own.put("system", mine);
      seen.put("system", event + " " + which.GetNumberAgents());
    }, data);
    kernel.RegisterForUpdateEvent(smlUpdateEventId.smlEVENT_AFTER_ALL_OUTPUT_PHASES, (event, mine, which, flags) -> {
      own.put("update", mine);
      seen.put("update", event + " " + flags);
    }, data);
    kernel.RegisterForAgentEvent(smlAgentEventId.smlEVENT_AFTER_AGENT_CREATED, (event, mine, who) -> {
      own.put("agent", mine);
      seen.put("agent", event + " " + who + " " + kernel.GetAgent(who).GetAgentName());
    }, data);
    kernel.RegisterForClientMessageEvent("me", (event, mine, who, client, message) -> {
      own.put("message", mine);
      seen.put("message", event + " " + who + " " + client + " " + message);
      return "an answer";
    }, data);
    kernel.AddRhsFunction("ask", (event, mine, who, function, argument) -> {
      own.put("function", mine);
      seen.put("function", event + " " + who + " " + function + " " + argument);
      return "7";
    }, data);
    load(COUNTER + "sp {ask (state <s> ^superstate nil) --> (<s> ^answer (exec ask |a b| 3))}");
    kernel.RunAllAgents(2);
    kernel.CreateAgent("second");
    Check.equal(kernel.SendClientMessage(agent, "me", "how are you?"), "an answer");

    Map<String, String> expected = new TreeMap<>();
    expected.put("agent", "41 second second");
    expected.put("function", "48 scout ask a b3");
    expected.put("message", "50 scout me how are you?");
    expected.put("notification", "scout 1");
    expected.put("output", "scout count 1");
    expected.put("print", "47 scout");
    expected.put("production", "39 propose*count null");
    expected.put("run", "29 scout sml_OUTPUT_PHASE");
    expected.put("system", "3 1");
    expected.put("update", "53 2");
    expected.put("xml", "51 trace");
    Check.equal(seen, expected);
    own.forEach((family, mine) -> Check.that(mine == data, family + " gets its data"));
    Check.that(kept[0].ConvertToTraceXML() instanceof ClientTraceXML, "a copy of XML may be kept");
    Check.fails(IllegalStateException.class, () -> given[0].GetTagName());
    Check.contains(agent.ExecuteCommandLine("print s1"), "^answer |7|");
  }

  public void testStringEventsAreAnswered() {
    List<String> heard = new ArrayList<>();
    long id = kernel.RegisterForStringEvent(smlStringEventId.smlEVENT_TCL_LIBRARY_MESSAGE, (event, data, which, text) -> {
      heard.add(event + " " + text);
      return "done";
    }, null);
    Check.that(id > 0, "registered");
    Check.that(kernel.UnregisterForStringEvent(id), "unregistered");
    Check.that(!kernel.UnregisterForStringEvent(id), "once only");
  }

  public void testWhatIsUnregisteredIsNotCalled() {
    int[] calls = {0};
    long id = agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE, (event, data, who, phase) -> ++calls[0],
        null);
    agent.RunSelf(2);
    Check.equal(calls[0], 2);
    Check.that(agent.UnregisterForRunEvent(id), "unregistered");
    Check.that(!agent.UnregisterForRunEvent(id) && !agent.UnregisterForRunEvent(1L << 40), "once only");
    agent.RunSelf(2);
    Check.equal(calls[0], 2);
  }

  public void testAHandlerIsGivenTheSameAgentUntilThatIsDeleted() {
    List<Agent> seen = new ArrayList<>();
    agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE, (event, data, who, phase) -> seen.add(who), null);
    agent.RunSelf(2);
    Check.that(seen.get(0) == seen.get(1), "the same");
    seen.get(0).delete();
    agent.RunSelf(1);
    Check.equal(seen.get(2).GetAgentName(), "scout");
  }

  public void testWhatAHandlerIsGivenStaysReachable() throws Exception {
    for (int i = 0; i < 200; ++i) {
      String name = "phrase" + i;
      kernel.AddRhsFunction(name, (event, data, who, function, argument) -> data + argument, "number " + i);
    }
    System.gc();
    load("sp {ask (state <s> ^superstate nil) --> (<s> ^answer (exec phrase123 |!|))}");
    agent.RunSelf(1);
    Check.contains(agent.ExecuteCommandLine("print s1"), "|number 123!|");
  }

  public void testStopsFromAnotherThreadEndARun() throws Exception {
    CountDownLatch runs = new CountDownLatch(1);
    agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE, (event, data, who, phase) -> runs.countDown(), null);
    load(COUNTER);
    Thread runner = new Thread(() -> kernel.RunAllAgentsForever());
    runner.start();
    runs.await();
    kernel.StopAllAgents();
    runner.join();
    Check.equal(agent.GetRunState(), smlRunState.sml_RUNSTATE_INTERRUPTED);
    Check.that(agent.GetDecisionCycleCounter() >= 1, "it ran");
  }

  public void testAClientOfAnotherKernelSeesTheSame() throws IOException {
    Kernel remote = Kernel.CreateRemoteConnection(true, null, kernel.GetListenerPort());
    Check.that(!remote.HadError(), remote.GetLastErrorDescription());
    Check.that(remote.IsRemoteConnection() && !kernel.IsRemoteConnection(), "it is remote");
    Agent far = remote.GetAgent("scout");
    CountDownLatch printed = new CountDownLatch(1);
    far.RegisterForPrintEvent(smlPrintEventId.smlEVENT_PRINT, (event, data, who, text) -> printed.countDown(), null);
    load(COUNTER);
    Check.contains(far.ExecuteCommandLine("print apply*count"), "apply*count");
    far.RunSelf(2);
    Check.that(far.Commands(), "output arrives");
    Check.equal(far.GetCommand(0).GetParameterValue("by"), "1");
    Check.equal(printed.getCount(), 0L);
    remote.Shutdown();
    remote.delete();
    Check.that(kernel.GetAgent("scout").GetDecisionCycleCounter() >= 2, "the kernel goes on");
  }

  /** If a remote client runs an agent, a thread of the kernel calls the Java handlers. */
  public void testHandlersAreCalledOnThreadsOfTheLibrary() throws Exception {
    List<String> threads = new ArrayList<>();
    String here = Thread.currentThread().getName();
    for (int i = 0; i < 3; ++i) {
      Kernel own = Kernel.CreateKernelInNewThread(Kernel.kUseAnyPort);
      Agent runner = own.CreateAgent("runner");
      runner.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE,
          (event, data, who, phase) -> threads.add(Thread.currentThread().getName()), null);
      Kernel remote = Kernel.CreateRemoteConnection(true, null, own.GetListenerPort());
      remote.GetAgent("runner").RunSelf(1);
      remote.Shutdown();
      own.Shutdown();
      own.delete();
    }
    Check.equal(threads.size(), 3);
    Check.that(!threads.contains(here), "other threads than " + here + ": " + threads);
  }
}
