// SPDX-License-Identifier: BSD-2-Clause
// Passes arbitrary text to the parser of rules. Accepted rules must be printable, and parsing the output must be safe
// (it need not give the same rule, because Soar prints a few symbols in a form that its lexer reads differently).
// Parsing the same text with a new symbol table must give the same result.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "kernel/rules/parser.h"
#include "kernel/rules/print_production.h"

namespace {

using soarbox::kernel::ParseOutcome;
using soarbox::kernel::ParseProduction;
using soarbox::kernel::PrintProduction;
using soarbox::kernel::SymbolTable;

/// The text between the braces of a printed rule.
std::string_view Body(std::string_view printed) {
  const std::size_t begin = printed.find('{') + 1;
  return printed.substr(begin, printed.rfind('}') - begin);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  SymbolTable symbols;
  const ParseOutcome first = ParseProduction(text, {}, symbols);
  if (!first.production) {
    return 0;
  }
  std::string printed;
  for (const bool internal : {false, true}) {
    printed = PrintProduction(symbols, *first.production, {internal});
    ParseProduction(Body(printed), {}, symbols);
  }
  SymbolTable fresh;
  const ParseOutcome again = ParseProduction(text, {}, fresh);
  if (!again.production || PrintProduction(fresh, *again.production, {true}) != printed) {
    std::abort();
  }
  return 0;
}
