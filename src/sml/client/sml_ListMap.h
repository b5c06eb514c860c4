// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <list>
#include <map>

namespace sml {

/// A map from keys to ordered lists of values. A key whose list becomes empty is removed.
template <typename Key, typename Value>
class ListMap {
 public:
  typedef std::list<Value> ValueList;

  /// Returns true if this is the key's first value.
  bool add(Key const& key, Value value, bool addToBack = true) {
    ValueList& list = lists_[key];
    const bool first = list.empty();
    if (addToBack) {
      list.push_back(value);
    } else {
      list.push_front(value);
    }
    return first;
  }
  void remove(Key const& key, Value const& value) {
    auto found = lists_.find(key);
    if (found == lists_.end()) return;
    found->second.remove(value);
    if (found->second.empty()) lists_.erase(found);
  }
  /// Returns NULL if the key has no values.
  ValueList* getList(Key const& key) {
    auto found = lists_.find(key);
    return found == lists_.end() ? nullptr : &found->second;
  }
  int getListSize(Key const& key) {
    ValueList* list = getList(key);
    return list ? static_cast<int>(list->size()) : 0;
  }
  void clear() { lists_.clear(); }

 private:
  std::map<Key, ValueList> lists_;
};

}  // namespace sml
