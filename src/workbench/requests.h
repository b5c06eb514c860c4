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

/// What a user asks for. A desk carries it out; what comes of it appears in the contents. requests_json.h has their
/// form as JSON.

/// Look at an agent of the world, by its name; empty: at none.
struct SelectRequest {
  std::string agent;
};
/// These panels are looked at: the others need no contents.
struct LookRequest {
  PanelSet panels;
};

/// Open a file in the user's own editor.
struct OpenFileRequest {
  std::string file;
  int line = 0;
};
/// Carry out a line of the Soar command language for an agent.
struct ConsoleRequest {
  std::string agent, line;
};
/// How the word that the line ends with may go on.
struct CompleteRequest {
  std::string agent, line;
};
/// Keep what was typed and not sent, so that it is there again in the next window; an empty line: nothing.
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
/// Go on from the tick that is shown; what came after it becomes the old future.
struct ResumeRequest {};
/// Simulated seconds per second.
struct SpeedRequest {
  double speed = 1;
};
/// Tell the user in the picture that something was done.
struct TellRequest {
  std::string text;
};
/// Write the window as a picture.
struct SavePictureRequest {};

/// Which lines the panel Trace shows.
struct TraceRequest {
  debugger::TraceKind level = debugger::TraceKind::kEvent;  ///< Lines of this kind and of those before it.
  std::string agent;                                        ///< Not empty: only lines about the selected agent.
  std::string text;                                         ///< As in TraceFilter.
};

/// The operators of this state; empty: of the lowest.
struct StateRequest {
  std::string state;
};
/// Keep an object of working memory in the contents, or no longer.
struct ObjectRequest {
  std::string id;
  bool is_open = true;
};
/// Tell all about an element; 0: nothing any more.
struct ElementRequest {
  std::uint64_t timetag = 0;
};
struct SearchMemoryRequest {
  std::string text;
};
/// Tell all about a rule; empty: nothing any more.
struct RuleRequest {
  std::string rule;
};
/// Show what the agent knows with this text in it.
struct SearchKnownRequest {
  std::string text;
};
/// Look at an episode of the selected agent; 0: at none any more.
struct EpisodeRequest {
  std::size_t number = 0;
};
/// Show how a rule was learned, and where it fired; empty: of none any more.
struct LearnedRuleRequest {
  std::string rule;
};
/// Draw the learned value of a rule as a curve.
struct CurveRequest {
  std::string rule;
  bool is_on = true;
};
/// Note how far the rules match now, and tell which took part so far.
struct CoverageRequest {};

/// Why something is, or is not.
struct WhyRequest {
  enum class About : std::uint8_t { kAgent, kOperator, kCommand, kElement, kNot } about = About::kAgent;
  std::string what;  ///< A name; for elements the time tag. Agent: not needed.
};

/// Draw what the selected agent imagines over the world.
struct ImagineRequest {
  std::string state;   ///< The scene of this state; empty: what the agent made up in any.
  std::string record;  ///< With lines that show why this answer is so; empty: none.
};

struct PlotRequest {
  std::string agent, what;
  bool is_on = true;
};

/// Edit a file, from this line on or at this rule.
struct EditRequest {
  std::string file;
  int line = 0;
  std::string rule = {};
};
/// What to do with the edited text.
struct EditTextRequest {
  enum class What : std::uint8_t { kType, kCheck, kApply, kSave, kRevert } what = What::kType;
  std::string text;
};

/// Write all files that have changes.
struct SaveAllRequest {};

/// Show another world or recording in this window.
struct OpenRunRequest {
  std::string what;  ///< A scenario's name or path, or a file of a recording.
};
/// Print this of minds again and again, or no longer.
struct WatchRequest {
  std::string what;
  bool is_on = true;
};
/// Look at an agent's mind beside those of others, or no longer.
struct BesideRequest {
  std::string agent;
  bool is_on = true;
};
/// Find a text in all that can be searched; empty: no longer.
struct SearchRequest {
  std::string text;
};
/// Tell what can be opened and searched: somebody is about to choose.
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

/// Help with a lesson, its grade, or another one: its files are put into the learner's folder, and the window shows it.
struct LessonRequest {
  enum class What : std::uint8_t { kHint, kGrade, kOpen, kCancel } what = What::kHint;
  std::string lesson = {};  ///< Which one to open.
};

using Request =
    std::variant<SelectRequest, LookRequest, OpenFileRequest, ConsoleRequest, CompleteRequest, KeepLineRequest,
                 ClearConsoleRequest, ClearProblemsRequest, SeekRequest, LiveRequest, ResumeRequest, SpeedRequest,
                 SavePictureRequest, TellRequest, TraceRequest, StateRequest, ObjectRequest, ElementRequest,
                 SearchMemoryRequest, RuleRequest, CoverageRequest, SearchKnownRequest, EpisodeRequest,
                 LearnedRuleRequest, CurveRequest, WhyRequest, ImagineRequest, PlotRequest, EditRequest,
                 EditTextRequest, SaveAllRequest, OpenRunRequest, WatchRequest, BesideRequest, SearchRequest,
                 OfferRequest, BreakRequest, ChangeBreakRequest, LessonRequest>;

}  // namespace soarbox::workbench
