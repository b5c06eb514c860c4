// SPDX-License-Identifier: BSD-2-Clause
package sml;

/** A handler that the library calls. Exceptions are printed and not passed on; the run continues. */
final class Handler {
  /** The arguments of one call of a handler. Which of them are set depends on the event. */
  static final class Told {
    final int event;
    private final long object;
    private final long other;
    final String agentName;
    final String first;
    final String second;
    final int number;
    private final Handler handler;
    private ClientXML xml;

    private Told(Handler handler, int event, long object, long other, String agentName, String first, String second, int number) {
      this.handler = handler;
      this.event = event;
      this.object = object;
      this.other = other;
      this.agentName = agentName;
      this.first = first;
      this.second = second;
      this.number = number;
    }

    Agent agent() {
      return handler.agentOf(object);
    }

    Kernel kernel() {
      return handler.kernelOf(object);
    }

    WMElement element() {
      return Handles.element(other);
    }

    /** Valid until the handler returns, because traces are large and frequent. */
    ClientXML xml() {
      xml = new ClientXML(other, true);
      return xml;
    }

    private void end() {
      if (xml != null) xml.delete();
    }
  }

  interface Task {
    /** Returns the answer; null for the empty text. */
    String run(Told told);
  }

  private final String what;
  private final Task task;
  /** The kernel or agent that it is called for: always the same. */
  private Agent agent;
  private Kernel kernel;

  /**
   * @param what The name of the event, for messages.
   * @param handler The program's handler; not null.
   */
  Handler(String what, Object handler, Task task) {
    if (handler == null) throw new NullPointerException("the handler of " + what + " is null");
    this.what = what;
    this.task = task;
  }

  private synchronized Agent agentOf(long number) {
    if (agent == null || agent.swigCPtr != number) agent = new Agent(number, true);
    return agent;
  }

  private synchronized Kernel kernelOf(long number) {
    if (kernel == null || kernel.swigCPtr != number) kernel = new Kernel(number, true);
    return kernel;
  }

  static <T> T event(T id) {
    if (id == null) throw new NullPointerException("the event is null");
    return id;
  }

  /** Called by the library. */
  static String run(Handler handler, int event, long object, long other, String agentName, String first,
                    String second, int number) {
    Told told = new Told(handler, event, object, other, agentName, first, second, number);
    try {
      return handler.task.run(told);
    } catch (Throwable problem) {
      handler.report(problem);
      return null;
    } finally {
      told.end();
    }
  }

  /** Called by the library instead of run if handlers are nested too deeply. */
  static void tooDeep(Handler handler, int depth) {
    handler.report(new IllegalStateException(
        "not called: " + depth + " handlers have called the library, and so each other, already"));
  }

  private void report(Throwable problem) {
    synchronized (System.err) {
      System.err.println("Exception in the handler of " + what + ":");
      problem.printStackTrace();
    }
  }
}
