// SPDX-License-Identifier: BSD-2-Clause
package sml;

/** What the library calls when something happens. An exception goes no further: it is printed, and the run goes on. */
final class Handler {
  /** What the library says. */
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

    /** Lives until the handler returns: traces are large, and come often. */
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
  /** For whom it is called: the same each time. */
  private Agent agent;
  private Kernel kernel;

  /**
   * @param what What it handles, for messages.
   * @param handler What the program registers: not null.
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

  /** Called by the library instead of run where handlers have called handlers too often. */
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
