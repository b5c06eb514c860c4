// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/longterm/agent_parts.h"
#include "kernel/longterm/command_watch.h"
#include "kernel/longterm/episode_query.h"
#include "kernel/longterm/episode_store.h"
#include "kernel/longterm/episode_terms.h"
#include "kernel/longterm/episodic_settings.h"
#include "kernel/longterm/installer.h"

namespace soarbox::kernel {

/// Executes the commands that rules put on ^epmem.command of each state: ^retrieve, ^next, ^previous, ^query. A command
/// is executed once. When anything below it changes, its result is removed from ^epmem.result, and it is executed
/// again.
class EpisodeCommands {
 public:
  EpisodeCommands(const AgentParts& parts, const EpisodeStore& store, const EpisodeTerms& terms,
                  const EpisodicSettings& settings, EpisodicCounters& counters)
      : uses_(parts), store_(store), terms_(terms), settings_(settings), counters_(counters), installer_(parts) {}

  /// Executes new commands, the lowest state first. Returns true if working memory changed; then the caller must
  /// settle.
  bool Process();
  /// A state was created or removed, or init-soar ran.
  void StateMade() { watch_.Touch(); }
  void StateRemoved(GoalLevel level);
  /// The episodes have been replaced: ^next and ^previous have no starting point.
  void ForgetRetrieved();
  void Clear();
  void ForEachHeld(const std::function<void(PreferenceId)>& visit) const;
  CommandWatch& watch() { return watch_; }
  /// Prints each episode that a query found to be better than the earlier ones (`trace --epmem`).
  void SetTrace(bool on) { traced_ = on; }

 private:
  /// The command of a state, as last read.
  struct State {
    std::uint64_t newest = 0;  ///< Time tag.
    std::size_t count = 0;
    EpisodeNumber retrieved = 0;  ///< ^next and ^previous continue from it.
    std::vector<PreferenceId> made;
  };
  /// The elements below an object, breadth first.
  struct Reach {
    std::vector<Symbol> objects;
    struct Element {
      WmeId wme = WmeId::kNone;
      std::uint32_t object = 0;
      std::uint32_t value = 0;  ///< An object if the value is an identifier.
    };
    std::vector<Element> elements;
  };
  enum class Kind : std::uint8_t { kNone, kRetrieve, kNext, kPrevious, kQuery, kMalformed };
  struct Command {
    Kind kind = Kind::kNone;
    std::int64_t number = 0;    ///< ^retrieve
    Symbol argument, negative;  ///< ^query, ^next, ^previous; ^neg-query
    std::optional<std::int64_t> before, after;
    std::vector<EpisodeNumber> prohibited;
    bool refined = false;     ///< It has ^before, ^after or ^prohibit.
    bool is_counted = false;  ///< It counts as a query although its window is empty.
  };
  /// The elements to add to working memory.
  struct Output {
    std::vector<Triple> results, contents;
  };

  bool ProcessState(GoalLevel level);
  Reach ReachOf(Symbol root) const;
  Command Read(const Reach& reach) const;
  bool ReadElement(Command& command, Symbol attribute, Symbol value) const;
  void Execute(GoalLevel level, const Command& command, Output& output);
  void Query(GoalLevel level, const Command& command, Output& output);
  EpisodeCue CueOf(const Reach& reach) const;
  /// Adds the contents of an episode below a new identifier on ^retrieved. Returns the identifiers by node.
  std::vector<std::pair<EpisodeNode, Symbol>> Recall(GoalLevel level, EpisodeNumber episode, Output& output);
  /// Returns the cue's links to objects in the order in which Soar lists them. In Soar, this is the order of the memory
  /// addresses of the cue's elements, which each query allocates and frees. `places_` and `free_places_` simulate them.
  std::vector<std::uint32_t> ListingOrder(const EpisodeCue& positive, const EpisodeCue& negative);
  void Say(Output& output, GoalLevel level, const char* attribute, Symbol value) const;
  /// Reports the result of a command, with the reason, to observers.
  void Tell(GoalLevel level, EpisodeNumber episode, std::string_view question, std::string_view reason) const;
  void TellQuery(GoalLevel level, const Command& command, const EpisodeQuery& query, const EpisodeAnswer& answer) const;
  void TraceQuery(const EpisodeQuery& query) const;
  Symbol Word(const char* text) const;

  AgentParts uses_;
  const EpisodeStore& store_;
  const EpisodeTerms& terms_;
  const EpisodicSettings& settings_;
  EpisodicCounters& counters_;
  Installer installer_;
  CommandWatch watch_;
  std::vector<State> states_;  ///< By level, from 0.
  std::vector<std::uint32_t> free_places_;
  std::uint32_t places_ = 0;
  bool traced_ = false;
};

}  // namespace soarbox::kernel
