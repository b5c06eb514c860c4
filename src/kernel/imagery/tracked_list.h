// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <list>
#include <memory>
#include <utility>
#include <vector>

namespace soarbox::kernel::imagery {

/// What a TrackedList knows of each of its entries; entries derive from it.
template <typename Entry>
struct Tracked {
  bool fresh = true;     ///< Came since the changes were cleared.
  bool changed = false;  ///< Is on the list of those that changed since.
  typename std::list<std::unique_ptr<Entry>>::iterator place;
};

/// A list in order of arrival that remembers what came, changed and went since its one reader looked last.
template <typename Entry>
class TrackedList {
 public:
  using List = std::list<std::unique_ptr<Entry>>;

  const List& entries() const { return entries_; }
  /// Those that came stand at the end, from here on.
  typename List::const_iterator FirstFresh() const { return first_fresh_; }
  const std::vector<Entry*>& changed() const { return changed_; }
  /// Gone, and still to be read until the changes are cleared. A fresh entry that went is here, too.
  const List& removed() const { return removed_; }
  bool HasChanges() const { return first_fresh_ != entries_.end() || !changed_.empty() || !removed_.empty(); }

  TrackedList() = default;
  TrackedList(const TrackedList&) = delete;
  TrackedList& operator=(const TrackedList&) = delete;

  Entry& Add(std::unique_ptr<Entry> entry) {
    entries_.push_back(std::move(entry));
    Entry& added = *entries_.back();
    added.place = std::prev(entries_.end());
    if (first_fresh_ == entries_.end()) first_fresh_ = added.place;
    return added;
  }
  void Change(Entry& entry) {
    if (entry.fresh || entry.changed) return;
    entry.changed = true;
    changed_.push_back(&entry);
  }
  void Remove(Entry& entry) {
    if (entry.changed) std::erase(changed_, &entry);
    if (first_fresh_ == entry.place) ++first_fresh_;
    removed_.splice(removed_.end(), entries_, entry.place);
  }
  void ClearChanges() {
    for (auto at = first_fresh_; at != entries_.end(); ++at) (*at)->fresh = false;
    first_fresh_ = entries_.end();
    for (Entry* const entry : changed_) entry->changed = false;
    changed_.clear();
    removed_.clear();
  }
  /// The reader begins anew: everything is fresh.
  void Restart() {
    ClearChanges();
    first_fresh_ = entries_.begin();
    for (const auto& entry : entries_) entry->fresh = true;
  }
  void Clear() {
    changed_.clear();
    removed_.clear();
    entries_.clear();
    first_fresh_ = entries_.end();
  }

 private:
  List entries_, removed_;
  typename List::iterator first_fresh_ = entries_.end();
  std::vector<Entry*> changed_;
};

}  // namespace soarbox::kernel::imagery
