// SPDX-License-Identifier: BSD-2-Clause
import type { Check, Mission } from "../run/contents";

/** Whether a check is about this agent, by the words before "should": a name, a pattern with *, or several of them. */
function isAbout(check: Check, agent: string): boolean {
  const words = (check.agent !== "" ? check.agent : check.expected.split(" should ")[0]!).split(/[,\s]+/);
  return words.some((one) => one !== "" && new RegExp(`^${one.replace(/[.+?^${}()|[\]\\]/g, "\\$&").replaceAll("*", ".*")}$`).test(agent));
}

/** The protagonist: the agent with the most checks, or the first of several. */
export function protagonist(mission: Mission, agents: readonly string[]): string {
  const about = agents.map((agent) => ({ agent, count: mission.checks.filter((one) => isAbout(one, agent)).length, first: mission.checks.findIndex((one) => isAbout(one, agent)) }));
  return about.filter((one) => one.count > 0).sort((a, b) => b.count - a.count || a.first - b.first)[0]?.agent ?? agents[0] ?? "";
}
