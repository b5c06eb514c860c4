// SPDX-License-Identifier: BSD-2-Clause
// Written by reference_pages from src/workbench/panel_id.h.

/** Word, title and description of a panel. */
export interface PanelInfo {
  readonly word: string;
  readonly title: string;
  readonly about: string;
  readonly hasDocument: boolean;
}

export const PANELS: readonly PanelInfo[] = [
  {
    word: "agents", title: "Agents",
    about: "All agents of the world: team, state, operator, command. Click to select.",
    hasDocument: true,
  },
  {
    word: "mind", title: "Mind",
    about: "The goal stack, the operators that compete in it, and why one of them was selected.",
    hasDocument: true,
  },
  {
    word: "memory", title: "Memory",
    about: "Working memory as a tree; changes are marked.",
    hasDocument: true,
  },
  {
    word: "rules", title: "Rules",
    about: "The rules with how often they fired, what they match now, or where they fail.",
    hasDocument: true,
  },
  {
    word: "why", title: "Why",
    about: "Why the agent does what it does, and why it does not do something else.",
    hasDocument: true,
  },
  {
    word: "links", title: "Senses",
    about: "What the agent perceives (input link) and which commands it gives (output link).",
    hasDocument: true,
  },
  {
    word: "messages", title: "Messages",
    about: "What agents said to each other.",
    hasDocument: true,
  },
  {
    word: "timeline", title: "Timeline",
    about: "Operators, impasses, commands and events over time. Click to go there.",
    hasDocument: false,
  },
  {
    word: "trace", title: "Trace",
    about: "What the mind did, decision by decision; filter and search it.",
    hasDocument: true,
  },
  {
    word: "plots", title: "Plots",
    about: "Numbers over time: percepts, reward, decision time, rules fired.",
    hasDocument: true,
  },
  {
    word: "console", title: "Console",
    about: "The Soar command line of the selected agent.",
    hasDocument: true,
  },
  {
    word: "edit", title: "Edit",
    about: "Change rules and reload them while the world runs.",
    hasDocument: false,
  },
  {
    word: "breakpoints", title: "Breakpoints",
    about: "Stop the world when a rule fires, an impasse occurs, ...",
    hasDocument: true,
  },
  {
    word: "futures", title: "Futures",
    about: "After going back: the old future next to the new one, and where they differ.",
    hasDocument: true,
  },
  {
    word: "problems", title: "Problems",
    about: "Errors and warnings in full, with file and line.",
    hasDocument: true,
  },
  {
    word: "watch", title: "Watch",
    about: "Values and Soar commands that you want to see at each decision, for several agents side by side.",
    hasDocument: true,
  },
  {
    word: "minds", title: "Minds",
    about: "Several minds side by side: goal stack, operators, commands.",
    hasDocument: true,
  },
  {
    word: "mission", title: "Mission",
    about: "What agents are to do: checks that tick off as they come true. Lessons.",
    hasDocument: true,
  },
  {
    word: "longterm", title: "Long-term memory",
    about: "What the agent knows and remembers, what it recalled and why; an episode as ghosts in the scene.",
    hasDocument: true,
  },
  {
    word: "learning", title: "Learning",
    about: "Rules that the agent learned, with their reasons; values learned from reward, as numbers and curves.",
    hasDocument: true,
  },
  {
    word: "exercise", title: "Exercise",
    about: "The exercise (DIS) that the run shares with other simulations: their entities, sent and received PDUs, dropped PDUs.",
    hasDocument: true,
  },
  {
    word: "imagery", title: "Imagery",
    about: "What the agent imagines: the scene of each state, what its rules ask of it, the answers, and why they are so.",
    hasDocument: true,
  },
  {
    word: "script", title: "Script",
    about: "Stop Lua scripts at a line, and step through them: calls, variables, values that you watch.",
    hasDocument: true,
  },
];

/** The initial positions of panels. The page adds its own panel for the output of agents. */
export const ARRANGEMENTS = {
  world: {
    left: ["agents", "mission", "problems"],
    right: ["mind", "why", "memory", "rules", "links", "edit", "breakpoints", "futures"],
    bottom: ["timeline", "output", "trace", "console", "plots", "messages", "watch", "minds", "longterm",
      "learning", "imagery", "script"],
  },
  lesson: {
    left: ["mission", "agents"],
    right: ["edit"],
    bottom: ["why", "mind", "output", "memory", "rules", "links", "timeline", "trace", "messages",
      "problems", "console", "watch", "plots", "learning", "longterm", "imagery", "breakpoints",
      "minds", "futures", "script"],
  },
  report: {
    left: ["agents", "mission"],
    right: ["mind", "why"],
    bottom: ["timeline", "output", "messages", "trace", "imagery"],
  },
} as const;

/** The texts of empty panels that no document describes. */
export const EMPTY = {
  timeline: "Nothing has happened yet. Let the world run: operators, commands and events appear here.",
  edit: "No file is open. Choose one above, or press Edit at a rule.",
} as const;
