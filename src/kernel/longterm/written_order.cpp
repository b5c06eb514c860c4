// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/longterm/written_order.h"

#include <algorithm>

namespace soarbox::kernel {

std::uint32_t WrittenOrder::Read(std::string_view text, const SymbolTable& known) {
  const auto found = std::ranges::find(texts_, text, &Place::text);
  if (found != texts_.end()) {
    ++found->uses;
    return found->place;
  }
  Place made{text, 0, 1};
  if (!known.FindString(text)) {
    if (free_.empty()) {
      made.place = next_++;
    } else {
      made.place = free_.back();
      free_.pop_back();
    }
  }
  texts_.push_back(made);
  return made.place;
}

void WrittenOrder::Drop(std::string_view text) {
  const auto found = std::ranges::find(texts_, text, &Place::text);
  if (found == texts_.end() || --found->uses > 0) return;
  if (found->place != 0) free_.push_back(found->place);
  texts_.erase(found);
}

}  // namespace soarbox::kernel
