// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <vector>

#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;
using Child = FunctionContext::Child;

/// The elements of the only argument, which must be an identifier.
bool ChildrenOf(FunctionContext& context, Arguments arguments, const char* function, std::vector<Child>& out) {
  if (arguments.size() != 1 || !arguments[0].IsIdentifier()) {
    context.PrintError("Error: non-symbol (" + (arguments.empty() ? std::string() : Name(context, arguments[0])) +
                       ") passed to " + function + " function\n");
    return false;
  }
  context.SlotChildren(arguments[0], out);
  return true;
}

/// The value that Soar's sum and product read: they support only 32-bit integers, and read the lower half of a float's
/// bits, which is 0 for most floats in rules. The set functions support floats.
std::uint32_t AsSoarCounts(const SymbolTable& symbols, Symbol value) {
  if (value.IsInteger()) return static_cast<std::uint32_t>(symbols.IntegerValue(value));
  return static_cast<std::uint32_t>(std::bit_cast<std::uint64_t>(symbols.NumberValue(value)));
}

Symbol Folded(FunctionContext& context, Arguments arguments, const char* function, bool multiply) {
  std::vector<Child> children;
  if (!ChildrenOf(context, arguments, function, children)) {
    return {};
  }
  SymbolTable& symbols = context.symbols();
  std::uint32_t folded = multiply ? 1 : 0;
  for (const Child& child : children) {
    if (!child.value.IsNumber()) continue;
    const std::uint32_t value = AsSoarCounts(symbols, child.value);
    folded = multiply ? folded * value : folded + value;
  }
  return symbols.Integer(static_cast<std::int32_t>(folded));
}

/// The input of the set functions: the values at the end of a path of one to three attributes from an identifier.
struct ValueSet {
  bool ok = false;
  Symbol error;  ///< The function's value if `ok` is false.
  std::int64_t count = 0;
  std::vector<double> numbers;
};

ValueSet CollectSet(FunctionContext& context, Arguments arguments) {
  ValueSet set;
  if (arguments.empty()) {
    context.PrintError("Error: the set functions need an identifier and an attribute\n");
    return set;
  }
  if (!arguments[0].IsIdentifier()) {
    set.error = context.symbols().String("|ERROR: First parameter needs to be an identifier.|");
    return set;
  }
  set.ok = true;
  std::vector<Symbol> at = {arguments[0]};
  std::vector<Child> children;
  constexpr std::size_t kLongestPath = 3;
  for (std::size_t i = 1; i < std::min(arguments.size(), kLongestPath + 1); ++i) {
    std::vector<Symbol> next;
    for (const Symbol identifier : at) {
      if (!identifier.IsIdentifier()) {
        continue;
      }
      children.clear();
      context.SlotChildren(identifier, children);
      for (const Child& child : children) {
        if (child.attribute == arguments[i]) {
          next.push_back(child.value);
        }
      }
    }
    at = std::move(next);
  }
  if (arguments.size() < 2) {
    return set;
  }
  set.count = static_cast<std::int64_t>(at.size());
  for (const Symbol value : at) {
    if (value.IsNumber()) {
      set.numbers.push_back(context.symbols().NumberValue(value));
    }
  }
  return set;
}

/// A float computed from the numbers of a set, or the string NaN if there are none.
template <typename Make>
Symbol OfSet(FunctionContext& context, Arguments arguments, Make make) {
  const ValueSet set = CollectSet(context, arguments);
  if (!set.ok) {
    return set.error;
  }
  return set.numbers.empty() ? context.symbols().String("NaN") : context.symbols().Float(make(set.numbers));
}

double SumOf(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) {
    sum += number;
  }
  return sum;
}

double MeanOf(const std::vector<double>& numbers) {
  return SumOf(numbers) / static_cast<double>(numbers.size());
}

}  // namespace

Symbol Size(FunctionContext& context, Arguments arguments) {
  std::vector<Child> children;
  if (!ChildrenOf(context, arguments, "size", children)) {
    return {};
  }
  return context.symbols().Integer(static_cast<std::int64_t>(children.size()));
}

Symbol Sum(FunctionContext& context, Arguments arguments) {
  return Folded(context, arguments, "sum", false);
}
Symbol Product(FunctionContext& context, Arguments arguments) {
  return Folded(context, arguments, "product", true);
}

Symbol SetCount(FunctionContext& context, Arguments arguments) {
  const ValueSet set = CollectSet(context, arguments);
  return set.ok ? context.symbols().Integer(set.count) : set.error;
}

Symbol SetSum(FunctionContext& context, Arguments arguments) {
  return OfSet(context, arguments, SumOf);
}

Symbol SetMultiply(FunctionContext& context, Arguments arguments) {
  return OfSet(context, arguments, [](const std::vector<double>& numbers) {
    double product = 1;
    for (const double number : numbers) {
      product *= number;
    }
    return product;
  });
}

Symbol SetMinimum(FunctionContext& context, Arguments arguments) {
  return OfSet(context, arguments, [](const std::vector<double>& n) { return *std::min_element(n.begin(), n.end()); });
}
Symbol SetMaximum(FunctionContext& context, Arguments arguments) {
  return OfSet(context, arguments, [](const std::vector<double>& n) { return *std::max_element(n.begin(), n.end()); });
}
Symbol SetRange(FunctionContext& context, Arguments arguments) {
  return OfSet(context, arguments, [](const std::vector<double>& n) {
    return *std::max_element(n.begin(), n.end()) - *std::min_element(n.begin(), n.end());
  });
}
Symbol SetMean(FunctionContext& context, Arguments arguments) {
  return OfSet(context, arguments, MeanOf);
}

Symbol SetDeviation(FunctionContext& context, Arguments arguments) {
  return OfSet(context, arguments, [](const std::vector<double>& numbers) {
    const double mean = MeanOf(numbers);
    double sum = 0;
    for (const double number : numbers) {
      sum += (number - mean) * (number - mean);
    }
    return std::sqrt(sum / static_cast<double>(numbers.size()));
  });
}

}  // namespace soarbox::kernel::function_bodies
