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
#include "debugger/goal_stack.h"
#include "debugger/imagery.h"
#include "debugger/learning.h"
#include "debugger/links.h"
#include "debugger/memory.h"
#include "debugger/messages.h"
#include "debugger/operators.h"
#include "debugger/plots.h"
#include "debugger/recall.h"
#include "debugger/rules.h"
#include "debugger/run_trace.h"
#include "debugger/scene_shapes.h"
#include "debugger/shown.h"
#include "debugger/timeline.h"
#include "debugger/why.h"
#include "diagnostics/diagnostic.h"
#include "record/compare.h"
#include "sim/findings.h"
#include "world/scene_snapshot.h"

namespace soarbox::workbench {

/// What panels show, as values. A desk fills in what the panels that are looked at need, when the tick or what the user
/// looks at has changed; whoever shows them needs nothing else. contents_json.h has their form as JSON.

/// Something for the user to correct.
struct ProblemRow {
  Diagnostic diagnostic;
  std::string agent;  ///< Empty: the scenario's or the sandbox's own.
  std::uint64_t tick = 0;
  double time_s = 0;
  sim::Cause cause = sim::Cause::kSlip;
};

/// A check of the run's mission.
struct CheckRow {
  std::string name;
  std::string expected;  ///< "scout should be at gate by 30 s".
  std::string was;       ///< What was there instead; empty: nothing to say.
  std::string agent;     ///< Who decided it; empty: nobody in particular.
  bool is_marker = false;
  std::string state;  ///< "open", "true", "false", "untested", "undecided".
  std::uint64_t tick = 0;
  double time_s = 0;
};

/// The lesson that the world belongs to.
struct LessonContents {
  std::string name, title, idea, task, panel;
  std::vector<std::string> new_panels;  ///< Words of the panels that this lesson is about.
  std::vector<std::string> hints;       ///< Those that the learner asked for.
  std::size_t hint_count = 0;           ///< All that there are.
  bool is_passed = false;
  bool is_graded = false;          ///< Being graded.
  std::vector<std::string> grade;  ///< The result, line by line.
  std::string next;                ///< The lesson after this one; empty: this is the last.
};

/// A lesson that can be begun.
struct LessonOffer {
  std::string name, title;
  bool is_passed = false;
};

/// Where the picture and the panels stand in the run.
struct Moment {
  std::uint64_t first_tick = 0;  ///< The oldest that can be shown.
  std::uint64_t shown_tick = 0;
  std::uint64_t last_tick = 0;  ///< The newest.
  double step_s = 1.0 / 30;
  int turn_ticks = 1;                        ///< Ticks in a turn of a game: a step goes on by a turn.
  bool is_recording = false;                 ///< All of it is past: only the moment that is shown can change.
  bool is_live = true;                       ///< Shows the newest tick and follows it.
  bool can_go_back = false;                  ///< There is a history.
  bool can_resume = false;                   ///< The run can continue from a past tick.
  std::string resume_refusal;                ///< Why not, if it cannot.
  std::optional<std::uint64_t> branch_tick;  ///< Where the old future was left.
  std::uint32_t branches = 0;                ///< How often the run went back and continued.
};

/// A file that is being edited.
struct EditContents {
  std::string file;  ///< Empty: none.
  bool is_rules = true;
  std::uint64_t version = 0;  ///< Grows when the text comes from the disk rather than from the panel.
  std::string text;
  std::vector<Diagnostic> problems;  ///< Of the text that was checked or applied last.
  std::string notice;                ///< The outcome of the last request: "3 rules changed".
  bool is_changed = false, is_unsaved = false;
  int go_to_line = 0;             ///< Where to look first; 0: nowhere.
  std::uint64_t go_to_count = 0;  ///< Grows with each request to go there.
};

/// A file that was opened to be edited, whether it is looked at or not.
struct OpenFile {
  std::string file;
  bool is_changed = false;  ///< It differs from what runs.
  bool is_unsaved = false;  ///< It differs from what is on the disk.
  std::string failure;      ///< Why it could not be saved last; empty: it could.
};

struct WhyContents {
  std::string question;  ///< "Why does scout do what it does?"
  std::optional<debugger::WhyNode> answer;
};

/// A watch: what it finds in each mind, looked at again after each decision.
struct WatchRow {
  struct Cell {
    std::string agent;
    std::string text;     ///< The value now.
    bool is_new = false;  ///< It changed when the mind changed last.
    bool is_error = false;
    std::uint64_t tick = 0;  ///< Since when it has this value.
  };
  std::string what;         ///< "S1.io.input-link.self.health", "print s1".
  std::vector<Cell> cells;  ///< One for each agent of Contents::beside.
};

/// One of several minds that are looked at side by side.
struct MindColumn {
  std::string agent;
  std::string note;  ///< Why nothing is shown; empty: something is.
  debugger::StackView stack;
  debugger::OperatorsView operators;
  std::string command;  ///< What it said last.
};

/// A place where the text that the user searches everywhere was found.
struct FoundPlace {
  enum class Kind : std::uint8_t { kRule, kFile, kMemory, kTrace, kMessage } kind = Kind::kRule;
  std::string title;   ///< The line itself.
  std::string detail;  ///< Where it stands: "fighter.soar:12", "0:03.20".
  std::string agent;
  std::string file;
  int line = 0;
  std::uint64_t tick = 0;
  std::string id;  ///< Of memory: the identifier.
};

/// A world that can be opened.
struct ScenarioOffer {
  std::string name;   ///< What opens it: a name or a path.
  std::string about;  ///< Its description; empty: none.
};

/// The old future beside the new one.
struct FuturesContents {
  std::uint64_t branch_tick = 0;
  std::uint64_t now_tick = 0;
  bool old_is_known = false;  ///< At this tick.
  record::Comparison comparison;
};

/// A ghost: where somebody would be in another future, or what an agent remembers.
struct GhostBody {
  std::string name;
  std::uint32_t agent_id = 0;  ///< Whose figure it is; 0: nobody's.
  std::string kind, team;      ///< Of that agent.
  world::Vec3 position;        ///< Of the middle of the body, as in AgentSnapshot.
  world::Vec3 forward{0, 0, 1};
  float radius_m = 0.3f, height_m = 0.6f;
};

/// The exercise of other simulations that a live run takes part in (docs/dis.md).
struct ExerciseContents {
  struct Entity {
    std::string id;     ///< "7:8:9"
    std::string agent;  ///< Its body here; empty: it is too far away to have one.
    std::string marking, team, body, type;
    int silent_s = 0;  ///< Since its last PDU.
  };
  /// At most so many entities are listed.
  static constexpr std::size_t kMostListed = 200;

  int exercise = 1;
  std::string address;             ///< "239.1.2.3:3000"
  bool is_of_this_machine = true;  ///< No other machine hears or is heard.
  std::string as;                  ///< Site and application: "1:1".
  bool listens_only = false, takes_orders = false;
  bool is_frozen = false;  ///< By an order of the exercise's manager.
  std::uint64_t sent = 0, not_sent = 0, received = 0;
  double sent_per_s = 0, received_per_s = 0;
  std::vector<std::pair<std::string, std::uint64_t>> dropped;  ///< PDUs by reason.
  std::size_t entity_count = 0;
  std::vector<Entity> entities;  ///< By their ids.
};

struct Contents {
  std::uint64_t revision = 0;  ///< Another one when anything but the moment may have changed.
  Moment moment;
  /// The agent that the panels are about; empty: none is selected.
  std::string agent;
  bool has_mind = false;
  std::size_t agent_count = 0;           ///< In the world at the moment that is shown.
  std::vector<std::string> soar_agents;  ///< Agents with a Soar mind, at most kMostSoarAgents of them.
  static constexpr std::size_t kMostSoarAgents = 16;
  /// Not empty: why the mind cannot be looked into now.
  std::string not_available;
  /// Not empty: how far a recorded moment is from being simulated again, or why it cannot be.
  std::string past_note;
  /// Not empty: what stands in the panels comes from a recording, which does not hold the mind's memory.
  std::string not_recorded;

  std::vector<debugger::AgentRow> agents;
  std::map<std::uint32_t, std::string> activities;  ///< By agent: what its body does now, "move-to gate".
  std::vector<ProblemRow> problems;                 ///< The cause first, of equal ones the newest.
  std::vector<CheckRow> checks;                     ///< Of the run's mission; none: it has none.
  std::optional<LessonContents> lesson;
  std::vector<LessonOffer> lessons;  ///< All, in their order.
  const debugger::Console* console = nullptr;
  std::uint64_t console_lines = 0;  ///< Grows with each new line.
  debugger::Completion completion;  ///< Of the line last asked for.
  std::string completed_line;       ///< That line.
  std::string begun_line;           ///< Typed for this agent and not sent, perhaps in another window.

  debugger::ShownView shown;  ///< What the script of the selected agent shows of its state.
  debugger::StackView stack;
  debugger::OperatorsView operators;
  std::map<std::string, debugger::MemoryObject> objects;  ///< Those that are unfolded, by identifier.
  std::optional<debugger::ElementStory> story;
  std::uint64_t element_before = 0, element_after = 0;  ///< Time tags of those looked at before and after; 0: none.
  std::vector<explain::ElementFact> found;              ///< By the search of memory.
  std::string memory_search;                            ///< The text that they contain; empty: nothing is searched.
  std::vector<explain::RuleFact> rules;
  std::optional<debugger::RuleView> rule;
  std::string rule_text;  ///< That rule as its author wrote it; empty if no file tells.
  std::string rule_file;  ///< Where it stands there.
  int rule_line = 0;
  std::vector<debugger::Coverage::Row> coverage;
  debugger::LongTermView long_term;
  std::string known_search;       ///< The text that all objects in `long_term` have.
  debugger::EpisodeView episode;  ///< That is looked at; its number is 0 if none is.
  debugger::LearningView learning;
  std::vector<std::string> learning_curves;  ///< Rules whose learned values are drawn.
  debugger::LearnedRuleView learned_rule;    ///< The one whose explanation is looked at; no name: none.
  WhyContents why;
  debugger::IoView io;
  std::vector<sim::WatchedFile> files;  ///< That the selected agent was made from.
  EditContents edit;
  std::vector<OpenFile> open_files;
  std::vector<std::string> beside;  ///< The agents whose minds are looked at side by side.
  std::vector<WatchRow> watches;
  std::string watch_fault;  ///< Why what was to be watched last cannot be; empty: it can.
  std::vector<MindColumn> minds;
  std::string searched;  ///< Everywhere, for `places`.
  std::vector<FoundPlace> places;
  std::vector<std::string> all_files;  ///< That the world was made from; while a palette is open.
  std::vector<ScenarioOffer> scenarios;
  std::vector<std::string> recent;  ///< Scenarios and recordings that were opened before, the newest first.
  std::vector<debugger::Breakpoint> breakpoints;
  std::vector<debugger::BreakHit> hits;  ///< Why the world stopped; empty once it runs again.
  std::vector<std::string> plottable;
  std::optional<FuturesContents> futures;
  std::vector<GhostBody> ghosts;
  std::optional<ExerciseContents> exercise;
  debugger::ImageryView imagery;
  std::string imagined_state;                ///< Whose scene is drawn; empty: what the agent made up in any.
  std::string imagined_record;               ///< The answer that is shown in the picture; empty: none.
  std::vector<debugger::SceneShape> shapes;  ///< That are drawn of what the agent imagines.
  debugger::AnswerLines answer_lines;        ///< Of that answer.

  // What grows with the run; the desk's. Null before its first tick.
  const debugger::Timeline* timeline = nullptr;
  const debugger::Trace* trace = nullptr;
  debugger::TraceFilter trace_filter;                                   ///< What of it the panel Trace shows.
  const std::deque<const debugger::TraceLine*>* trace_found = nullptr;  ///< The lines that pass it; null: not searched.
  const debugger::MessageLog* messages = nullptr;
  const debugger::RecallLog* recalls = nullptr;         ///< Of the selected agent.
  const debugger::LearningLog* learning_log = nullptr;  ///< Likewise.
  const std::vector<debugger::PlotSeries>* plots = nullptr;
};

}  // namespace soarbox::workbench
