// SPDX-License-Identifier: BSD-2-Clause
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import sml.Agent;
import sml.ClientAnalyzedXML;
import sml.ClientXML;
import sml.ElementXML;
import sml.Identifier;
import sml.IdentifierSymbol;
import sml.IntElement;
import sml.Kernel;
import sml.StringElement;
import sml.WMElement;
import sml.smlAgentEventId;
import sml.smlPrintEventId;
import sml.smlRunEventId;
import sml.smlSystemEventId;

/** Each mistake of a program results in an exception or an error of the library. The virtual machine continues. */
public class TestMistakes {
  Kernel kernel = Kernel.CreateKernelInNewThread(Kernel.kSuppressListener);
  Agent agent = kernel.CreateAgent("scout");

  public static void main(String[] arguments) throws Exception {
    System.exit(Check.runAll(TestMistakes.class, TestMistakes::new, test -> {
      try {
        test.kernel.Shutdown();
      } catch (IllegalStateException deleted) {
        // The test has deleted its kernel.
      }
    }));
  }

  /** The text that the action prints on standard error. */
  static String errorsOf(Check.Action action) throws Exception {
    PrintStream before = System.err;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    System.setErr(new PrintStream(bytes, true, "UTF-8"));
    try {
      action.run();
    } finally {
      System.setErr(before);
    }
    return bytes.toString("UTF-8");
  }

  public void testAnElementOfADestroyedAgentFails() {
    Identifier link = agent.GetInputLink();
    IntElement x = link.CreateIntWME("x", 1);
    IdentifierSymbol symbol = x.GetParent();
    Check.that(kernel.DestroyAgent(agent), "destroyed");
    Check.contains(Check.fails(IllegalStateException.class, () -> agent.RunSelf(1)), "This agent has been destroyed");
    Check.contains(Check.fails(IllegalStateException.class, () -> x.Update(2)), "its agent has been destroyed");
    Check.fails(IllegalStateException.class, () -> link.GetChild(0));
    Check.fails(IllegalStateException.class, () -> symbol.GetIdentifierSymbol());
    Check.fails(IllegalStateException.class, () -> kernel.DestroyAgent(agent));
    Check.that(!kernel.IsAgentValid(agent), "not valid");
    Agent next = kernel.CreateAgent("scout");
    Check.that(next.GetInputLink().GetNumberChildren() == 0, "the next one of that name is another");
    Check.fails(IllegalStateException.class, () -> next.CreateIntWME(link, "x", 1));
  }

  public void testAnElementThatWasRemovedFails() {
    Identifier place = agent.GetInputLink().CreateIdWME("place");
    StringElement name = place.CreateStringWME("name", "gate");
    Check.that(place.DestroyWME(), "removed");
    Check.contains(Check.fails(IllegalStateException.class, () -> name.GetValue()), "was destroyed");
    Check.fails(IllegalStateException.class, () -> agent.DestroyWME(place));
  }

  public void testADeletedObjectFails() {
    ClientXML xml = new ClientXML();
    xml.delete();
    xml.delete();
    Check.contains(Check.fails(IllegalStateException.class, () -> xml.GetTagName()), "ClientXML.GetTagName: an object was deleted");
    Agent again = kernel.GetAgent("scout");
    again.delete();
    Check.fails(IllegalStateException.class, () -> again.GetAgentName());
    Check.equal(agent.GetAgentName(), "scout");
    kernel.delete();
    Check.fails(IllegalStateException.class, () -> kernel.GetNumberAgents());
    Check.contains(Check.fails(IllegalStateException.class, () -> agent.GetAgentName()), "kernel of this object has been deleted");
  }

  public void testAfterShutdownCallsFailWithoutHarm() {
    kernel.Shutdown();
    kernel.Shutdown();
    Check.equal(kernel.CreateAgent("b"), null);
    Check.that(kernel.HadError(), "an error");
    Check.fails(IllegalStateException.class, () -> agent.RunSelf(1));
  }

  public void testNullIsAnException() {
    Identifier link = agent.GetInputLink();
    Check.contains(Check.fails(NullPointerException.class, () -> link.CreateStringWME(null, "b")), "Identifier.CreateStringWME");
    Check.fails(NullPointerException.class, () -> link.CreateStringWME("a", null));
    Check.fails(NullPointerException.class, () -> link.CreateSharedIdWME("a", null));
    Check.fails(NullPointerException.class, () -> agent.CreateIntWME(null, "a", 1));
    Check.fails(NullPointerException.class, () -> agent.Update((IntElement) null, 1));
    Check.fails(NullPointerException.class, () -> agent.ExecuteCommandLine(null));
    Check.fails(NullPointerException.class, () -> agent.ExecuteCommandLineXML("stats", null));
    Check.fails(NullPointerException.class, () -> agent.RunSelf(1, null));
    Check.fails(NullPointerException.class, () -> agent.LoadProductions(null));
    Check.fails(NullPointerException.class, () -> kernel.CreateAgent(null));
    Check.fails(NullPointerException.class, () -> kernel.GetAgent(null));
    Check.fails(NullPointerException.class, () -> kernel.DestroyAgent(null));
    Check.fails(NullPointerException.class, () -> new ClientXML(null));
    Check.contains(Check.fails(NullPointerException.class,
        () -> agent.RegisterForRunEvent(smlRunEventId.smlEVENT_BEFORE_INPUT_PHASE, null, this)), "the handler of a run event is null");
    Check.contains(Check.fails(NullPointerException.class,
        () -> kernel.RegisterForSystemEvent(null, (event, data, which) -> {}, this)), "the event is null");
    // If a parameter is optional, null is valid.
    Check.contains(kernel.ExecuteCommandLine("version", null), "9.6.5");
  }

  public void testTextWithTheCharacterZeroIsAnException() {
    Check.contains(Check.fails(IllegalArgumentException.class, () -> agent.GetInputLink().CreateStringWME("a", "b\0c")),
        "contains the character 0");
  }

  public void testEventsOfNoFamilyAreRefused() {
    Check.contains(Check.fails(IllegalArgumentException.class,
        () -> agent.RegisterForRunEvent(smlRunEventId.smlRUN_EVENT_BAD, (event, data, who, phase) -> {}, null)),
        "-1 is not a number of a run event");
  }

  public void testAnAgentOfAnotherKernelIsRefused() {
    Kernel other = Kernel.CreateKernelInCurrentThread(true, Kernel.kSuppressListener);
    Agent stranger = other.CreateAgent("stranger");
    Check.contains(Check.fails(IllegalArgumentException.class, () -> kernel.DestroyAgent(stranger)), "another kernel");
    Check.that(!kernel.IsAgentValid(stranger), "not valid here");
    other.Shutdown();
  }

  public void testAnExceptionInAHandlerIsToldAndTheRunGoesOn() throws Exception {
    agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE, (event, data, who, phase) -> {
      throw new IllegalArgumentException("not today");
    }, null);
    kernel.AddRhsFunction("deep", (event, data, who, function, argument) -> {
      throw new StackOverflowError("deep");
    }, null);
    agent.ExecuteCommandLine("sp {a (state <s> ^superstate nil) --> (<s> ^b (exec deep)) (<s> ^c d)}");
    String errors = errorsOf(() -> agent.RunSelf(3));
    Check.contains(errors, "Exception in the handler of a run event:\njava.lang.IllegalArgumentException: not today");
    Check.contains(errors, "Exception in the handler of a right-hand-side function:\njava.lang.StackOverflowError");
    Check.equal(agent.GetDecisionCycleCounter(), 3);
    Check.contains(agent.ExecuteCommandLine("print s1"), "^c d");
  }

  public void testHandlersThatCallThemselvesEnd() throws Exception {
    AtomicInteger calls = new AtomicInteger();
    agent.RegisterForPrintEvent(smlPrintEventId.smlEVENT_PRINT, (event, data, who, text) -> {
      calls.incrementAndGet();
      who.ExecuteCommandLine("echo again", true);
    }, null, false);
    kernel.RegisterForClientMessageEvent("me", (event, data, who, client, message) -> {
      calls.incrementAndGet();
      return kernel.SendClientMessage(agent, "me", message);
    }, null);
    String errors = errorsOf(() -> kernel.SendClientMessage(agent, "me", "hello"));
    Check.contains(errors, "handlers have called the library");
    Check.that(calls.get() > 1 && calls.get() < 100, calls + " calls");
  }

  public void testAHandlerMayDestroyItsAgentOrItself() throws Exception {
    AtomicReference<Long> id = new AtomicReference<>();
    id.set(agent.RegisterForRunEvent(smlRunEventId.smlEVENT_BEFORE_DECISION_CYCLE,
        (event, data, who, phase) -> who.UnregisterForRunEvent(id.get()), null));
    agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE,
        (event, data, who, phase) -> kernel.DestroyAgent(who), null);
    agent.RunSelf(3);
    Check.that(!kernel.IsAgentValid(agent), "destroyed");
    Check.equal(kernel.GetNumberAgents(), 0);
  }

  public void testANumberThatNobodyGaveIsNoticed() throws Exception {
    Constructor<?> constructor = Agent.class.getDeclaredConstructor(long.class, boolean.class);
    constructor.setAccessible(true);
    for (long number : new long[] {1, 8, 999, -1, Long.MAX_VALUE, Long.MIN_VALUE}) {
      Agent forged = (Agent) constructor.newInstance(number, true);
      if (number == 8) continue;  // It may be a real one.
      Check.fails(IllegalStateException.class, () -> forged.GetAgentName());
      Check.fails(IllegalStateException.class, () -> forged.RunSelf(1));
    }
    // The number of an object of another class.
    ElementXML xml = new ElementXML();
    java.lang.reflect.Field field = ElementXML.class.getDeclaredField("swigCPtr");
    field.setAccessible(true);
    Agent forged = (Agent) constructor.newInstance(field.getLong(xml), true);
    Check.contains(Check.fails(IllegalArgumentException.class, () -> forged.GetAgentName()), "of another class");
  }

  /** Calls each public method with null, with the smallest and largest numbers, and with removed and deleted objects. */
  public void testEveryMethodTakesAnything() throws Exception {
    Identifier dead = agent.GetInputLink().CreateIdWME("dead");
    dead.DestroyWME();
    IntElement number = agent.GetInputLink().CreateIntWME("n", 1);
    ClientXML deleted = new ClientXML();
    deleted.delete();
    Object[] targets = {agent, agent.GetInputLink(), dead, number, deleted, new ClientAnalyzedXML(), new ElementXML(),
                        number.GetParent(), kernel, new sml.Events(), new sml.ClientTraceXML()};
    Random random = new Random(7);
    int called = 0;
    for (int round = 0; round < 12; ++round) {
      for (Object target : targets) {
        for (Method method : target.getClass().getMethods()) {
          if (!method.getDeclaringClass().getName().startsWith("sml.") || takesLong(method)) continue;
          Object[] arguments = new Object[method.getParameterCount()];
          for (int i = 0; i < arguments.length; ++i) arguments[i] = any(method.getParameterTypes()[i], random, targets);
          try {
            method.invoke(target, arguments);
          } catch (InvocationTargetException problem) {
            Throwable cause = problem.getCause();
            Check.that(cause instanceof RuntimeException || cause instanceof Exception, method + ": " + cause);
          } catch (IllegalArgumentException wrongType) {
            // Java itself rejects an argument of another type.
          }
          ++called;
        }
      }
    }
    Check.that(called > 1000, called + " calls");
    Agent alive = kernel.CreateAgent("alive");
    alive.RunSelf(1);
    Check.equal(alive.GetDecisionCycleCounter(), 1);
  }

  /** Whether a method ends the kernel, takes long, starts programs or waits. */
  private static boolean takesLong(Method method) {
    String name = method.getName();
    return name.startsWith("Shutdown") || name.startsWith("Run") || name.contains("Forever") || name.startsWith("Create")
        && Modifier.isStatic(method.getModifiers()) || name.contains("Debugger") || name.equals("delete")
        || name.equals("LoadExternalLibrary") || name.startsWith("SetTrace");
  }

  private static Object any(Class<?> type, Random random, Object[] targets) {
    if (type == int.class) return new int[] {0, -1, 1, Integer.MAX_VALUE, Integer.MIN_VALUE}[random.nextInt(5)];
    if (type == long.class) return new long[] {0, -1, 1, Long.MAX_VALUE, Long.MIN_VALUE}[random.nextInt(5)];
    if (type == double.class) return new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}[random.nextInt(4)];
    if (type == boolean.class) return random.nextBoolean();
    if (random.nextInt(3) == 0) return null;
    if (type == String.class) return new String[] {"", "a", "\0", "\uD800", "<", "{", "print", "x".repeat(9999)}[random.nextInt(8)];
    if (type.isEnum()) return type.getEnumConstants()[random.nextInt(type.getEnumConstants().length)];
    return random.nextInt(4) == 0 ? "no such type" : targets[random.nextInt(targets.length)];
  }

  /** Threads that use, remove and delete the same objects. */
  public void testSeveralThreadsUseTheSameObjects() throws Exception {
    AtomicReference<Throwable> bad = new AtomicReference<>();
    AtomicReference<Identifier> shared = new AtomicReference<>(agent.GetInputLink().CreateIdWME("shared"));
    ClientAnalyzedXML answer = new ClientAnalyzedXML();
    List<Thread> threads = new ArrayList<>();
    for (int i = 0; i < 6; ++i) {
      int which = i;
      Thread thread = new Thread(() -> {
        Random random = new Random(which);
        for (int round = 0; round < 300; ++round) {
          try {
            Identifier place = shared.get();
            switch (random.nextInt(8)) {
              case 0: place.CreateIntWME("n", round); break;
              case 1: WMElement child = place.GetChild(random.nextInt(4)); if (child != null) child.DestroyWME(); break;
              case 2: shared.set(agent.GetInputLink().CreateIdWME("shared")); place.DestroyWME(); break;
              case 3: agent.RunSelf(1); break;
              case 4: agent.ExecuteCommandLineXML("stats", answer); break;
              case 5: if (answer.GetResultTag() != null) answer.GetResultTag().GenerateXMLString(true); break;
              case 6: place.delete(); shared.compareAndSet(place, agent.GetInputLink().CreateIdWME("shared")); break;
              default: place.GetParameterValue("n"); break;
            }
          } catch (IllegalStateException gone) {
            // Another thread was faster.
          } catch (Throwable other) {
            bad.compareAndSet(null, other);
          }
        }
      });
      threads.add(thread);
      thread.start();
    }
    for (Thread thread : threads) thread.join();
    if (bad.get() != null) throw new AssertionError(bad.get());
    // This thread deletes the kernel while others use it.
    threads.clear();
    for (int i = 0; i < 4; ++i) {
      Thread thread = new Thread(() -> {
        try {
          while (true) agent.RunSelf(1);
        } catch (IllegalStateException gone) {
          // The kernel was deleted, so this thread ends.
        } catch (Throwable other) {
          bad.compareAndSet(null, other);
        }
      });
      threads.add(thread);
      thread.start();
    }
    kernel.delete();
    for (Thread thread : threads) thread.join();
    if (bad.get() != null) throw new AssertionError(bad.get());
  }

  /** Agents are created and destroyed while their handlers are called and the garbage collector runs. */
  public void testAgentsComeAndGo() {
    AtomicInteger seen = new AtomicInteger();
    kernel.RegisterForAgentEvent(smlAgentEventId.smlEVENT_BEFORE_AGENT_DESTROYED,
        (event, data, name) -> seen.incrementAndGet(), null);
    for (int i = 0; i < 50; ++i) {
      Agent each = kernel.CreateAgent("agent" + i);
      each.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE,
          (event, data, who, phase) -> who.GetInputLink().CreateIntWME("n", phase), new byte[100000]);
      each.RunSelf(2);
      kernel.DestroyAgent(each);
      if (i % 10 == 0) System.gc();
    }
    Check.equal(seen.get(), 50);
  }
}
