// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/percept.h"

namespace soarbox::sim {

/// What one mind did in a tick, in words.
struct MindWords {
  /// What changed on the input link: "path value", or "-path" for what has gone. Paths are attributes joined by dots;
  /// "agent#3" is the one of several with that key.
  std::vector<std::string> percepts;
  /// "O: O1 (seek)", "==>S: S2 (operator tie)", "<==S: S2" with three blanks per level of the goal stack. A program
  /// that waits in a state (soar wait-snc) tells that once. A kernel in another process, or one that is not ours, does
  /// not tell them, nor details.
  std::vector<std::string> decisions;
  /// "fire RULE", "retract RULE", "+ 12: S1 ^a b", "- 12: S1 ^a b", after a count of the decisions before it: they
  /// stand between decisions[count - 1] and decisions[count].
  std::vector<std::string> details;
  /// "move-to ^waypoint gate", and how commands went: "move-to: complete".
  std::vector<std::string> commands;
  /// For each of the decisions: why it was taken ("the only operator proposed, by rule RULE"), or nothing.
  std::vector<std::string> reasons;
  /// For each of the commands: the rule that made it, where that is known and it is a command.
  std::vector<std::string> command_rules;
};

/// What one mind did in a tick, as it was noted: bytes that are quick to add to while the mind runs, and quick to copy.
/// Words are made of them afterwards, by whoever wants them and on any thread.
class MindNotes {
 public:
  void Clear() { used_ = 0; }
  bool empty() const { return used_ == 0; }
  /// What the notes take; grows with each of them.
  std::size_t bytes() const { return used_; }

  /// A constant of the input link has come or changed. `path`: that of its object, with a dot behind it, or nothing.
  void NotePercept(std::string_view path, const Percept& constant);
  void NoteNumber(std::string_view path, std::string_view attribute, std::uint32_t key, double value);
  void NotePerceptGone(std::string_view path, std::string_view attribute, std::uint32_t key);
  /// Something said, with its time tag.
  void NoteCommand(std::string_view command, std::uint64_t tag);
  /// How it went: "complete"; "error", with a reason.
  void NoteOutcome(std::string_view command, std::string_view how, std::string_view reason = {});
  /// A rule has made an element of the output link, which may be a command.
  void NoteRuleOfCommand(std::uint64_t tag, std::string_view rule);

  // Decisions; levels count from 1.
  void NoteOperator(int level, std::string_view id, std::string_view name);
  void NoteState(int level, std::string_view state, std::string_view impasse, std::string_view attribute);
  void NoteStateGone(int level, std::string_view state);
  void NoteHalt();
  /// What long-term memory answered: "recall @12 {^kind ammo ^site @3} for {^kind ammo}" among the decisions, "episode
  /// 7" for @12 if it is one, "no fact" or "no episode" where nothing came. NoteReason says why.
  void NoteRecall(int level, bool is_episode, std::uint64_t number, std::string_view question, std::string_view answer);
  /// A rule was learned: "learn chunk*name" among the decisions. NoteReason says from what.
  void NoteLearned(int level, std::string_view rule);
  /// Learning by reward, also among them: "value rule 1.5", "reward -2", "episode ends".
  void NoteValue(std::string_view rule, double value);
  void NoteReward(double reward);
  void NoteEpisodeEnd();
  /// Of the last decision, in words.
  void NoteReason(std::string_view reason);
  /// Of the last decision: what the decision procedure said, packed (mind/decision_codec.h).
  void NoteDecided(std::string_view decision);

  // Details.
  void NoteFiring(std::string_view rule, bool retracts);
  void NoteElement(bool added, std::uint64_t tag, std::string_view id, std::string_view attribute,
                   std::string_view value, bool acceptable);

  /// The words; without details they are left out.
  MindWords Words(bool with_details = true) const;

  enum class Kind : std::uint8_t {
    kInteger,  ///< Percepts by the type of their value: path, attribute; a text's value is the third text.
    kFloat,
    kText,
    kGone,
    kCommand,  ///< "move-to ^waypoint gate"; the number is its time tag.
    kOutcome,  ///< Command, how it went, reason.
    kRuleOfCommand,
    kOperator,  ///< The number is the level; id, name.
    kState,     ///< State, impasse, attribute; the number is the level.
    kStateGone,
    kHalt,
    kReason,
    kDecided,  ///< Of the last decision: bytes.
    kRecall,   ///< What came ("@12"), the question, the answer; the number is the level.
    kLearned,  ///< Rule; the number is the level.
    kValue,    ///< Rule; the number is the value's bits.
    kReward,   ///< The number is its bits.
    kEpisodeEnd,
    kFire,
    kRetract,
    kAdded,  ///< Id, attribute, value; a key of one: acceptable.
    kRemoved,
  };
  /// One of the notes, for whoever wants no words.
  struct View {
    Kind kind = Kind::kHalt;
    std::uint64_t number = 0;
    std::string_view first, second, third;
    std::uint32_t key = 0;
  };
  /// Reads the note at this place, 0 for the first, and moves on; false behind the last.
  bool Next(std::size_t& at, View& view) const;

 private:
  struct Head;
  void Add(Kind kind, std::uint64_t number, std::string_view first = {}, std::string_view second = {},
           std::string_view third = {}, std::uint32_t key = 0);

  std::string bytes_;  ///< Heads, each with its texts behind it: the first used_ bytes.
  std::size_t used_ = 0;
};

/// "agent", or "agent#3" for the one of several with that key.
std::string NameOfPercept(std::string_view attribute, std::uint32_t key);

}  // namespace soarbox::sim
