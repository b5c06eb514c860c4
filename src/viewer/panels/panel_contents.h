// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "debugger/agents.h"
#include "debugger/breakpoints.h"
#include "debugger/console.h"
#include "debugger/io.h"
#include "debugger/memory.h"
#include "debugger/messages.h"
#include "debugger/operators.h"
#include "debugger/plots.h"
#include "debugger/rules.h"
#include "debugger/stack.h"
#include "debugger/timeline.h"
#include "debugger/trace.h"
#include "debugger/why.h"
#include "diagnostics/diagnostic.h"
#include "record/compare.h"

namespace soarbox::viewer {

/// What the panels show, as values. The application fills in what the panels that are visible need, when the tick or
/// what the user looks at has changed; drawing asks nobody anything.

/// Something that a user should mend.
struct ProblemRow {
  Diagnostic diagnostic;
  std::string agent;  ///< Empty: the scenario's or the sandbox's own.
  std::uint64_t tick = 0;
  double time_s = 0;
};

/// Where the picture and the panels stand in the run.
struct Moment {
  std::uint64_t first_tick = 0;  ///< The oldest that one can go back to.
  std::uint64_t shown_tick = 0;
  std::uint64_t last_tick = 0;  ///< The newest.
  double step_s = 1.0 / 30;
  bool is_recording = false;                 ///< All of it is past: nothing but the moment that is shown can change.
  bool is_live = true;                       ///< Shows the newest tick and follows it.
  bool can_go_back = false;                  ///< There is a history.
  bool can_resume = false;                   ///< The run can go on from a past tick.
  std::string resume_refusal;                ///< Why not, if it cannot.
  std::optional<std::uint64_t> branch_tick;  ///< Where the old future was left.
  std::uint32_t branches = 0;                ///< How often the run went back and on.
};

/// A file that is being edited.
struct EditContents {
  std::string file;  ///< Empty: none.
  bool is_rules = true;
  std::uint64_t version = 0;  ///< Grows when the text comes from elsewhere than the panel: from the disk.
  std::string text;
  std::vector<Diagnostic> problems;  ///< Of the text that was checked or applied last.
  std::string notice;                ///< What came of the last thing asked: "3 rules changed".
  bool is_changed = false, is_unsaved = false;
  int go_to_line = 0;             ///< Where to look first; 0: nowhere.
  std::uint64_t go_to_count = 0;  ///< Grows each time that somebody wants to go there.
};

struct WhyContents {
  std::string question;  ///< "Why does scout do what it does?"
  std::optional<debugger::WhyNode> answer;
};

/// The old future beside the new one.
struct FuturesContents {
  std::uint64_t branch_tick = 0;
  std::uint64_t now_tick = 0;
  bool old_is_known = false;  ///< At this tick.
  record::Comparison comparison;
};

struct PanelContents {
  Moment moment;
  /// The agent that the panels are about; empty: none is selected.
  std::string agent;
  bool has_mind = false;
  /// Not empty: why nothing of the mind's inside is shown now.
  std::string not_available;
  /// Not empty: how far a recorded moment is from being simulated again, or why it cannot be.
  std::string past_note;
  /// Not empty: what stands in the panels comes from a recording, which does not hold the mind's memory.
  std::string not_recorded;

  std::vector<debugger::AgentRow> agents;
  std::vector<ProblemRow> problems;  ///< In order of time.
  const debugger::Console* console = nullptr;
  std::uint64_t console_lines = 0;  ///< Grows with each new line.
  debugger::Completion completion;  ///< Of the line last asked for.
  std::string completed_line;       ///< That line.

  debugger::StackView stack;
  debugger::OperatorsView operators;
  std::map<std::string, debugger::MemoryObject> objects;  ///< Those that are unfolded, by identifier.
  std::optional<debugger::ElementStory> story;
  std::vector<sim::ElementFact> found;  ///< By the search of memory.
  std::vector<sim::RuleFact> rules;
  std::optional<debugger::RuleView> rule;
  std::vector<debugger::Coverage::Row> coverage;
  WhyContents why;
  debugger::IoView io;
  std::vector<sim::WatchedFile> files;  ///< That the selected agent was made from.
  EditContents edit;
  std::vector<debugger::Breakpoint> breakpoints;
  std::vector<debugger::BreakHit> hits;  ///< Why the world stands still; empty once it goes on.
  std::vector<std::string> plottable;
  std::optional<FuturesContents> futures;

  // What grows with the run; the application's. Null before its first tick.
  const debugger::Timeline* timeline = nullptr;
  const debugger::Trace* trace = nullptr;
  const debugger::MessageLog* messages = nullptr;
  const std::vector<debugger::PlotSeries>* plots = nullptr;
};

}  // namespace soarbox::viewer
