// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mind/mind_record.h"
#include "sim/actor.h"
#include "sim/graph_mirror.h"
#include "sim/input_mirror.h"
#include "sim/percept_link.h"
#include "sim/scene_sense.h"
#include "vocabulary/command_check.h"

namespace sml {
class Agent;
class FloatElement;
class Identifier;
}  // namespace sml

namespace soarbox::sim {

using mind::MindDetail;

struct MindSettings {
  bool has_distance = true;               ///< It perceives the thesis' ^distance.
  bool blinks = true;                     ///< ^distance is a new element in each tick.
  bool waits = false;                     ///< It waits when no operator is proposed instead of creating substates,
                                          ///< unless a file of rules says otherwise (soar wait-snc off).
  bool imagines = false;                  ///< Its spatial visual system is on and receives what its body perceives.
  MindDetail detail = MindDetail::kNone;  ///< How much is recorded of what it does.
  bool origins = true;                    ///< If something is recorded: the kernel also records origins for *why*.
};

/// The mind of an agent as a Soar program. Its percepts are on its input link; each identifier directly on its output
/// link is a command.
///
/// Each command is reported once, however long it stays on the output link. The world adds its answer below the
/// command. Owned by the simulation; its kernel must outlive it.
class SoarMind {
 public:
  SoarMind(sml::Agent& agent, const MindSettings& settings);

  // Percepts. They are written at once; rules can match them in the next Decide.
  void SetDistance(float distance_squared_m2);
  /// Writes what the senses of its body report. `surroundings`: includes the surroundings.
  void Perceive(const Actor& body, bool surroundings);
  /// Writes all percepts that a sandbox's script returns.
  void ShowGraph(const script::PerceptGraph& percepts);
  void ShowRows(const vocabulary::PerceptList& percepts);

  /// Runs decisions until there is output or the decision budget (max-nil-output-cycles) is used up. commands() then
  /// contains the new commands on the output link, and withdrawn() the removed ones.
  /// `has_run`: another caller has already run the decisions.
  void Decide(bool has_run = false);
  std::span<const vocabulary::SaidCommand> commands() const { return commands_; }
  std::span<const std::uint64_t> withdrawn() const { return withdrawn_; }
  /// Whether a command is on the output link now.
  bool HasCommand(std::uint64_t tag) const {
    return std::ranges::any_of(standing_, [&](const Standing& one) { return one.tag == tag; });
  }
  /// Number of commands on the output link now, including completed ones.
  std::size_t standing() const { return standing_.size(); }
  /// Reports the outcome of a command to the program. Does nothing if the program has removed the command.
  void Answer(const Outcome& outcome);
  void Complete(std::uint64_t tag);

  /// Output of rules since the last call, as lines without blank ones. Of more than 64 KB, the rest is left out.
  std::vector<std::string> TakeWritten();
  /// Failed actions since the last call, at most a hundred. Always empty for a kernel in another process.
  std::vector<mind::RuleOutput::Failure> TakeFailures();

  /// Whether the program has halted. It does nothing until it is restarted.
  bool Halted() const;
  /// What used up the program's memory, in the kernel's words; empty if nothing did. The program cannot continue then.
  std::string_view Breakdown() const;
  /// Restarts the program: clears working memory and keeps the rules.
  void Restart();

  /// Its memory in bytes; 0 if the kernel is in another process.
  std::size_t MemoryBytes() const;
  /// Number of learned rules; 0 if the kernel is in another process.
  std::size_t LearnedRules() const;
  /// The rule from which most of them were learned, with their number: "478 of them from 'tour*look*note'".
  std::string MostLearnedFrom() const;
  /// Number of firings in the last Decide; 0 if the kernel is in another process.
  std::uint64_t fired() const { return fired_; }
  /// The rule that fired most often, with its number of firings: "'count', which has fired 12000 times".
  std::string BusiestRule() const;
  /// Limits the number of partial matches to about `most`, or to the agent's own limit if that is lower.
  void AllowMatches(std::uint64_t most);
  /// Limits its memory to about `bytes`; beyond that it breaks down.
  void AllowMemory(std::size_t bytes);
  /// Call it before its agent is destroyed. Only recorded events are available afterwards.
  void Forget();
  sml::Agent& agent() { return *agent_; }
  /// What it did in this tick; empty unless MindSettings::detail requests it.
  mind::MindRecord& record() { return *record_; }
  const mind::MindRecord& record() const { return *record_; }
  bool is_logged() const { return is_logged_; }
  /// Sets how much is recorded from now on. `origins` as in MindSettings; origins that are recorded already stay on.
  void SetDetail(MindDetail detail, bool origins);

 private:
  struct Standing {
    std::uint64_t tag = 0;
    sml::FloatElement* progress = nullptr;
    int place = 0;      ///< Index on the output link when that was last read.
    bool seen = false;  ///< Temporary: found in the present reading of the output link.
  };
  /// The command with this tag, or the position at which it would be inserted.
  std::vector<Standing>::iterator FindStanding(std::uint64_t tag);
  bool Stands(std::vector<Standing>::const_iterator at, std::uint64_t tag) const {
    return at != standing_.end() && at->tag == tag;
  }
  sml::Identifier* FindWord(const Standing& command) const;
  void ReadOutput();
  void NoteSaid(const vocabulary::SaidCommand& said);
  void NoteOutcome(std::string_view command, const Outcome& outcome);

  sml::Agent* agent_;
  std::unique_ptr<PerceptLink> link_;       ///< Of distance_ and the mirrors.
  std::unique_ptr<PerceptSlots> distance_;  ///< One slot: the thesis' ^distance. Null if it does not perceive it.
  InputMirror own_body_, messages_, surroundings_, rows_;
  std::unique_ptr<GraphMirror> graph_;
  bool blinks_ = true;                 ///< See MindSettings.
  std::unique_ptr<SceneSense> scene_;  ///< Null if it does not imagine.
  std::uint32_t heard_ = 0;            ///< Number of the last message that it received.
  std::string answer_;                 ///< The kernel's answer to the last run.
  std::uint64_t fired_ = 0;
  std::vector<vocabulary::SaidCommand> commands_;
  std::vector<std::uint64_t> withdrawn_;
  std::vector<Standing> standing_;  ///< Sorted by tag; usually few.
  std::unique_ptr<mind::MindRecord> record_ = std::make_unique<mind::MindRecord>();
  bool is_logged_ = false;
  std::uint32_t own_match_limit_ = 0;  ///< The agent's own limit.
  std::uint32_t match_limit_ = 0;      ///< The limit that AllowMatches has set; 0: none.
  std::size_t memory_limit_ = 0;       ///< The limit that AllowMemory has set; 0: none.
  std::unique_ptr<mind::RuleOutput> output_ = std::make_unique<mind::RuleOutput>();
  mind::CommandSaid said_;  ///< Scratch of NoteSaid.
  /// Fill record_ and output_.
  struct Observations;
  struct EndObservations {
    void operator()(Observations* observations) const;
  };
  std::unique_ptr<Observations, EndObservations> observations_;
};

}  // namespace soarbox::sim
