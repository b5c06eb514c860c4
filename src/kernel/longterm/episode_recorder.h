// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/longterm/episode_store.h"
#include "kernel/longterm/episode_terms.h"

namespace soarbox::kernel {

class GoalStack;
class SymbolTable;
class WorkingMemory;

/// Creates episodes from working memory: everything below the top state except excluded attributes. It records
/// additions and removals, so that an episode costs only as much as the changes since the last one.
///
/// An element is recorded if its identifier has a node and its attribute is not excluded. This is decided when the
/// element is new. (An excluded element is checked again when two or more elements of its object are new.) When an
/// object gets a node, all its elements are recorded. When no recorded element refers to an object any more, its node
/// is reused for the next object with the same parent and attribute. So objects that come and go at one place need no
/// more nodes.
class EpisodeRecorder {
 public:
  /// The parts of the agent that it uses.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    const SymbolTable& symbols;
  };
  EpisodeRecorder(const Uses& uses, EpisodeStore& store, EpisodeTerms& terms)
      : uses_(uses), store_(store), terms_(terms) {}

  /// The changes of working memory. Removed elements can still be read.
  void Flushed(std::span<const WmeId> added, std::span<const WmeId> removed);
  /// The object is now linked to another object of semantic memory.
  void LinkChanged(Symbol id);
  /// Creates the next episode.
  EpisodeNumber Record(std::span<const std::string> exclusions);
  /// Forgets the contents of working memory: the next episode starts again at the top state. The nodes of the store are
  /// reused.
  void Restart();
  bool recording() const { return recording_; }

 private:
  struct Added {
    WmeId wme = WmeId::kNone;
    std::uint64_t timetag = 0;
  };

  EpisodeNode NodeOf(Symbol id) const { return id.index() < node_of_.size() ? node_of_[id.index()] : kNoEpisodeNode; }
  bool IsNew(const Added& added) const;
  void TakeUp(WmeId wme, std::span<const std::string> exclusions);
  void TakeUpAll(Symbol id, std::span<const std::string> exclusions);
  EpisodeNode Place(EpisodeNode parent, EpisodeTerm attribute, Symbol object);
  void Bind(EpisodeNode node, Symbol object);
  /// An element refers to the node.
  void Refer(WmeId wme, EpisodeNode node);
  void Drop(WmeId wme);
  void DropNode(EpisodeNode node);
  void MakeFree(EpisodeNode node);
  void NoteFact(EpisodeFact fact);
  void DropStale();
  template <typename Visit>
  void ForEachElement(Symbol id, Visit visit) const;

  Uses uses_;
  EpisodeStore& store_;
  EpisodeTerms& terms_;
  bool recording_ = false;
  std::vector<EpisodeFact> fact_of_;  ///< By WmeId.
  std::vector<bool> refers_;          ///< By WmeId: it is counted in the references of its value's node.
  std::vector<EpisodeNode> node_of_;  ///< By identifier index.
  struct Node {
    Symbol object;                  ///< None: the node is free.
    std::uint32_t references = 0;   ///< Number of elements that refer to it.
    std::uint32_t news = 0;         ///< Number of new elements of its object while an episode is recorded.
    std::vector<EpisodeFact> ways;  ///< The facts with this node as their value.
  };
  std::vector<Node> nodes_;
  std::vector<Added> added_;
  std::size_t stale_check_at_ = 1024;
  std::vector<Symbol> found_;   ///< Objects that got a node and whose elements are not recorded yet.
  std::vector<WmeId> leaving_;  ///< Recorded elements that are being removed.
  /// Free nodes by the facts that referred to them.
  std::unordered_map<std::uint64_t, std::vector<EpisodeFact>> free_;
  std::vector<bool> listed_;  ///< By fact: it is in free_.
};

}  // namespace soarbox::kernel
