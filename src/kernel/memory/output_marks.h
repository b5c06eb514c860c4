// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// Which identifiers hung below the output link when it was last read, and whether an element of one of them has come
/// or gone since. Costs a test per element while nothing below the output link changes.
class OutputMarks {
 public:
  /// An element of this identifier comes or goes.
  void NoteChange(Symbol id) {
    if (IsMarked(id)) changed_ = true;
  }
  bool IsMarked(Symbol id) const { return id.index() < marks_.size() && marks_[id.index()] != 0; }
  void Mark(Symbol id) {
    if (marks_.size() <= id.index()) marks_.resize(id.index() + 1u, 0);
    marks_[id.index()] = 1;
  }
  void Unmark(Symbol id) {
    if (id.index() < marks_.size()) marks_[id.index()] = 0;
  }
  /// Whether something has changed since the last call.
  bool TakeChange() {
    const bool changed = changed_;
    changed_ = false;
    return changed;
  }
  void Clear() {
    marks_.clear();
    changed_ = false;
  }

 private:
  std::vector<std::uint8_t> marks_;  ///< By index of the identifier.
  bool changed_ = false;
};

}  // namespace soarbox::kernel
