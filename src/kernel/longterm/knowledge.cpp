// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/knowledge.h"

#include <algorithm>
#include <utility>

namespace soarbox::kernel {

namespace {
constexpr std::size_t kManyEdges = 16;
}  // namespace

Knowledge::Knowledge(std::shared_ptr<const Knowledge> base)
    : base_(std::move(base)),
      terms_(&base_->terms_),
      first_place_(base_->object_count()),
      first_row_(base_->next_row_),
      edge_count_(base_->edge_count_),
      next_row_(base_->next_row_),
      next_number_(base_->next_number_) {}

std::uint32_t Knowledge::FindOrAdd(Lti number) {
  if (base_ != nullptr) {
    if (const std::uint32_t known = base_->by_number_.Find(number); known != kNowhere) return known;
  }
  const std::uint32_t next = object_count();
  const std::uint32_t place = by_number_.FindOrAdd(number, next);
  if (place == next) objects_.push_back({number, {}});
  return place;
}

std::uint32_t Knowledge::AddNew() {
  SkipTakenNumbers();
  return FindOrAdd(next_number_++);
}

void Knowledge::SkipTakenNumbers() {
  while (Find(next_number_) != kNowhere) ++next_number_;
}

std::span<const Edge> Knowledge::InheritedEdgesAt(std::uint32_t place) const {
  const std::uint32_t changed = changed_.Find(place + 1ull);
  return changed == kNowhere ? base_->objects_[place].edges : changed_edges_[changed];
}

std::vector<Edge>& Knowledge::OwnEdgesAt(std::uint32_t place) {
  if (place >= first_place_) return objects_[place - first_place_].edges;
  const auto next = static_cast<std::uint32_t>(changed_edges_.size());
  const std::uint32_t changed = changed_.FindOrAdd(place + 1ull, next);
  if (changed == next) changed_edges_.push_back(base_->objects_[place].edges);
  return changed_edges_[changed];
}

void Knowledge::OrderEdgesAt(std::uint32_t place, std::vector<RankedEdge>& edges) const {
  edges.clear();
  for (const Edge& edge : EdgesAt(place)) edges.push_back({terms_.Order(edge.attribute), edge});
  const auto before = [this](const RankedEdge& a, const RankedEdge& b) {
    if (a.rank != b.rank) return a.rank < b.rank;
    const StoreTerm one = a.edge.value, other = b.edge.value;
    if (one.IsObject() != other.IsObject()) return one.IsObject();
    if (one.IsObject()) return NumberAt(one.index()) < NumberAt(other.index());
    return terms_.Order(one) < terms_.Order(other);
  };
  if (!std::ranges::is_sorted(edges, before)) std::ranges::sort(edges, before);
}

std::vector<Edge> Knowledge::OrderedEdgesAt(std::uint32_t place) const {
  std::vector<RankedEdge> ranked;
  OrderEdgesAt(place, ranked);
  std::vector<Edge> edges;
  edges.reserve(ranked.size());
  for (const RankedEdge& one : ranked) edges.push_back(one.edge);
  return edges;
}

std::size_t MemberList::FirstNotBefore(std::uint32_t row) const {
  // The rows of a layer are greater than all inherited ones.
  const auto first_in = [row](std::span<const Member> members) {
    return static_cast<std::size_t>(std::ranges::lower_bound(members, row, {}, &Member::row) - members.begin());
  };
  const std::size_t slot = first_in(inherited_);
  return slot < inherited_.size() ? slot : slot + first_in(own_);
}

MemberList Knowledge::ListAt(std::uint32_t list) const {
  if (base_ == nullptr) return {{}, lists_[list], 0, *this};
  if ((list & kInherited) != 0) return {base_->lists_[list & ~kInherited], {}, 0, *this};
  const Continued& continued = continued_[list];
  if (continued.list == kNowhere) return {{}, lists_[list], 0, *this};
  return {base_->lists_[continued.list], lists_[list], continued.hidden, *this};
}

bool Knowledge::Hides(const Member& member) const {
  const std::uint32_t changed = changed_.Find(member.object + 1ull);
  if (changed == kNowhere) return false;
  return std::ranges::find(changed_edges_[changed], member.row, &Edge::row) == changed_edges_[changed].end();
}

bool Knowledge::Has(std::uint32_t place, StoreTerm attribute, StoreTerm value) const {
  const std::span<const Edge> edges = EdgesAt(place);
  if (edges.size() > kManyEdges) {
    // The list of a value is often shorter than the list of an object's augmentations.
    const std::uint32_t list = FindList(attribute, value);
    if (list == kNowhere) return false;
    const MemberList members = ListAt(list);
    if (members.slots() < edges.size()) {
      bool has = false;
      members.ForEach([&](const Member& member) { has = has || member.object == place; });
      return has;
    }
  }
  return std::ranges::any_of(edges,
                             [&](const Edge& edge) { return edge.attribute == attribute && edge.value == value; });
}

bool Knowledge::Has(std::uint32_t place, StoreTerm attribute) const {
  return std::ranges::any_of(EdgesAt(place), [&](const Edge& edge) { return edge.attribute == attribute; });
}

std::uint32_t Knowledge::OwnList(std::uint64_t key) {
  const auto next = static_cast<std::uint32_t>(lists_.size());
  const std::uint32_t list = lists_by_key_.FindOrAdd(key, next);
  if (list == next) {
    lists_.emplace_back();
    if (base_ != nullptr) continued_.push_back({base_->lists_by_key_.Find(key), 0});
  }
  return list;
}

void Knowledge::Enter(std::uint64_t key, Member member) {
  lists_[OwnList(key)].push_back(member);
}

void Knowledge::Leave(std::uint64_t key, std::uint32_t row) {
  const std::uint32_t list = OwnList(key);
  if (row < first_row_) {
    ++continued_[list].hidden;
    return;
  }
  std::vector<Member>& members = lists_[list];
  members.erase(std::ranges::lower_bound(members, row, {}, &Member::row));
}

bool Knowledge::AddEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value) {
  if (Has(place, attribute, value)) return false;
  const std::uint32_t row = next_row_++;
  OwnEdgesAt(place).push_back({attribute, value, row});
  Enter(Key(attribute, value), {row, place});
  Enter(Key(attribute, StoreTerm()), {row, place});
  ++edge_count_;
  return true;
}

bool Knowledge::RemoveEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value) {
  const auto is_it = [&](const Edge& edge) { return edge.attribute == attribute && edge.value == value; };
  if (std::ranges::none_of(EdgesAt(place), is_it)) return false;
  std::vector<Edge>& edges = OwnEdgesAt(place);
  const auto found = std::ranges::find_if(edges, is_it);
  Leave(Key(attribute, value), found->row);
  Leave(Key(attribute, StoreTerm()), found->row);
  edges.erase(found);
  --edge_count_;
  return true;
}

void Knowledge::Clear() {
  *this = Knowledge();
}

Lti Knowledge::FindAlias(std::string_view name) const {
  const auto found = aliases_.find(name);
  if (found != aliases_.end()) return found->second;
  return base_ == nullptr ? 0 : base_->FindAlias(name);
}

std::map<std::string, Lti, std::less<>> Knowledge::Aliases() const {
  std::map<std::string, Lti, std::less<>> all = aliases_;
  if (base_ != nullptr) all.insert(base_->aliases_.begin(), base_->aliases_.end());
  return all;
}

std::size_t Knowledge::MemoryBytes() const {
  std::size_t bytes = sizeof(*this) + terms_.MemoryBytes() + by_number_.MemoryBytes() + lists_by_key_.MemoryBytes() +
                      objects_.capacity() * sizeof(Object) + lists_.capacity() * sizeof(lists_[0]) +
                      continued_.capacity() * sizeof(Continued) + changed_.MemoryBytes() +
                      changed_edges_.capacity() * sizeof(changed_edges_[0]);
  for (const Object& object : objects_) bytes += object.edges.capacity() * sizeof(Edge);
  for (const std::vector<Member>& list : lists_) bytes += list.capacity() * sizeof(Member);
  for (const std::vector<Edge>& edges : changed_edges_) bytes += edges.capacity() * sizeof(Edge);
  return bytes;
}

std::string Knowledge::CheckInvariants() const {
  std::uint64_t edges = 0, members = 0;
  for (std::uint32_t place = 0; place < object_count(); ++place) {
    const std::string name = "@" + std::to_string(NumberAt(place));
    if (Find(NumberAt(place)) != place) return name + " is not found by its number";
    for (const Edge& edge : EdgesAt(place)) {
      ++edges;
      for (const StoreTerm value : {edge.value, StoreTerm()}) {
        const std::uint32_t list = FindList(edge.attribute, value);
        if (list == kNowhere) return "an augmentation of " + name + " has no index";
        const MemberList all = ListAt(list);
        const std::size_t slot = all.FirstNotBefore(edge.row);
        if (slot == all.slots() || all.At(slot).row != edge.row || all.At(slot).object != place || all.IsHidden(slot)) {
          return "an augmentation of " + name + " is missing in an index";
        }
      }
    }
  }
  const auto check = [&](const MemberList& list) -> std::string {
    std::size_t counted = 0;
    for (std::size_t slot = 0; slot < list.slots(); ++slot) {
      if (slot > 0 && list.At(slot - 1).row > list.At(slot).row) return "an index is out of order";
      counted += list.IsHidden(slot) ? 0 : 1;
    }
    if (counted != list.size()) return "an index counts its hidden members wrongly";
    members += counted;
    return {};
  };
  for (std::uint32_t list = 0; list < lists_.size(); ++list) {
    if (std::string problem = check(ListAt(list)); !problem.empty()) return problem;
  }
  if (base_ != nullptr) {
    // Lists that the layer does not continue are unchanged.
    std::vector<bool> is_continued(base_->lists_.size());
    for (const Continued& continued : continued_) {
      if (continued.list != kNowhere) is_continued[continued.list] = true;
    }
    for (std::uint32_t list = 0; list < base_->lists_.size(); ++list) {
      if (is_continued[list]) continue;
      if (std::string problem = check(ListAt(list | kInherited)); !problem.empty()) return problem;
    }
  }
  if (edges != edge_count_) return "augmentations are miscounted";
  return members == 2 * edges ? std::string() : "an index contains an augmentation that no object has";
}

}  // namespace soarbox::kernel
