// SPDX-License-Identifier: BSD-2-Clause
#include <charconv>
#include <string>

#include "kernel/base/characters.h"
#include "kernel/rules/functions/function_bodies.h"
#include "kernel/rules/functions/short_text.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

void Glue(ShortText& text, const SymbolTable& symbols, Arguments arguments) {
  for (const Symbol argument : arguments) {
    text.Append(symbols, argument);
  }
}

std::string JoinedText(FunctionContext& context, Arguments arguments) {
  ShortText text;
  Glue(text, context.symbols(), arguments);
  return text.str();
}

bool IsBlank(char c) {
  return c == ' ' || (c >= '\t' && c <= '\r');
}

}  // namespace

Symbol Concat(FunctionContext& context, Arguments arguments) {
  SymbolTable& symbols = context.symbols();
  ShortText text;
  Glue(text, symbols, arguments);
  return symbols.String(text.view());
}

Symbol ToText(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1) {
    return {};
  }
  if (!arguments[0].IsFloat()) {
    return Concat(context, arguments);
  }
  char buffer[400];
  const double value = context.symbols().FloatValue(arguments[0]);
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, 17).ptr;
  return context.symbols().String(std::string_view(buffer, static_cast<std::size_t>(end - buffer)));
}

Symbol MakeConstant(FunctionContext& context, Arguments arguments) {
  const std::string stem = arguments.empty() ? "constant" : JoinedText(context, arguments);
  SymbolTable& symbols = context.symbols();
  std::string text;
  do {
    text = stem + std::to_string(context.NextConstantNumber());
  } while (symbols.FindString(text));
  return symbols.String(text);
}

Symbol Capitalize(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1 || !arguments[0].IsString()) {
    context.PrintError("\nError: non-symbol (" + JoinedText(context, arguments) +
                       ") passed to capitalize-symbol function.\n");
    return {};
  }
  SymbolTable& symbols = context.symbols();
  const std::string_view text = symbols.Text(arguments[0]);
  if (text.empty() || ToUpper(text[0]) == text[0]) {
    return arguments[0];
  }
  const char first = ToUpper(text[0]);
  ShortText capitalised;
  capitalised.Append(std::string_view(&first, 1));
  capitalised.Append(text.substr(1));
  return symbols.String(capitalised.view());
}

Symbol Trim(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1 || !arguments[0].IsString()) {
    context.PrintError("\nError: non-symbol (" + JoinedText(context, arguments) + ") passed to 'trim' function.\n");
    return {};
  }
  SymbolTable& symbols = context.symbols();
  std::string_view text = symbols.Text(arguments[0]);
  const std::size_t length = text.size();
  while (!text.empty() && IsBlank(text.front())) {
    text.remove_prefix(1);
  }
  while (!text.empty() && IsBlank(text.back())) {
    text.remove_suffix(1);
  }
  if (text.size() == length) {
    return arguments[0];
  }
  return symbols.String(text);
}

Symbol TextLength(FunctionContext& context, Arguments arguments) {
  SymbolTable& symbols = context.symbols();
  ShortText text;
  Glue(text, symbols, arguments);
  return symbols.Integer(static_cast<std::int64_t>(text.view().size()));
}

Symbol IfEqual(FunctionContext&, Arguments arguments) {
  if (arguments.size() != 4) {
    return {};
  }
  return arguments[0] == arguments[1] ? arguments[2] : arguments[3];
}

Symbol LongTermNumber(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1) {
    return {};
  }
  const std::uint64_t lti = arguments[0].IsIdentifier() ? context.LongTermIdentifier(arguments[0]) : 0;
  if (lti == 0) {
    context.PrintError("\nError: " + Name(context, arguments[0]) + " is not linked to a semantic identifier.\n");
    return {};
  }
  return context.symbols().Integer(static_cast<std::int64_t>(lti));
}

}  // namespace soarbox::kernel::function_bodies
