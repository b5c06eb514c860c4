// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

/// The order in which the attributes of a clause of `smem --add` are processed. In Soar 9.6.3 it is the order of the
/// memory addresses of the texts: a new text gets the block that was freed last, or a new block after all others. After
/// the clause has been added, its blocks are freed. Texts that the agent knows for other reasons come before all of
/// them.
class WrittenOrder {
 public:
  /// A clause with more texts keeps the order in which they are written.
  static constexpr std::size_t kMostTexts = 64;

  /// The place of the next text of a clause.
  std::uint32_t Read(std::string_view text, const SymbolTable& known);
  /// A text is no longer needed.
  void Drop(std::string_view text);

 private:
  struct Place {
    std::string_view text;
    std::uint32_t place = 0;  ///< 0: not in our order.
    std::uint32_t uses = 0;
  };
  std::vector<Place> texts_;
  std::vector<std::uint32_t> free_;
  std::uint32_t next_ = 1;
};

}  // namespace soarbox::kernel
