// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/episode_recorder.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "kernel/base/symbol_table.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/memory/working_memory.h"

namespace soarbox::kernel {
namespace {

std::uint64_t PlaceKey(EpisodeNode parent, EpisodeTerm attribute) {
  return (std::uint64_t{parent} << 32) | attribute;
}

bool IsExcluded(std::span<const std::string> exclusions, std::string_view attribute) {
  return std::find(exclusions.begin(), exclusions.end(), attribute) != exclusions.end();
}

}  // namespace

/// Visits elements in the order in which they are recorded: input, the architecture's, then slots; each newest first.
template <typename Visit>
void EpisodeRecorder::ForEachElement(Symbol id, Visit visit) const {
  const WorkingMemory& memory = uses_.memory;
  const IdentifierRecord& object = memory.identifier(id);
  const auto list = [&](WmeId first) {
    for (WmeId wme = first; wme != WmeId::kNone;) {
      const WmeId next = memory.record(wme).next;
      visit(wme);
      wme = next;
    }
  };
  list(object.input_wmes);
  list(object.architecture_wmes);
  for (SlotId slot = object.slots; slot != SlotId::kNone; slot = memory.slot(slot).next) {
    list(memory.slot(slot).wmes);
    list(memory.slot(slot).acceptable_wmes);
  }
}

// Removals ------------------------------------------------------------------------------------------------------------

void EpisodeRecorder::Flushed(std::span<const WmeId> added, std::span<const WmeId> removed) {
  if (!recording_) return;
  for (const WmeId wme : added) {
    const Wme& element = uses_.memory.wme(wme);
    added_.push_back({wme, element.timetag});
    // An object that moves keeps its node: the new link is counted before the old one is removed.
    if (element.live && element.value.IsIdentifier()) Refer(wme, NodeOf(element.value));
  }
  for (const WmeId wme : removed) Drop(wme);
  if (added_.size() > stale_check_at_) DropStale();
}

void EpisodeRecorder::Refer(WmeId wme, EpisodeNode node) {
  if (node == kNoEpisodeNode) return;
  if (Index(wme) >= refers_.size()) refers_.resize(Index(wme) + std::size_t{1}, false);
  if (refers_[Index(wme)]) return;
  refers_[Index(wme)] = true;
  ++nodes_[node].references;
}

bool EpisodeRecorder::IsNew(const Added& added) const {
  const Wme& wme = uses_.memory.wme(added.wme);
  return wme.live && wme.timetag == added.timetag &&
         (Index(added.wme) >= fact_of_.size() || fact_of_[Index(added.wme)] == kNoEpisodeFact);
}

/// Drops notes about elements that no longer exist, because episodes may be far apart.
void EpisodeRecorder::DropStale() {
  std::erase_if(added_, [&](const Added& added) { return !IsNew(added); });
  stale_check_at_ = std::max<std::size_t>(1024, added_.size() * 2);
}

void EpisodeRecorder::Drop(WmeId wme) {
  leaving_.push_back(wme);
  while (!leaving_.empty()) {
    const WmeId left = leaving_.back();
    const std::uint32_t at = Index(left);
    leaving_.pop_back();
    if (at < fact_of_.size() && fact_of_[at] != kNoEpisodeFact) {
      store_.Release(fact_of_[at]);
      fact_of_[at] = kNoEpisodeFact;
    }
    if (at >= refers_.size() || !refers_[at]) continue;
    refers_[at] = false;
    const EpisodeNode node = NodeOf(uses_.memory.wme(left).value);
    if (node != kNoEpisodeNode && --nodes_[node].references == 0) DropNode(node);
  }
}

/// No element refers to the node any more: the recorded elements of its object are removed, too.
void EpisodeRecorder::DropNode(EpisodeNode node) {
  const Symbol object = nodes_[node].object;
  node_of_[object.index()] = kNoEpisodeNode;
  ForEachElement(object, [&](WmeId wme) {
    const bool is_recorded = Index(wme) < fact_of_.size() && fact_of_[Index(wme)] != kNoEpisodeFact;
    const bool refers = Index(wme) < refers_.size() && refers_[Index(wme)];
    if (is_recorded || refers) leaving_.push_back(wme);
  });
  MakeFree(node);
}

void EpisodeRecorder::MakeFree(EpisodeNode node) {
  nodes_[node].object = Symbol();
  for (const EpisodeFact way : nodes_[node].ways) {
    if (listed_[way]) continue;
    listed_[way] = true;
    const EpisodeTriple triple = store_.triple(way);
    free_[PlaceKey(triple.parent, triple.attribute)].push_back(way);
  }
}

// Additions -----------------------------------------------------------------------------------------------------------

void EpisodeRecorder::NoteFact(EpisodeFact fact) {
  if (fact < listed_.size()) return;
  listed_.resize(fact + std::size_t{1}, false);
  const EpisodeValue value = store_.triple(fact).value;
  if (!value.IsNode()) return;
  if (value.node() >= nodes_.size()) nodes_.resize(value.node() + std::size_t{1});
  nodes_[value.node()].ways.push_back(fact);
}

void EpisodeRecorder::Bind(EpisodeNode node, Symbol object) {
  if (node >= nodes_.size()) nodes_.resize(node + std::size_t{1});
  if (object.index() >= node_of_.size()) node_of_.resize(object.index() + std::size_t{1}, kNoEpisodeNode);
  nodes_[node].object = object;
  nodes_[node].references = 0;
  node_of_[object.index()] = node;
  found_.push_back(object);
  LinkChanged(object);
}

void EpisodeRecorder::LinkChanged(Symbol id) {
  const EpisodeNode node = NodeOf(id);
  const auto links = uses_.memory.long_term_identifiers();
  if (node != kNoEpisodeNode) store_.SetLink(node, id.index() < links.size() ? links[id.index()] : 0);
}

/// A node for an object that is new below this parent: a free one that was used with the same parent and attribute, or
/// a new one.
EpisodeNode EpisodeRecorder::Place(EpisodeNode parent, EpisodeTerm attribute, Symbol object) {
  EpisodeNode node = kNoEpisodeNode;
  if (const auto found = free_.find(PlaceKey(parent, attribute)); found != free_.end()) {
    std::vector<EpisodeFact>& ways = found->second;
    while (node == kNoEpisodeNode && !ways.empty()) {
      const EpisodeFact way = ways.back();
      ways.pop_back();
      listed_[way] = false;
      const EpisodeNode candidate = store_.triple(way).value.node();
      if (nodes_[candidate].object.IsNone()) node = candidate;
    }
  }
  if (node == kNoEpisodeNode) node = store_.NewNode();
  Bind(node, object);
  return node;
}

void EpisodeRecorder::TakeUp(WmeId wme, std::span<const std::string> exclusions) {
  const Wme& element = uses_.memory.wme(wme);
  if (!element.attribute.IsConstant()) return;
  if (element.attribute.IsString() && IsExcluded(exclusions, uses_.symbols.Text(element.attribute))) return;
  const EpisodeNode parent = node_of_[element.id.index()];
  const EpisodeTerm attribute =
      element.acceptable ? terms_.Intern("operator*") : terms_.Intern(uses_.symbols, element.attribute);
  EpisodeTriple triple{parent, attribute, {}};
  if (element.value.IsIdentifier()) {
    EpisodeNode node = NodeOf(element.value);
    if (node == kNoEpisodeNode) node = Place(parent, attribute, element.value);
    triple.value = EpisodeValue::Node(node);
  } else {
    triple.value = EpisodeValue::Constant(terms_.Intern(uses_.symbols, element.value));
  }
  const EpisodeFact fact = store_.Intern(triple);
  NoteFact(fact);
  store_.Hold(fact);
  if (triple.value.IsNode()) Refer(wme, triple.value.node());
  if (Index(wme) >= fact_of_.size()) fact_of_.resize(Index(wme) + std::size_t{1}, kNoEpisodeFact);
  fact_of_[Index(wme)] = fact;
}

void EpisodeRecorder::TakeUpAll(Symbol id, std::span<const std::string> exclusions) {
  ForEachElement(id, [&](WmeId wme) {
    if (Index(wme) >= fact_of_.size() || fact_of_[Index(wme)] == kNoEpisodeFact) TakeUp(wme, exclusions);
  });
}

EpisodeNumber EpisodeRecorder::Record(std::span<const std::string> exclusions) {
  if (!recording_) {
    recording_ = true;
    Bind(0, uses_.goals.top().id);
    nodes_[0].references = 1;  // The top state refers to itself.
  }
  // The newest objects are recorded first; the elements of an object in the order of its lists.
  std::erase_if(added_, [&](const Added& added) { return !IsNew(added); });
  for (const Added& added : added_) {
    const EpisodeNode parent = NodeOf(uses_.memory.wme(added.wme).id);
    if (parent != kNoEpisodeNode) ++nodes_[parent].news;
  }
  for (std::size_t n = added_.size(); n-- > 0;) {
    const Added& added = added_[n];
    const Symbol object = uses_.memory.wme(added.wme).id;
    const EpisodeNode parent = NodeOf(object);
    if (parent == kNoEpisodeNode) continue;
    const std::uint32_t news = std::exchange(nodes_[parent].news, 0);
    if (!IsNew(added)) continue;
    if (news > 1) {
      TakeUpAll(object, exclusions);
    } else {
      TakeUp(added.wme, exclusions);
    }
  }
  added_.clear();
  // found_ grows while objects are found in objects.
  for (std::size_t n = 0; n < found_.size(); ++n) TakeUpAll(found_[n], exclusions);
  found_.clear();
  return store_.Commit();
}

void EpisodeRecorder::Restart() {
  recording_ = false;
  store_.ReleaseAll();
  fact_of_.clear();
  refers_.clear();
  node_of_.clear();
  nodes_.assign(store_.node_count(), {});
  added_.clear();
  free_.clear();
  listed_.clear();
  // Every node is free. The nodes with the lowest numbers are reused first, because nodes are taken from the end of the
  // list.
  for (EpisodeFact fact = 0; fact < store_.fact_count(); ++fact) NoteFact(fact);
  for (std::size_t node = nodes_.size(); node-- > 1;) MakeFree(static_cast<EpisodeNode>(node));
}

}  // namespace soarbox::kernel
