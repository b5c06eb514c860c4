// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/knowledge.h"

#include <algorithm>

namespace soarbox::kernel {

namespace {
constexpr std::size_t kManyEdges = 16;
}  // namespace

std::uint32_t Knowledge::FindOrAdd(Lti number) {
  const auto next = static_cast<std::uint32_t>(objects_.size());
  const std::uint32_t place = by_number_.FindOrAdd(number, next);
  if (place == next) objects_.push_back({number, {}});
  return place;
}

std::uint32_t Knowledge::AddNew() {
  while (by_number_.Find(next_number_) != kNowhere) ++next_number_;
  return FindOrAdd(next_number_++);
}

bool Knowledge::Has(std::uint32_t place, StoreTerm attribute, StoreTerm value) const {
  const std::vector<Edge>& edges = objects_[place].edges;
  if (edges.size() > kManyEdges) {
    // Whoever shares a value is often fewer than what an object has.
    const std::uint32_t list = FindList(attribute, value);
    if (list == kNowhere) return false;
    if (lists_[list].size() < edges.size()) {
      return std::ranges::any_of(lists_[list], [&](const Member& member) { return member.object == place; });
    }
  }
  return std::ranges::any_of(edges,
                             [&](const Edge& edge) { return edge.attribute == attribute && edge.value == value; });
}

bool Knowledge::Has(std::uint32_t place, StoreTerm attribute) const {
  return std::ranges::any_of(objects_[place].edges, [&](const Edge& edge) { return edge.attribute == attribute; });
}

void Knowledge::Enter(std::uint64_t key, Member member) {
  const auto next = static_cast<std::uint32_t>(lists_.size());
  const std::uint32_t list = lists_by_key_.FindOrAdd(key, next);
  if (list == next) lists_.emplace_back();
  lists_[list].push_back(member);
}

void Knowledge::Leave(std::uint64_t key, std::uint32_t row) {
  std::vector<Member>& list = lists_[lists_by_key_.Find(key)];
  const auto member = std::ranges::lower_bound(list, row, {}, &Member::row);
  list.erase(member);
}

bool Knowledge::AddEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value) {
  if (Has(place, attribute, value)) return false;
  const std::uint32_t row = next_row_++;
  objects_[place].edges.push_back({attribute, value, row});
  Enter(Key(attribute, value), {row, place});
  Enter(Key(attribute, StoreTerm()), {row, place});
  ++edge_count_;
  return true;
}

bool Knowledge::RemoveEdge(std::uint32_t place, StoreTerm attribute, StoreTerm value) {
  std::vector<Edge>& edges = objects_[place].edges;
  const auto found =
      std::ranges::find_if(edges, [&](const Edge& edge) { return edge.attribute == attribute && edge.value == value; });
  if (found == edges.end()) return false;
  Leave(Key(attribute, value), found->row);
  Leave(Key(attribute, StoreTerm()), found->row);
  edges.erase(found);
  --edge_count_;
  return true;
}

void Knowledge::RemoveEdges(std::uint32_t place) {
  while (!objects_[place].edges.empty()) {
    const Edge edge = objects_[place].edges.back();
    RemoveEdge(place, edge.attribute, edge.value);
  }
}

void Knowledge::Clear() {
  *this = Knowledge();
}

Knowledge Knowledge::Copy() const {
  Knowledge copy;
  copy.terms_ = terms_.Copy();
  copy.objects_ = objects_;
  copy.by_number_ = by_number_;
  copy.lists_by_key_ = lists_by_key_;
  copy.lists_ = lists_;
  copy.aliases_ = aliases_;
  copy.edge_count_ = edge_count_;
  copy.next_row_ = next_row_;
  copy.next_number_ = next_number_;
  return copy;
}

Lti Knowledge::FindAlias(std::string_view name) const {
  const auto found = aliases_.find(name);
  return found == aliases_.end() ? 0 : found->second;
}

std::size_t Knowledge::MemoryBytes() const {
  std::size_t bytes = terms_.MemoryBytes() + by_number_.MemoryBytes() + lists_by_key_.MemoryBytes() +
                      objects_.capacity() * sizeof(Object) + lists_.capacity() * sizeof(lists_[0]);
  for (const Object& object : objects_) bytes += object.edges.capacity() * sizeof(Edge);
  for (const std::vector<Member>& list : lists_) bytes += list.capacity() * sizeof(Member);
  return bytes;
}

std::string Knowledge::CheckInvariants() const {
  std::uint64_t edges = 0, members = 0;
  for (std::uint32_t place = 0; place < objects_.size(); ++place) {
    const std::string name = "@" + std::to_string(objects_[place].number);
    if (by_number_.Find(objects_[place].number) != place) return name + " is not found by its number";
    for (const Edge& edge : objects_[place].edges) {
      ++edges;
      for (const StoreTerm value : {edge.value, StoreTerm()}) {
        const std::uint32_t list = FindList(edge.attribute, value);
        if (list == kNowhere) return "an augmentation of " + name + " has no index";
        const auto member = std::ranges::lower_bound(lists_[list], edge.row, {}, &Member::row);
        if (member == lists_[list].end() || member->row != edge.row || member->object != place) {
          return "an augmentation of " + name + " is missing in an index";
        }
      }
    }
  }
  for (const std::vector<Member>& list : lists_) {
    members += list.size();
    if (!std::ranges::is_sorted(list, {}, &Member::row)) return "an index is out of order";
  }
  if (edges != edge_count_) return "augmentations are miscounted";
  return members == 2 * edges ? std::string() : "an index holds what no object has";
}

}  // namespace soarbox::kernel
