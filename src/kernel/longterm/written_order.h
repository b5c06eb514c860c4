// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

/// The order in which the attributes of a clause of `smem --add` are met. In Soar 9.6.3 this is the order of the places
/// where its texts are: a new text takes the place freed last, or a new one after all others; after the clause has been
/// added, its places become free again. Texts that the agent knows anyway are before all of them.
class WrittenOrder {
 public:
  /// A clause with more texts keeps the order in which they are written.
  static constexpr std::size_t kMostTexts = 64;

  /// The place of the next text of a clause.
  std::uint32_t Read(std::string_view text, const SymbolTable& known);
  /// One of the texts that were read is no longer needed.
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
