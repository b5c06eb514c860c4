// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

/// Reports whether the command of a state may have changed, so that a module reads commands only then. It watches the
/// identifiers in the commands. Each module has its own and must forward Flushed and IdentifierFreed to it.
class CommandWatch {
 public:
  /// From now on the elements of `id` belong to a command.
  void Watch(Symbol id) {
    if (id.index() >= watched_.size()) watched_.resize(id.index() + 1u, 0);
    watched_[id.index()] = 1;
  }
  void Flushed(const WmeTable& wmes, std::span<const WmeId> added, std::span<const WmeId> removed) {
    if (changed_) return;
    for (const std::span<const WmeId> list : {added, removed}) {
      for (const WmeId wme : list) {
        const std::uint32_t index = wmes[Index(wme)].id.index();
        if (index >= watched_.size() || watched_[index] == 0) continue;
        changed_ = true;
        return;
      }
    }
  }
  void IdentifierFreed(Symbol id) {
    if (id.index() < watched_.size()) watched_[id.index()] = 0;
  }
  /// A state is new, or its command has another identifier: commands must be read again.
  void Touch() { changed_ = true; }
  bool changed() const { return changed_; }
  /// Returns true once after a change.
  bool TakeChanged() { return std::exchange(changed_, false); }
  void Clear() {
    watched_.clear();
    changed_ = true;
  }

 private:
  std::vector<std::uint8_t> watched_;  ///< By identifier index.
  bool changed_ = true;
};

}  // namespace soarbox::kernel
