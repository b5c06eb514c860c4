// SPDX-License-Identifier: BSD-2-Clause
import sml.Agent;
import sml.Kernel;
import sml.smlRunEventId;

/** Ends the program where it is hardest: in a handler, during a run, with a kernel that nobody shuts down. */
public class EndsInAHandler {
  public static void main(String[] arguments) {
    Kernel kernel = Kernel.CreateKernelInNewThread(Kernel.kUseAnyPort);
    Agent agent = kernel.CreateAgent("scout");
    agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE, (event, data, who, phase) -> System.exit(7), null);
    agent.RunSelfForever();
    System.exit(1);
  }
}
