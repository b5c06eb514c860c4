// SPDX-License-Identifier: BSD-2-Clause
// Written by reference_pages from src/workbench/flow_info.h.

/** What a command of the run is called, in the window and here. */
export const FLOWS = {
  "step-tick": {
    button: "Tick", title: "Step a tick",
    meaning: "Let the world advance by one tick: agents perceive, decide and act, and bodies move",
  },
  "step-decision": {
    button: "Decision", title: "Step a decision",
    meaning: "The selected agent perceives what is new and makes one decision; the world advances by one tick",
  },
  "step-phase": {
    button: "Phase", title: "Step a phase",
    meaning: "The selected agent alone does one phase of its decision cycle; the world stays paused",
  },
  "step-change": {
    button: "Change", title: "Step to the next change",
    meaning: "The world continues until the selected agent selects another operator, meets or leaves an impasse, or gives a command",
  },
  "faster": {
    button: "+", title: "Faster",
    meaning: "The next speed up to 16 times real time",
  },
  "slower": {
    button: "−", title: "Slower",
    meaning: "The next speed down to a tenth of real time",
  },
  "normal-speed": {
    button: "1×", title: "Normal speed",
    meaning: "Real time",
  },
  "unlimited": {
    button: "Max", title: "As fast as it goes",
    meaning: "No limit but the machine's; again: the speed before",
  },
  "begin-again": {
    button: "Begin again", title: "Begin again",
    meaning: "The run begins again with the same seed",
  },
  "next-seed": {
    button: "Next seed", title: "Begin again with the next seed",
    meaning: "The run begins again, with other random numbers",
  },
  "step-turn": {
    button: "Turn", title: "Step a turn",
    meaning: "Let the world advance by one tick, or a game by one turn: agents perceive, decide and act, and bodies move",
  },
} as const;

/** The button that continues a run from the moment that is shown. */
export const RESUME = "Resume here";
/** A return to the present. */
export const LIVE = "Back to the newest moment";
