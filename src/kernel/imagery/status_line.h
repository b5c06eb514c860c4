// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <string>
#include <string_view>

#include "kernel/base/symbol.h"
#include "kernel/imagery/memory_writer.h"

namespace soarbox::kernel::imagery {

/// A ^status element of an identifier. The element changes only when its text changes.
class StatusLine {
 public:
  StatusLine(MemoryWriter& writer, Symbol owner)
      : writer_(writer), owner_(owner), shown_(owner ? writer.ValueOf(owner, "status") : Symbol()) {}
  /// The identifier; none for filters that are not visible to rules.
  Symbol owner() const { return owner_; }
  Symbol symbol() const { return shown_; }
  void Set(std::string_view text) {
    if (text_ == text) return;
    text_ = text;
    if (!owner_) return;
    if (shown_) writer_.Remove(owner_, "status", shown_);
    shown_ = writer_.Text(text);
    writer_.Add(owner_, "status", shown_);
  }

 private:
  MemoryWriter& writer_;
  Symbol owner_, shown_;
  std::string text_;
};

}  // namespace soarbox::kernel::imagery
