// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>

#include "debugger/breakpoints.h"
#include "debugger/run_trace.h"
#include "workbench/panel_id.h"

namespace soarbox::workbench {

/// Requests of a user. A desk carries them out; the results appear in the contents. requests_json.h defines the JSON
/// form.

/// Select an agent by its name; empty: none.
struct SelectRequest {
  std::string agent;
};
/// Set the visible panels. Other panels get no contents.
struct LookRequest {
  PanelSet panels;
};

/// Open a file in the user's own editor.
struct OpenFileRequest {
  std::string file;
  int line = 0;
};
/// Execute a line of the Soar command language for an agent.
struct ConsoleRequest {
  std::string agent, line;
};
/// Ask for completions of the last word of a line.
struct CompleteRequest {
  std::string agent, line;
};
/// Store an unsent line, so that the next window shows it again; an empty line removes it.
struct KeepLineRequest {
  std::string agent, line;
};
struct ClearConsoleRequest {};
struct ClearProblemsRequest {};

/// Show a past tick.
struct SeekRequest {
  std::uint64_t tick = 0;
};
/// Show the newest tick, and follow it.
struct LiveRequest {};
/// Continue the run from the tick that is shown. The later ticks become the old future.
struct ResumeRequest {};
/// Set the speed of the world, in simulated seconds per second.
struct SpeedRequest {
  double speed = 1;
};
/// Show a message to the user in the picture.
struct TellRequest {
  std::string text;
};
/// Save a screenshot of the window.
struct SavePictureRequest {};

/// Choose the lines that the panel Trace shows.
struct TraceRequest {
  debugger::TraceKind level = debugger::TraceKind::kEvent;  ///< Lines of this kind and of more important ones.
  std::string agent;                                        ///< If not empty: only lines about the selected agent.
  std::string text;                                         ///< As in TraceFilter.
};

/// Show the operators of this state; empty: of the lowest state with operators.
struct StateRequest {
  std::string state;
};
/// Unfold or fold an object of working memory. The contents include unfolded objects.
struct ObjectRequest {
  std::string id;
  bool is_open = true;
};
/// Show details of an element; 0: of none.
struct ElementRequest {
  std::uint64_t timetag = 0;
};
struct SearchMemoryRequest {
  std::string text;
};
/// Show details of a rule; empty: of none.
struct RuleRequest {
  std::string rule;
};
/// Show only the objects of long-term memory that contain this text.
struct SearchKnownRequest {
  std::string text;
};
/// Show an episode of the selected agent; 0: none.
struct EpisodeRequest {
  std::size_t number = 0;
};
/// Show how a rule was learned, and when it fired; empty: of no rule.
struct LearnedRuleRequest {
  std::string rule;
};
/// Draw the learned value of a rule as a curve.
struct CurveRequest {
  std::string rule;
  bool is_on = true;
};
/// Record how many conditions of each rule match now, and show which rules have taken part so far.
struct CoverageRequest {};

/// Ask why something is the case, or why not.
struct WhyRequest {
  enum class About : std::uint8_t { kAgent, kOperator, kCommand, kElement, kNot } about = About::kAgent;
  std::string what;  ///< A name, or the time tag of an element. Not needed for kAgent.
};

/// Draw what the selected agent imagines over the world.
struct ImagineRequest {
  std::string state;   ///< The scene of this state; empty: what the agent created in any scene.
  std::string record;  ///< Also draw lines that explain this record; empty: none.
};

struct PlotRequest {
  std::string agent, what;
  bool is_on = true;
};

/// Open a file in the editor, at this line or this rule.
struct EditRequest {
  std::string file;
  int line = 0;
  std::string rule = {};
};
/// An action on the edited text.
struct EditTextRequest {
  enum class What : std::uint8_t { kType, kCheck, kApply, kSave, kRevert } what = What::kType;
  std::string text;
};

/// Save all files that have changes.
struct SaveAllRequest {};

/// Open another world or recording in this window.
struct OpenRunRequest {
  std::string what;  ///< The name or path of a scenario, or the file of a recording.
};
/// Add or remove a watch.
struct WatchRequest {
  std::string what;
  bool is_on = true;
};
/// Add an agent to the minds that are shown side by side, or remove it.
struct BesideRequest {
  std::string agent;
  bool is_on = true;
};
/// Search everywhere for a text; empty: end the search.
struct SearchRequest {
  std::string text;
};
/// List what can be opened and searched, because the user is about to choose.
struct OfferRequest {
  bool is_on = true;
};

struct BreakRequest {
  debugger::BreakKind kind = debugger::BreakKind::kFire;
  std::string agent, what;
};
struct ChangeBreakRequest {
  int number = 0;
  enum class What : std::uint8_t { kClear, kEnable, kDisable } what = What::kClear;
};

/// Let scripts stop at a line of a file, or at the next line after it that a function executes; or no longer. With a
/// condition, an expression of Lua, they stop only if it is true.
struct LineStopRequest {
  std::string file;
  int line = 0;
  bool is_on = true;
  std::string condition = {};
};
/// Let scripts stop at errors that they do not catch, or no longer.
struct ErrorStopRequest {
  bool is_on = true;
};
/// Let the stopped script continue: until the next stop, into a call, over the line, or out of the function.
struct ScriptGoRequest {
  enum class How : std::uint8_t { kOn, kInto, kOver, kOut } how = How::kOn;
};
/// Show the variables of a call of the stopped script; 0: of the innermost.
struct ScriptCallRequest {
  std::size_t call = 0;
};
/// Unfold or fold a variable of the stopped script.
struct ScriptValueRequest {
  std::string key;
  bool is_open = true;
};
/// Add or remove an expression whose value is shown while a script is stopped.
struct ScriptWatchRequest {
  std::string what;
  bool is_on = true;
};

/// Ask for a hint or a grade of the lesson, or open another lesson. Opening one copies its files to the learner's
/// folder and shows it.
struct LessonRequest {
  enum class What : std::uint8_t { kHint, kGrade, kOpen, kCancel } what = What::kHint;
  std::string lesson = {};  ///< The lesson to open.
};

/// Let the run begin again with the same seed. The program around the desk does this.
struct FlowRequest {
  enum class What : std::uint8_t { kBeginAgain } what = What::kBeginAgain;
};

using Request =
    std::variant<SelectRequest, LookRequest, OpenFileRequest, ConsoleRequest, CompleteRequest, KeepLineRequest,
                 ClearConsoleRequest, ClearProblemsRequest, SeekRequest, LiveRequest, ResumeRequest, SpeedRequest,
                 SavePictureRequest, TellRequest, TraceRequest, StateRequest, ObjectRequest, ElementRequest,
                 SearchMemoryRequest, RuleRequest, CoverageRequest, SearchKnownRequest, EpisodeRequest,
                 LearnedRuleRequest, CurveRequest, WhyRequest, ImagineRequest, PlotRequest, EditRequest,
                 EditTextRequest, SaveAllRequest, OpenRunRequest, WatchRequest, BesideRequest, SearchRequest,
                 OfferRequest, BreakRequest, ChangeBreakRequest, LineStopRequest, ErrorStopRequest, ScriptGoRequest,
                 ScriptCallRequest, ScriptValueRequest, ScriptWatchRequest, LessonRequest, FlowRequest>;

}  // namespace soarbox::workbench
