// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "workbench/flow.h"

namespace soarbox::workbench {

/// What a command of the run is called: in requests, in the window and on pages.
struct FlowInfo {
  Flow flow;
  std::string_view word;     ///< In requests: "begin-again".
  std::string_view button;   ///< "Begin again"
  std::string_view title;    ///< In menus and lists of keys: "Begin again with the next seed".
  std::string_view meaning;  ///< A sentence without its full stop.
};

/// One line for each command, in the order of Flow.
inline constexpr auto kFlowInfos = std::to_array<FlowInfo>({
    {Flow::kTogglePause, "toggle-pause", "Pause", "Pause", "Pause the world, or let it continue"},
    {Flow::kStepTick, "step-tick", "Tick", "Step a tick",
     "Let the world advance by one tick: agents perceive, decide and act, and bodies move"},
    {Flow::kStepDecision, "step-decision", "Decision", "Step a decision",
     "The selected agent perceives what is new and makes one decision; the world advances by one tick"},
    {Flow::kStepPhase, "step-phase", "Phase", "Step a phase",
     "The selected agent alone does one phase of its decision cycle; the world stays paused"},
    {Flow::kStepChange, "step-change", "Change", "Step to the next change",
     "The world continues until the selected agent selects another operator, meets or leaves an impasse, or gives a "
     "command"},
    {Flow::kFaster, "faster", "+", "Faster", "The next speed up to 16 times real time"},
    {Flow::kSlower, "slower", "\xe2\x88\x92", "Slower", "The next speed down to a tenth of real time"},
    {Flow::kNormalSpeed, "normal-speed", "1\xc3\x97", "Normal speed", "Real time"},
    {Flow::kUnlimited, "unlimited", "Max", "As fast as it goes", "No limit but the machine's; again: the speed before"},
    {Flow::kReset, "begin-again", "Begin again", "Begin again", "The run begins again with the same seed"},
    {Flow::kNextSeed, "next-seed", "Next seed", "Begin again with the next seed",
     "The run begins again, with other random numbers"},
    {Flow::kQuit, "quit", "Quit", "Quit", "Close the window; so does Esc, pressed twice"},
    {Flow::kStepTurn, "step-turn", "Turn", "Step a turn",
     "Let the world advance by one tick, or a game by one turn: agents perceive, decide and act, and bodies move"},
});

inline constexpr const FlowInfo& InfoOf(Flow flow) {
  return kFlowInfos[static_cast<std::size_t>(flow)];
}

/// Whether a page can request this command. A page requests "pause" and "go-on" instead of kTogglePause, and cannot
/// quit.
inline constexpr bool IsRequest(Flow flow) {
  return flow != Flow::kTogglePause && flow != Flow::kQuit;
}

/// The command with this word that a page can request; null if there is none.
inline constexpr const FlowInfo* FindFlow(std::string_view word) {
  for (const FlowInfo& info : kFlowInfos)
    if (info.word == word && IsRequest(info.flow)) return &info;
  return nullptr;
}

/// The button that continues a run from the moment that is shown.
inline constexpr std::string_view kResumeButton = "Resume here";

/// What a return to the present is called in lists of keys and in tooltips.
inline constexpr std::string_view kLiveTitle = "Back to the newest moment";

/// Generates web/src/app/flow_table.ts.
std::string FlowTable();

}  // namespace soarbox::workbench
