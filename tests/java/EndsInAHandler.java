// SPDX-License-Identifier: BSD-2-Clause
import sml.Agent;
import sml.Kernel;
import sml.smlRunEventId;

/** Ends the program in the most difficult situation: in a handler, during a run, without shutting the kernel down. */
public class EndsInAHandler {
  public static void main(String[] arguments) {
    Kernel kernel = Kernel.CreateKernelInNewThread(Kernel.kUseAnyPort);
    Agent agent = kernel.CreateAgent("scout");
    agent.RegisterForRunEvent(smlRunEventId.smlEVENT_AFTER_DECIDE_PHASE, (event, data, who, phase) -> System.exit(7), null);
    agent.RunSelfForever();
    System.exit(1);
  }
}
