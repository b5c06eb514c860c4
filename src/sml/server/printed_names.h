// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <charconv>
#include <cstddef>
#include <string>
#include <string_view>

#include "cli/object_printer.h"
#include "kernel/agent.h"

namespace soarbox::server {

/// "S1", made in place.
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
  std::string other_;  ///< Of operators that are constants.
};

/// Names as they are printed. The same few come again and again, and it takes a while to see whether one needs bars.
class PrintedNames {
 public:
  /// Valid until the next call.
  std::string_view Of(const kernel::Agent& agent, kernel::Symbol symbol) {
    if (!symbol.IsString()) return other_ = cli::SymbolText(agent, symbol);
    const std::string_view text = agent.symbols().Text(symbol);
    Entry& entry = entries_[text.empty() ? 0 : static_cast<unsigned char>(text.back()) % entries_.size()];
    if (entry.printed.empty() || entry.text != text) entry = {std::string(text), cli::SymbolText(agent, symbol)};
    return entry.printed;
  }
  /// The operator's ^name; empty if it has none. Valid until the next name is asked for.
  std::string_view NameOfOperator(const kernel::Agent& agent, kernel::Symbol op) {
    if (!op.IsIdentifier()) return {};
    // The symbol may have been swept, and its place taken by another.
    const kernel::SymbolTable& symbols = agent.symbols();
    if (!name_ || !symbols.IsLive(name_) || symbols.Text(name_) != "name") name_ = symbols.FindString("name");
    if (!name_) return {};
    const kernel::Symbol value = agent.memory().ValueOf(op, name_);
    return value ? Of(agent, value) : std::string_view();
  }

 private:
  struct Entry {
    std::string text, printed;
  };
  std::array<Entry, 8> entries_;
  std::string other_;
  kernel::Symbol name_;  ///< "name".
};

}  // namespace soarbox::server
