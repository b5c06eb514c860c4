// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "debugger/agents.h"
#include "debugger/breakpoints.h"
#include "debugger/console.h"
#include "debugger/imagery_rows.h"
#include "debugger/io_rows.h"
#include "debugger/learning.h"
#include "debugger/line_stops.h"
#include "debugger/memory.h"
#include "debugger/messages.h"
#include "debugger/operators.h"
#include "debugger/plots.h"
#include "debugger/recall.h"
#include "debugger/rules.h"
#include "debugger/run_trace.h"
#include "debugger/scene_shapes.h"
#include "debugger/shown.h"
#include "debugger/stack_rows.h"
#include "debugger/timeline.h"
#include "debugger/why.h"
#include "diagnostics/diagnostic.h"
#include "record/compare.h"
#include "sim/findings.h"
#include "world/scene_snapshot.h"

namespace soarbox::workbench {

/// The data that panels show. A desk fills in the data of the visible panels when the tick or the user's selection has
/// changed. Panels need no other data. contents_json.h defines the JSON form.

/// An error or a warning that the user should correct.
struct ProblemRow {
  Diagnostic diagnostic;
  std::string agent;  ///< Empty for problems of the scenario or of the sandbox's script.
  std::uint64_t tick = 0;
  double time_s = 0;
  sim::Cause cause = sim::Cause::kSlip;
};

/// A check of the run's mission.
struct CheckRow {
  std::string name;
  std::string expected;  ///< "scout should be at gate by 30 s".
  std::string was;       ///< The value found instead; empty if there is none to report.
  std::string agent;     ///< The agent whose behaviour decided the check; empty if there is no such agent.
  bool is_marker = false;
  std::string state;  ///< "open", "true", "false", "untested", "undecided".
  std::uint64_t tick = 0;
  double time_s = 0;
};

/// The lesson that the world belongs to.
struct LessonContents {
  std::string name, title, idea, task, panel;
  std::vector<std::string> new_panels;  ///< Words of the panels that this lesson is about.
  std::vector<std::string> hints;       ///< The hints that the learner has asked for.
  std::size_t hint_count = 0;           ///< Number of all hints.
  bool is_tried = false;                ///< The learner has changed something, or had it graded.
  bool is_passed = false;
  bool is_graded = false;          ///< Grading is in progress.
  std::vector<std::string> grade;  ///< The result, line by line.
  std::string next;                ///< The next lesson; empty if this is the last.
};

/// A lesson that the user can open.
struct LessonOffer {
  std::string name, title;
  bool is_passed = false;
};

/// The tick that the picture and the panels show, and the ticks that they can show.
struct Moment {
  std::uint64_t first_tick = 0;  ///< The oldest tick that can be shown.
  std::uint64_t shown_tick = 0;
  std::uint64_t last_tick = 0;  ///< The newest tick.
  double step_s = 1.0 / 30;
  int turn_ticks = 1;                        ///< Ticks in a turn of a game. A step advances the world by a turn.
  bool is_recording = false;                 ///< The run is a recording: nothing changes except shown_tick.
  bool is_live = true;                       ///< The newest tick is shown, and new ticks are followed.
  bool can_go_back = false;                  ///< The run has a history.
  bool can_resume = false;                   ///< The run can continue from a past tick.
  std::string resume_refusal;                ///< Why it cannot; empty if it can.
  std::optional<std::uint64_t> branch_tick;  ///< The tick at which the run last left its old future.
  std::uint32_t branches = 0;                ///< How often the run went back and continued from there.
  /// The tick at which the user last changed the rules of the running world; nothing if they are those it began with.
  std::optional<std::uint64_t> changed_tick;
};

/// A file that is being edited.
struct EditContents {
  std::string file;  ///< Empty: none.
  bool is_rules = true;
  std::uint64_t version = 0;  ///< Incremented when the text does not come from the panel, but from the file or a draft.
  std::string text;
  std::vector<Diagnostic> problems;  ///< Of the text that was last checked or applied.
  std::string notice;                ///< The result of the last request: "3 rules changed".
  std::uint64_t reload_count = 0;    ///< Incremented when the run has reloaded the text.
  bool is_changed = false, is_unsaved = false;
  int go_to_line = 0;             ///< The line to scroll to; 0: none.
  std::uint64_t go_to_count = 0;  ///< Incremented by each request to scroll.
  bool can_stop = false;          ///< It is a script that can stop at lines.
  std::vector<int> stops;         ///< The lines at which it stops.
  /// The condition of each of these stops; empty: always.
  std::vector<std::string> stop_conditions;
  int stopped_line = 0;  ///< The line at which it is stopped; 0: it is not.
};

/// A file that was opened in the editor, whether it is visible or not.
struct OpenFile {
  std::string file;
  bool is_changed = false;  ///< It differs from what runs.
  bool is_unsaved = false;  ///< It differs from the file on the disk.
  std::string failure;      ///< Why the last attempt to save it failed; empty if it did not fail.
};

struct WhyContents {
  std::string question;  ///< "Why does scout do what it does?"
  std::optional<debugger::WhyNode> answer;
};

/// A watch with its value for each agent. It is evaluated after each decision.
struct WatchRow {
  struct Cell {
    std::string agent;
    std::string text;     ///< The present value.
    bool is_new = false;  ///< The value changed in the last decision.
    bool is_error = false;
    std::uint64_t tick = 0;  ///< The tick of the last change.
  };
  std::string what;         ///< "S1.io.input-link.self.health", "print s1".
  std::vector<Cell> cells;  ///< One for each agent in Contents::beside.
};

/// One column of several minds that are shown side by side.
struct MindColumn {
  std::string agent;
  std::string note;  ///< Why the column is empty; empty if it is not.
  debugger::StackView stack;
  debugger::OperatorsView operators;
  std::string command;  ///< The last command that the mind gave.
};

/// A match of the text that the user searches for everywhere.
struct FoundPlace {
  enum class Kind : std::uint8_t { kRule, kFile, kMemory, kTrace, kMessage } kind = Kind::kRule;
  std::string title;   ///< The matching line.
  std::string detail;  ///< Where it is: "fighter.soar:12", "0:03.20".
  std::string agent;
  std::string file;
  int line = 0;
  std::uint64_t tick = 0;
  std::string id;  ///< For kMemory: the identifier.
};

/// A world that the user can open.
struct ScenarioOffer {
  std::string name;   ///< The name or path that opens it.
  std::string about;  ///< Its description; may be empty.
};

/// A comparison of the old future with the new one.
struct FuturesContents {
  std::uint64_t branch_tick = 0;
  std::uint64_t now_tick = 0;
  bool old_is_known = false;  ///< The old future has a record of this tick.
  record::Comparison comparison;
};

/// A ghost: the position of an agent in another future, or of an object that an agent remembers.
struct GhostBody {
  std::string name;
  std::uint32_t agent_id = 0;  ///< The agent whose figure is drawn; 0: none.
  std::string kind, team;      ///< Of that agent.
  world::Vec3 position;        ///< Centre of the body, as in AgentSnapshot.
  world::Vec3 forward{0, 0, 1};
  float radius_m = 0.3f, height_m = 0.6f;
};

/// The exercise of other simulations that a live run takes part in (docs/dis.md).
struct ExerciseContents {
  struct Entity {
    std::string id;     ///< "7:8:9"
    std::string agent;  ///< The agent that represents it here; empty if the entity is too far away to have one.
    std::string marking, team, body, type;
    int silent_s = 0;  ///< Seconds since its last PDU.
  };
  /// Maximum number of entities that are listed.
  static constexpr std::size_t kMostListed = 200;

  int exercise = 1;
  std::string address;             ///< "239.1.2.3:3000"
  bool is_of_this_machine = true;  ///< PDUs are neither received from nor sent to other machines.
  std::string as;                  ///< Site and application: "1:1".
  bool listens_only = false, takes_orders = false;
  bool is_frozen = false;  ///< A manager of the exercise has frozen it.
  std::uint64_t sent = 0, not_sent = 0, received = 0;
  double sent_per_s = 0, received_per_s = 0;
  std::vector<std::pair<std::string, std::uint64_t>> dropped;  ///< Number of dropped PDUs by reason.
  std::size_t entity_count = 0;
  std::vector<Entity> entities;  ///< Sorted by id.
};

/// The lines at which the scripts of a run stop, and the script that is stopped (debugger/line_stops.h).
struct ScriptContents {
  bool can_stop = false;           ///< Scripts of this run can stop.
  std::vector<std::string> files;  ///< The scripts of the run.
  std::vector<debugger::LineStop> stops;
  bool at_errors = false;            ///< They stop at errors, too.
  std::vector<std::string> watches;  ///< Expressions whose values are shown while a script is stopped.
  std::uint64_t count = 0;           ///< Number of times that a script has stopped.
  std::optional<debugger::StoppedScript> stopped;
  /// A line of the text around the place of the shown call.
  struct Line {
    int number = 0;
    std::string text;
  };
  std::vector<Line> lines;
};

struct Contents {
  std::uint64_t revision = 0;  ///< Changes when anything except `moment` may have changed.
  Moment moment;
  /// The selected agent, which the panels show; empty if none is selected.
  std::string agent;
  bool has_mind = false;
  std::size_t agent_count = 0;           ///< Number of agents at the moment that is shown.
  std::vector<std::string> soar_agents;  ///< Agents with a Soar mind, at most kMostSoarAgents of them.
  static constexpr std::size_t kMostSoarAgents = 16;
  /// Why the mind cannot be inspected now; empty if it can.
  std::string not_available;
  /// If a past moment is shown: the progress of simulating it again, or why that is impossible; else empty.
  std::string past_note;
  /// Not empty if the panels show recorded data that do not include the mind's memory.
  std::string not_recorded;

  std::vector<debugger::AgentRow> agents;
  std::map<std::uint32_t, std::string> activities;  ///< By agent id: what its body does now, "move-to gate".
  std::vector<ProblemRow> problems;                 ///< Sorted by cause; the newest first among equal causes.
  std::vector<CheckRow> checks;                     ///< Checks of the run's mission; empty if it has none.
  std::optional<LessonContents> lesson;
  std::vector<LessonOffer> lessons;  ///< All lessons, in order.
  const debugger::Console* console = nullptr;
  std::uint64_t console_lines = 0;  ///< Incremented for each new line of this console.
  debugger::Completion completion;  ///< Of `completed_line`.
  std::string completed_line;       ///< The line for which completions were last requested.
  std::string begun_line;           ///< The unsent line of this agent, perhaps typed in another window.

  debugger::ShownView shown;  ///< What the script of the selected agent shows (Agent.Show).
  debugger::StackView stack;
  debugger::OperatorsView operators;
  std::map<std::string, debugger::MemoryObject> objects;  ///< The unfolded objects, by identifier.
  std::optional<debugger::ElementStory> story;
  std::uint64_t element_before = 0, element_after = 0;  ///< Time tags of the elements viewed before and after this one;
                                                        ///< 0: none.
  std::vector<explain::ElementFact> found;              ///< The results of the search of memory.
  std::string memory_search;                            ///< The text searched for; empty if there is no search.
  std::vector<explain::RuleFact> rules;
  std::optional<debugger::RuleView> rule;
  std::string rule_text;  ///< The rule as its author wrote it; empty if its file is not available.
  std::string rule_file;  ///< The file that contains it.
  int rule_line = 0;
  std::vector<debugger::Coverage::Row> coverage;
  debugger::LongTermView long_term;
  std::string known_search;       ///< The text searched for; `long_term` has only objects that contain it.
  debugger::EpisodeView episode;  ///< The selected episode; its number is 0 if none is selected.
  debugger::LearningView learning;
  std::vector<std::string> learning_curves;  ///< Rules whose learned values are drawn as curves.
  debugger::LearnedRuleView learned_rule;    ///< The selected learned rule; its name is empty if none is selected.
  WhyContents why;
  debugger::IoView io;
  std::vector<sim::WatchedFile> files;  ///< The files that the selected agent was made from.
  EditContents edit;
  std::vector<OpenFile> open_files;
  std::vector<std::string> beside;  ///< The agents whose minds are shown side by side.
  std::vector<WatchRow> watches;
  std::string watch_fault;  ///< Why the last watch was not accepted; empty if it was.
  std::vector<MindColumn> minds;
  std::string searched;  ///< The text searched for everywhere; `places` has the matches.
  std::vector<FoundPlace> places;
  std::vector<std::string> all_files;  ///< All files of the world; filled in while a palette is open.
  std::vector<ScenarioOffer> scenarios;
  std::vector<std::string> recent;  ///< Scenarios and recordings that were opened before, the newest first.
  std::vector<debugger::Breakpoint> breakpoints;
  std::vector<debugger::BreakHit> hits;  ///< Why the world stopped; empty after it runs again.
  std::vector<std::string> plottable;
  std::optional<FuturesContents> futures;
  std::vector<GhostBody> ghosts;
  std::optional<ExerciseContents> exercise;
  ScriptContents script;
  debugger::ImageryView imagery;
  std::string imagined_state;                ///< The state whose scene is drawn; empty: what the agent created in any
                                             ///< scene.
  std::string imagined_record;               ///< The record whose explanation is drawn in the picture; empty: none.
  std::vector<debugger::SceneShape> shapes;  ///< The parts of imagined scenes that are drawn.
  debugger::AnswerLines answer_lines;        ///< Lines for `imagined_record`.

  // Models that grow with the run. They belong to the desk and are null before its first tick.
  const debugger::Timeline* timeline = nullptr;
  const debugger::Trace* trace = nullptr;
  debugger::TraceFilter trace_filter;                                   ///< Selects the lines that the panel Trace
                                                                        ///< shows.
  const std::deque<const debugger::TraceLine*>* trace_found = nullptr;  ///< The lines that pass the filter; null if
                                                                        ///< they were not searched.
  const debugger::MessageLog* messages = nullptr;
  const debugger::RecallLog* recalls = nullptr;         ///< Of the selected agent.
  const debugger::LearningLog* learning_log = nullptr;  ///< Of the selected agent.
  const std::vector<debugger::PlotSeries>* plots = nullptr;
};

}  // namespace soarbox::workbench
