// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <map>
#include <string>

namespace sml {

/// Objects by name, sorted by name. Does not own them.
template <typename Object>
class ObjectMap {
 public:
  void add(std::string const& name, Object object) { objects_[name] = object; }
  void remove(std::string const& name) { objects_.erase(name); }
  Object find(std::string const& name) const {
    auto found = objects_.find(name);
    return found == objects_.end() ? Object() : found->second;
  }
  bool contains(Object const& object) const {
    for (auto const& entry : objects_) {
      if (entry.second == object) return true;
    }
    return false;
  }
  Object getIndex(int index) const {
    for (auto const& entry : objects_) {
      if (index-- == 0) return entry.second;
    }
    return Object();
  }
  int size() const { return static_cast<int>(objects_.size()); }

 private:
  std::map<std::string, Object> objects_;
};

}  // namespace sml
