// SPDX-License-Identifier: BSD-2-Clause
#include <unordered_map>
#include <vector>

#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;
using Child = FunctionContext::Child;

}  // namespace

/// Copies everything that can be reached; what is shared in the original is shared in the copy.
Symbol DeepCopy(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1 || !arguments[0].IsIdentifier()) {
    return context.symbols().String("*symbol not id*");
  }
  std::unordered_map<std::uint32_t, Symbol> copies;
  std::vector<Symbol> waiting;
  const auto copy_of = [&](Symbol symbol) {
    if (!symbol.IsIdentifier()) {
      return symbol;
    }
    const auto [found, is_new] = copies.try_emplace(symbol.bits());
    if (is_new) {
      found->second = context.NewIdentifier(copies.size() == 1 ? 'D' : context.symbols().Letter(symbol));
      waiting.push_back(symbol);
    }
    return found->second;
  };
  const Symbol root = copy_of(arguments[0]);
  std::vector<Child> children;
  while (!waiting.empty()) {
    const Symbol original = waiting.back();
    waiting.pop_back();
    const Symbol copy = copies.at(original.bits());
    children.clear();
    context.AllChildren(original, children);
    for (const Child& child : children) {
      const Symbol attribute = copy_of(child.attribute);
      context.MakePreference(copy, attribute, copy_of(child.value));
    }
  }
  return root;
}

}  // namespace soarbox::kernel::function_bodies
