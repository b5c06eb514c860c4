// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/symbol.h"

namespace soarbox::kernel {

/// Stores which identifiers were below the output link when it was last read. Detects whether one of their elements has
/// been added or removed since. While nothing below the output link changes, it costs one test per element.
class OutputMarks {
 public:
  /// An element of this identifier was added or removed.
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
  /// Returns whether something has changed since the last call.
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
  std::vector<std::uint8_t> marks_;  ///< By identifier index.
  bool changed_ = false;
};

}  // namespace soarbox::kernel
