// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/base/plain_vector.h"
#include "kernel/longterm/episode_intervals.h"

namespace soarbox::kernel {

/// An object in episodes. 0 is the top state.
using EpisodeNode = std::uint32_t;
/// A triple that was true in some episode. Numbered from 0 without gaps; never removed.
using EpisodeFact = std::uint32_t;
/// A constant in episodes: an attribute or a value (see EpisodeTerms).
using EpisodeTerm = std::uint32_t;

inline constexpr EpisodeNode kNoEpisodeNode = 0x7FFFFFFF;
inline constexpr EpisodeFact kNoEpisodeFact = 0x7FFFFFFF;
/// A term that is in no episode and therefore matches nothing.
inline constexpr EpisodeTerm kUnknownEpisodeTerm = 0x7FFFFFFF;

/// The third part of a fact: a constant or a node.
class EpisodeValue {
 public:
  constexpr EpisodeValue() = default;
  static constexpr EpisodeValue Constant(EpisodeTerm term) { return EpisodeValue(term); }
  static constexpr EpisodeValue Node(EpisodeNode node) { return EpisodeValue(node | kNodeBit); }
  static constexpr EpisodeValue FromBits(std::uint32_t bits) { return EpisodeValue(bits); }

  constexpr bool IsNode() const { return (bits_ & kNodeBit) != 0; }
  constexpr EpisodeNode node() const { return bits_ & ~kNodeBit; }
  constexpr EpisodeTerm term() const { return bits_; }
  constexpr std::uint32_t bits() const { return bits_; }

  friend constexpr bool operator==(EpisodeValue, EpisodeValue) = default;

 private:
  static constexpr std::uint32_t kNodeBit = 0x80000000u;
  explicit constexpr EpisodeValue(std::uint32_t bits) : bits_(bits) {}

  std::uint32_t bits_ = 0;
};

struct EpisodeTriple {
  EpisodeNode parent = 0;
  EpisodeTerm attribute = 0;
  EpisodeValue value;

  friend bool operator==(const EpisodeTriple&, const EpisodeTriple&) = default;
};

/// All episodes of an agent as facts about nodes: for each fact the intervals of episodes in which it was true, and a
/// log of the changes between episodes, with key frames.
///
/// Storing an episode costs as much as its changes. A key frame is written after as many changes as there are true
/// facts. So frames at most double the log, and any episode can be computed in time proportional to its size.
///
/// Invariants: the intervals of a fact are sorted, disjoint and not adjacent. A fact is open exactly if it was true in
/// the newest episode. Replay of an episode returns the facts whose intervals contain it.
class EpisodeStore {
 public:
  EpisodeStore() { Clear(); }

  // Recording -------------------------------------------------------------------------------------------------------

  /// A node without facts.
  EpisodeNode NewNode() { return node_count_++; }
  /// The fact of a triple; created if it is new.
  EpisodeFact Intern(const EpisodeTriple& triple);
  /// Adds or removes one reason why the fact is true in the next episode.
  void Hold(EpisodeFact fact);
  void Release(EpisodeFact fact);
  /// From the next episode on, the node is linked to the object with this number in semantic memory; 0: to none.
  void SetLink(EpisodeNode node, std::uint64_t lti);
  /// Creates the next episode from the facts that are true now.
  EpisodeNumber Commit();
  /// The changes of the last Commit: twice the fact, plus one if it became true.
  std::span<const std::uint32_t> LastChanges() const;
  bool IsHeld(EpisodeFact fact) const { return now_[fact].holders != 0; }
  /// Makes all facts false, because the objects were removed (init-soar). The next Commit records this.
  void ReleaseAll();
  void Clear();

  // Reading ---------------------------------------------------------------------------------------------------------

  EpisodeNumber last() const { return static_cast<EpisodeNumber>(begins_.size() - 1); }
  std::size_t fact_count() const { return facts_.size(); }
  EpisodeNode node_count() const { return node_count_; }
  EpisodeTriple triple(EpisodeFact fact) const {
    const Fact& f = facts_[fact];
    return {f.parent, f.attribute, f.value};
  }
  /// The fact of a triple, or kNoEpisodeFact.
  EpisodeFact Find(const EpisodeTriple& triple) const;
  /// The facts with this parent and attribute whose value is a node, in order of creation.
  std::span<const EpisodeFact> Children(EpisodeNode parent, EpisodeTerm attribute) const;
  /// The latest episode up to `episode` in which the fact was true; 0 if there is none. `episode` must exist.
  EpisodeNumber Latest(EpisodeFact fact, EpisodeNumber episode) const {
    const Fact& f = facts_[fact];
    return f.open != 0 && f.open <= episode ? episode : LatestClosed(f, episode);
  }
  bool Holds(EpisodeFact fact, EpisodeNumber episode) const { return Latest(fact, episode) == episode; }
  /// The first episode since which the fact has been true (or false) without change up to `episode`.
  EpisodeNumber SameSince(EpisodeFact fact, EpisodeNumber episode) const;
  /// The facts of an episode in unspecified order. The episode must exist.
  std::vector<EpisodeFact> Replay(EpisodeNumber episode) const;
  /// The node's object in semantic memory in this episode; 0: none.
  std::uint64_t Link(EpisodeNode node, EpisodeNumber episode) const;
  /// The links that were set in this episode, in order.
  std::vector<std::pair<EpisodeNode, std::uint64_t>> LinksOf(EpisodeNumber episode) const;
  /// The closed intervals of a fact. The open one, if any, begins at OpenSince.
  std::span<const EpisodeInterval> Intervals(EpisodeFact fact) const { return intervals_.Of(facts_[fact].intervals); }
  EpisodeNumber OpenSince(EpisodeFact fact) const { return facts_[fact].open; }
  /// The changes from the previous episode to this one.
  std::span<const std::uint32_t> ChangesOf(EpisodeNumber episode) const;

  std::size_t MemoryBytes() const;
  /// Returns a description of the first violated invariant, or an empty text. Slow: walks all data.
  const char* CheckInvariants() const;

 private:
  struct Fact {
    EpisodeNode parent = 0;
    EpisodeTerm attribute = 0;
    EpisodeValue value;
    EpisodeNumber open = 0;  ///< True since this episode; 0: not true in the newest episode.
    EpisodeIntervals::List intervals;
  };
  /// Data that only recording needs.
  struct Now {
    std::uint32_t holders = 0;
    std::uint32_t live_at : 31 = 0;  ///< Its index in live_ while it is open.
    std::uint32_t touched : 1 = 0;   ///< It is in touched_.
  };
  struct Frame {
    EpisodeNumber episode = 0;
    std::size_t begin = 0, end = 0;  ///< Range in frame_facts_.
  };
  struct Link_ {
    EpisodeNumber from = 0;
    std::uint64_t lti = 0;
  };
  struct SetLink_ {
    EpisodeNumber from = 0;
    EpisodeNode node = 0;
    std::uint64_t lti = 0;
  };

  void Touch(EpisodeFact fact);
  void Log(EpisodeFact fact, bool comes);
  void WriteFrameIfDue();
  EpisodeNumber LatestClosed(const Fact& fact, EpisodeNumber episode) const;
  static std::size_t HashOf(const EpisodeTriple& triple);
  void Rehash();

  PlainVector<Fact> facts_;
  PlainVector<Now> now_;
  EpisodeIntervals intervals_;
  PlainVector<std::uint32_t> by_content_;  ///< Open addressing: fact + 1, or 0.
  std::unordered_map<std::uint64_t, std::vector<EpisodeFact>> children_;
  PlainVector<std::uint32_t> changes_;
  PlainVector<std::uint32_t> begins_;  ///< By episode - 1: where its changes begin. One extra entry at the end.
  PlainVector<EpisodeFact> frame_facts_;
  std::vector<Frame> frames_;
  std::size_t changes_since_frame_ = 0;
  std::vector<EpisodeFact> touched_;
  std::vector<EpisodeFact> live_;
  std::unordered_map<EpisodeNode, std::vector<Link_>> links_;
  std::vector<SetLink_> set_links_;  ///< In order.
  EpisodeNode node_count_ = 1;
};

}  // namespace soarbox::kernel
