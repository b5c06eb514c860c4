// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

/// In which order the attributes of a clause of `smem --add` are met. In Soar 9.6.3 that is the order of the places
/// where its texts lie: a new text takes the place that became free last, or a new one behind all others, and when the
/// clause has been added its places become free again. What the agent knows anyway lies before all of them.
class WrittenOrder {
 public:
  /// Of a clause with more texts the order is that in which they are written.
  static constexpr std::size_t kMostTexts = 64;

  /// The next text of a clause: where it lies.
  std::uint32_t Read(std::string_view text, const SymbolTable& known);
  /// One of the texts that were read is not needed any more.
  void Drop(std::string_view text);

 private:
  struct Place {
    std::string_view text;
    std::uint32_t place = 0;  ///< 0: not ours.
    std::uint32_t uses = 0;
  };
  std::vector<Place> texts_;
  std::vector<std::uint32_t> free_;
  std::uint32_t next_ = 1;
};

}  // namespace soarbox::kernel
