// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "debugger/why.h"
#include "explain/inspector.h"
#include "explain/memory_facts.h"
#include "record/tick_record.h"

namespace soarbox::debugger {

/// A recall from long-term memory: what rules asked, the answer, and the reason for it.
struct Recall {
  std::uint64_t tick = 0;
  int level = 1;
  bool is_episode = false;
  std::uint64_t number = 0;  ///< Number of the object or the episode; 0 if nothing was found.
  std::string answer;        ///< For an object: some of its augmentations.
  std::string question;
  std::string reason;
};

/// The recalls of one agent. Add them tick by tick, live or from a recording.
class RecallLog {
 public:
  void Add(std::uint64_t tick, const record::MindRecord& mind);
  /// Removes everything from this tick on. Call it when the run went back.
  void CutFrom(std::uint64_t tick);
  const std::deque<Recall>& recalls() const { return recalls_; }  ///< The oldest first; the last 2,000.
  /// A copy with the recalls up to this tick.
  RecallLog Until(std::uint64_t tick) const;
  std::uint64_t count() const { return count_; }

 private:
  std::deque<Recall> recalls_;
  std::uint64_t count_ = 0;
};

/// An object of a remembered world that has a position.
struct RememberedThing {
  std::string name;  ///< "self" for the agent.
  std::string kind;  ///< The attribute that led to it: "agent", "object", "self".
  double x = 0, z = 0;
};

/// The contents of an agent's long-term memory.
struct LongTermView {
  explain::LongTermFacts facts;
  std::string note;  ///< A remark for the reader: no memory is switched on, or the kernel does not report it.
};

/// Shows objects that contain `text`; at most `most`.
LongTermView LookAtLongTerm(explain::Inspector& mind, const std::string& text = {}, std::size_t most = 200);

/// An episode as lines, such as "self.position.x 3", and the objects in it that have a position.
struct EpisodeView {
  std::size_t number = 0;                       ///< 0: there is no such episode.
  std::optional<double> time_s = std::nullopt;  ///< What the agent perceived as ^io.input-link.time, if it did.
  std::vector<std::string> lines;
  std::vector<RememberedThing> things;
};
EpisodeView LookAtEpisode(explain::Inspector& mind, std::size_t number);

/// Adds the last recalls to an answer of *Why*: what was found, what was asked, and the reason for the answer.
void TellRecalls(const RecallLog& log, WhyNode& answer);

std::string ToText(const LongTermView& view);
std::string ToText(const EpisodeView& view);
/// "@12 (^kind ammo) for ^kind <any>: the only one that fits".
std::string ToText(const Recall& recall);

}  // namespace soarbox::debugger
