// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <new>
#include <string>
#include <string_view>

#include "kernel/base/symbol_table.h"

namespace soarbox::kernel::function_bodies {

/// A text that a function builds before it becomes a symbol: on the stack while it is short, then on the heap.
class ShortText {
 public:
  ShortText() = default;
  ShortText(const ShortText&) = delete;
  ShortText& operator=(const ShortText&) = delete;

  void Append(std::string_view piece) {
    if (!long_.empty() || piece.size() > kRoom - size_) {
      AppendLong(piece);
      return;
    }
    piece.copy(room_ + size_, piece.size());
    size_ += piece.size();
  }

  /// Appends the symbol in the format of (write ...).
  void Append(const SymbolTable& symbols, Symbol symbol) {
    if (symbol.IsString()) {
      Append(symbols.Text(symbol));
    } else if (symbol.IsInteger() && long_.empty() && kRoom - size_ >= kLongestInteger) {
      size_ = static_cast<std::size_t>(std::to_chars(room_ + size_, room_ + kRoom, symbols.IntegerValue(symbol)).ptr -
                                       room_);
    } else {
      Append(ToString(symbols, symbol, false));
    }
  }

  std::string_view view() const { return long_.empty() ? std::string_view(room_, size_) : std::string_view(long_); }
  std::string str() const { return std::string(view()); }

 private:
  static constexpr std::size_t kRoom = 256;
  static constexpr std::size_t kLongestInteger = 20;
  /// Maximum length. A longer text is assumed to grow without end, so it counts as out of memory.
  static constexpr std::size_t kLongest = std::size_t{64} << 20;

  [[gnu::noinline]] void AppendLong(std::string_view piece) {
    if (piece.size() > kLongest - std::max(long_.size(), size_)) throw std::bad_alloc();
    if (long_.empty()) long_.assign(room_, size_);
    long_ += piece;
  }

  std::size_t size_ = 0;  ///< The size of the text in room_.
  char room_[kRoom];
  std::string long_;  ///< The entire text once it does not fit room_ any more.
};

}  // namespace soarbox::kernel::function_bodies
