// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "sim/actor.h"
#include "sim/graph_mirror.h"
#include "sim/input_mirror.h"
#include "sim/mind_log.h"
#include "sim/scene_sense.h"
#include "vocabulary/command_check.h"

namespace sml {
class Agent;
class FloatElement;
class Identifier;
}  // namespace sml

namespace soarbox::sim {

struct MindSettings {
  bool has_distance = true;               ///< Perceives the thesis' ^distance.
  bool blinks = true;                     ///< ^distance counts as new in each tick.
  bool waits = false;                     ///< With nothing to do it waits for the world instead of making substates;
                                          ///< a file of rules may say otherwise (soar wait-snc off).
  bool imagines = false;                  ///< Its spatial visual system is on and receives what its body perceives.
  MindDetail detail = MindDetail::kNone;  ///< How much of what it does is noted.
};

/// A rule fired and one of its actions could not be done, or it would fire without end.
struct ActionFailure {
  std::string rule;
  std::string
      text;  ///< In the kernel's words: "Error: attempt to divide ('/') by zero.\n". Empty: it fires without end.
};

/// The mind of one agent as a Soar program: what it perceives is on its input link; each identifier directly on its
/// output link is a command.
///
/// A command is handed out once, however long it stays; the world answers below it. Owned by the simulation; the
/// kernel behind it must outlive it.
class SoarMind {
 public:
  SoarMind(sml::Agent& agent, const MindSettings& settings);

  // Percepts: written at once, seen by the rules in the next Decide.
  void SetDistance(float distance_squared_m2);
  /// What the senses of its body report, including its surroundings if they are read now.
  void Perceive(const Actor& body, bool surroundings);
  /// All that a sandbox's script says it perceives.
  void ShowGraph(const script::PerceptGraph& percepts) { graph_.Show(percepts); }
  void ShowRows(const vocabulary::PerceptList& percepts) { rows_.Show(percepts); }

  /// Decides until there is output or the decision budget is used up (max-nil-output-cycles). commands() then holds
  /// what is new on the output link, withdrawn() what went.
  /// `has_run`: something else has let it decide already.
  void Decide(bool has_run = false);
  std::span<const vocabulary::SaidCommand> commands() const { return commands_; }
  std::span<const std::uint64_t> withdrawn() const { return withdrawn_; }
  /// Whether a command is on the output link now.
  bool HasCommand(std::uint64_t tag) const {
    return std::ranges::any_of(standing_, [&](const Standing& one) { return one.tag == tag; });
  }
  /// Commands that are on the output link now, answered or not.
  std::size_t standing() const { return standing_.size(); }
  /// Reports to the program how a command went. Nothing happens if the program has withdrawn it.
  void Answer(const Outcome& outcome);
  void Complete(std::uint64_t tag);

  /// What rules have written since the last call, in whole lines.
  std::vector<std::string> TakeWritten();
  /// Actions that failed since the last call, up to a hundred; none are known of a kernel in another process.
  std::vector<ActionFailure> TakeFailures();

  /// True once the program has halted; it then does nothing more until it is restarted.
  bool Halted() const;
  /// What used up the program's memory, in the kernel's words; empty if nothing did. The program is then at its end.
  std::string_view Breakdown() const;
  /// Starts the program again: working memory is cleared, the rules stay.
  void Restart();

  /// Its memory in bytes; 0 if the kernel is in another process.
  std::size_t MemoryBytes() const;
  /// How many rules it has learned; 0 if the kernel is in another process.
  std::size_t LearnedRules() const;
  /// The rule that most of them came from, with their number: "478 of them from 'tour*look*note'".
  std::string MostLearnedFrom() const;
  /// How often its rules fired in the last Decide; 0 if the kernel is in another process.
  std::uint64_t fired() const { return fired_; }
  /// Which of them has fired most often, and how often: "'count', which has fired 12000 times".
  std::string BusiestRule() const;
  /// It may have about this many partial matches, or as many as it was allowed before if that is less.
  void AllowMatches(std::uint64_t most);
  /// It may grow to about this much memory; beyond that it breaks down.
  void AllowMemory(std::size_t bytes);
  /// The agent behind it is about to be destroyed: from here on, only what was noted remains.
  void Forget();
  sml::Agent& agent() { return *agent_; }
  /// What it did in this tick; empty unless it was asked for (MindSettings::detail).
  MindLog& log() { return log_; }
  const MindLog& log() const { return log_; }
  bool is_logged() const { return is_logged_; }
  /// How much is noted from now on.
  void SetDetail(MindDetail detail);

 private:
  struct Standing {
    std::uint64_t tag = 0;
    sml::FloatElement* progress = nullptr;
    int place = 0;      ///< On the output link, when that was last read.
    bool seen = false;  ///< Scratch: met in the present reading of the output link.
  };
  /// The command with that tag, or the place of the next one.
  std::vector<Standing>::iterator FindStanding(std::uint64_t tag);
  bool Stands(std::vector<Standing>::const_iterator at, std::uint64_t tag) const {
    return at != standing_.end() && at->tag == tag;
  }
  sml::Identifier* FindWord(const Standing& command) const;
  void ReadOutput();
  void NoteSaid(const vocabulary::SaidCommand& said);
  void NoteOutcome(std::string_view command, const Outcome& outcome);

  sml::Agent* agent_;
  sml::FloatElement* distance_ = nullptr;
  InputMirror own_body_, messages_, surroundings_, rows_;
  GraphMirror graph_;
  std::unique_ptr<SceneSense> scene_;  ///< Null if it does not imagine.
  std::uint32_t heard_ = 0;            ///< The number of the last message that it heard.
  std::string answer_;                 ///< The kernel's to the last run.
  std::uint64_t fired_ = 0;
  std::vector<vocabulary::SaidCommand> commands_;
  std::vector<std::uint64_t> withdrawn_;
  std::vector<Standing> standing_;  ///< By tag; there are few at a time.
  MindLog log_;
  bool is_logged_ = false;
  std::uint32_t own_match_limit_ = 0;  ///< What it was allowed by itself.
  std::uint32_t match_limit_ = 0;      ///< What AllowMatches set; 0: nothing.
  std::size_t memory_limit_ = 0;       ///< What AllowMemory set; 0: nothing.
  /// Where the output of the rules goes; the kernel knows its address.
  struct Writing;
  struct EndWriting {
    void operator()(Writing* writing) const;
  };
  std::unique_ptr<Writing, EndWriting> writing_;
};

}  // namespace soarbox::sim
