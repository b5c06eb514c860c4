// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/json.h"
#include "debugger/why.h"
#include "explain/inspector.h"
#include "explain/memory_facts.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// What rules asked of long-term memory, the answer, and the reason for it.
struct Recall {
  std::uint64_t tick = 0;
  int level = 1;
  bool is_episode = false;
  std::uint64_t number = 0;  ///< Of the object or the episode; 0: nothing came.
  std::string answer;        ///< Of an object some augmentations.
  std::string question;
  std::string reason;
};

/// The recalls of one agent, fed tick by tick, live or from a recording.
class RecallLog {
 public:
  void Add(std::uint64_t tick, const record::MindRecord& mind);
  /// Forgets what came from this tick on: the run went back.
  void CutFrom(std::uint64_t tick);
  const std::deque<Recall>& recalls() const { return recalls_; }  ///< The oldest first; the last 2,000.
  /// Those up to this tick.
  RecallLog Until(std::uint64_t tick) const;
  std::uint64_t count() const { return count_; }

 private:
  std::deque<Recall> recalls_;
  std::uint64_t count_ = 0;
};

/// A thing of a remembered world, with a place in it.
struct RememberedThing {
  std::string name;  ///< "self" of the agent itself.
  std::string kind;  ///< The attribute that led to it: "agent", "object", "self".
  double x = 0, z = 0;
};

/// What an agent has in long-term memory.
struct LongTermView {
  explain::LongTermFacts facts;
  std::string note;  ///< What a reader should know: nothing is switched on, not told there.
};

/// Of known objects with this text.
LongTermView LookAtLongTerm(explain::Inspector& mind, const std::string& text = {}, std::size_t most = 200);

/// An episode as lines: "self.position.x 3", and the things in it that have a place.
struct EpisodeView {
  std::size_t number = 0;                       ///< 0: there is no such episode.
  std::optional<double> time_s = std::nullopt;  ///< What the agent perceived as ^io.input-link.time, if it did.
  std::vector<std::string> lines;
  std::vector<RememberedThing> things;
};
EpisodeView LookAtEpisode(explain::Inspector& mind, std::size_t number);

/// Adds what was recalled last to an answer of *Why*: what came, for which question, and why that.
void TellRecalls(const RecallLog& log, WhyNode& answer);

std::string ToText(const LongTermView& view);
Json ToJson(const LongTermView& view);
std::string ToText(const EpisodeView& view);
Json ToJson(const EpisodeView& view);
/// "@12 (^kind ammo) for ^kind <any>: the only one that fits".
std::string ToText(const Recall& recall);
Json ToJson(const Recall& recall);

}  // namespace soarbox::debugger
