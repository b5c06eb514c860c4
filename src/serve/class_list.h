// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "diagnostics/result.h"
#include "serve/place.h"

namespace soarbox::serve {

/// A class: learners with one place each, and a key for its teachers.
class ClassList {
 public:
  struct Learner {
    std::string name, place;
  };
  /// Reads names from the file `names`, one per line, and creates places for learners that have none. Stores the key
  /// and the places in the folder `state`, so that links stay the same after a restart. An error names the file and
  /// line.
  static Result<ClassList> Read(const std::filesystem::path& names, const std::filesystem::path& state, Places& places);
  /// An empty list means that there is no class.
  ClassList() = default;
  /// A class without learners, to which Add adds them.
  static ClassList WithKey(std::string key);
  void Add(Learner learner) { learners_.push_back(std::move(learner)); }
  void Remove(std::string_view place);

  const std::vector<Learner>& learners() const { return learners_; }
  const std::string& key() const { return key_; }
  bool IsKey(std::string_view given) const;
  /// The learner who has this place; empty if no learner of the class has it.
  std::string NameOf(std::string_view place) const;
  bool empty() const { return learners_.empty(); }

 private:
  std::vector<Learner> learners_;
  std::string key_;
};

}  // namespace soarbox::serve
