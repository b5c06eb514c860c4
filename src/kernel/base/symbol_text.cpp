// SPDX-License-Identifier: BSD-2-Clause
#include <charconv>

#include "kernel/base/characters.h"
#include "kernel/base/symbol_table.h"

namespace soarbox::kernel {

namespace {

bool AllAlphanumeric(std::string_view text) {
  for (const char c : text) {
    if (!IsLetter(c) && !IsDigit(c)) {
      return false;
    }
  }
  return !text.empty();
}

bool AllConstituents(std::string_view text) {
  for (const char c : text) {
    if (!IsConstituent(c)) {
      return false;
    }
  }
  return !text.empty();
}

void AppendBarred(std::string& out, std::string_view text) {
  out += '|';
  for (const char c : text) {
    if (c == '|' || c == '\\') {
      out += '\\';
    }
    out += c;
  }
  out += '|';
}

}  // namespace

bool ReadsAsPlainString(std::string_view text) {
  if (text == "*") {
    return true;
  }
  // Short words that contain signs could be operators of the rule language. Soar writes bars around all of them.
  const bool plain = AllAlphanumeric(text) || (text.size() > 3 && AllConstituents(text));
  return plain && !LooksLikeInteger(text) && !LooksLikeVariable(text) && !LooksLikeIdentifier(text);
}

void AppendTo(std::string& out, const SymbolTable& symbols, Symbol symbol, bool rereadable) {
  char buffer[400];  // A double with six decimals has at most 317 characters.
  switch (symbol.kind()) {
    case SymbolKind::kNone:
      break;
    case SymbolKind::kVariable:
      out += symbols.Text(symbol);
      break;
    case SymbolKind::kIdentifier: {
      out += symbols.Letter(symbol);
      const auto end = std::to_chars(buffer, buffer + sizeof buffer, symbols.Number(symbol)).ptr;
      out.append(buffer, end);
      break;
    }
    case SymbolKind::kString: {
      const std::string_view text = symbols.Text(symbol);
      if (rereadable && !ReadsAsPlainString(text)) {
        AppendBarred(out, text);
      } else {
        out += text;
      }
      break;
    }
    case SymbolKind::kInteger: {
      const auto end = std::to_chars(buffer, buffer + sizeof buffer, symbols.IntegerValue(symbol)).ptr;
      out.append(buffer, end);
      break;
    }
    case SymbolKind::kFloat: {
      const auto end =
          std::to_chars(buffer, buffer + sizeof buffer, symbols.FloatValue(symbol), std::chars_format::fixed, 6).ptr;
      out.append(buffer, end);
      break;
    }
  }
}

std::string ToString(const SymbolTable& symbols, Symbol symbol, bool rereadable) {
  std::string out;
  AppendTo(out, symbols, symbol, rereadable);
  return out;
}

}  // namespace soarbox::kernel
