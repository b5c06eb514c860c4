// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "cli/object_printer.h"
#include "kernel/agent.h"
#include "kernel/base/known_symbols.h"

namespace soarbox::server {

/// The text of an identifier ("S1"), built in place.
class IdentifierText {
 public:
  IdentifierText(const kernel::Agent& agent, kernel::Symbol symbol) {
    if (!symbol.IsIdentifier()) {
      other_ = cli::SymbolText(agent, symbol);
      return;
    }
    text_[0] = agent.symbols().Letter(symbol);
    const char* const end = std::to_chars(text_ + 1, text_ + sizeof text_, agent.symbols().Number(symbol)).ptr;
    size_ = static_cast<std::size_t>(end - text_);
  }
  std::string_view view() const { return size_ == 0 ? std::string_view(other_) : std::string_view(text_, size_); }

 private:
  char text_[24] = {};
  std::size_t size_ = 0;
  std::string other_;  ///< For operators that are constants.
};

/// A cache of printed names. The same few names are used again and again, and finding out whether a name needs bars is
/// slow.
class PrintedNames {
 public:
  /// Valid until the next call.
  std::string_view Of(const kernel::Agent& agent, kernel::Symbol symbol) {
    if (!symbol.IsString()) return other_ = cli::SymbolText(agent, symbol);
    Entry& entry = entries_[symbol.index() % entries_.size()];
    // The symbol may have been swept, and its handle reused by one created later.
    const std::uint32_t stamp = agent.symbols().Stamp(symbol);
    if (entry.symbol != symbol || entry.stamp != stamp) entry = {symbol, stamp, cli::SymbolText(agent, symbol)};
    return entry.printed;
  }
  /// The operator's ^name; empty if it has none. Valid until the next call for a name.
  std::string_view NameOfOperator(const kernel::Agent& agent, kernel::Symbol op) {
    if (!op.IsIdentifier()) return {};
    const kernel::Symbol value = agent.memory().ValueOf(op, kernel::words::kName);
    return value ? Of(agent, value) : std::string_view();
  }

 private:
  struct Entry {
    kernel::Symbol symbol;
    std::uint32_t stamp = 0;
    std::string printed;
  };
  std::array<Entry, 8> entries_;
  std::string other_;
};

}  // namespace soarbox::server
