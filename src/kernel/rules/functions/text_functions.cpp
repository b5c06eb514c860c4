// SPDX-License-Identifier: BSD-2-Clause
#include <charconv>
#include <string>

#include "kernel/base/characters.h"
#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;

std::string Name(FunctionContext& context, Symbol symbol) {
  return ToString(context.symbols(), symbol);
}

std::string Glued(FunctionContext& context, Arguments arguments) {
  std::string text;
  for (const Symbol argument : arguments) {
    AppendTo(text, context.symbols(), argument, false);
  }
  return text;
}

}  // namespace

Symbol Concat(FunctionContext& context, Arguments arguments) {
  return context.symbols().String(Glued(context, arguments));
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
  const std::string stem = arguments.empty() ? "constant" : Glued(context, arguments);
  SymbolTable& symbols = context.symbols();
  std::string text;
  do {
    text = stem + std::to_string(context.NextConstantNumber());
  } while (symbols.FindString(text));
  return symbols.String(text);
}

Symbol Capitalize(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1 || !arguments[0].IsString()) {
    context.PrintError("\nError: non-symbol (" + Glued(context, arguments) +
                       ") passed to capitalize-symbol function.\n");
    return {};
  }
  std::string text(context.symbols().Text(arguments[0]));
  if (!text.empty()) {
    text[0] = ToUpper(text[0]);
  }
  return context.symbols().String(text);
}

Symbol Trim(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1 || !arguments[0].IsString()) {
    context.PrintError("\nError: non-symbol (" + Glued(context, arguments) + ") passed to 'trim' function.\n");
    return {};
  }
  const std::string text(context.symbols().Text(arguments[0]));
  constexpr const char* kBlanks = " \t\n\v\f\r";
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string::npos) {
    return context.symbols().String("");
  }
  return context.symbols().String(std::string_view(text).substr(begin, text.find_last_not_of(kBlanks) - begin + 1));
}

Symbol TextLength(FunctionContext& context, Arguments arguments) {
  return context.symbols().Integer(static_cast<std::int64_t>(Glued(context, arguments).size()));
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
