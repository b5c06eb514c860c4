// SPDX-License-Identifier: BSD-2-Clause
#include <algorithm>
#include <iterator>
#include <unordered_map>
#include <utility>
#include <vector>

#include "kernel/base/known_symbols.h"
#include "kernel/rules/functions/function_bodies.h"

namespace soarbox::kernel::function_bodies {

namespace {

using Arguments = std::span<const Symbol>;
using Child = FunctionContext::Child;

/// Removes the elements of an impasse that the architecture created: a copy of a state contains only those that a rule
/// created.
void DropImpasse(FunctionContext& context, Symbol state, std::vector<Child>& children) {
  constexpr Symbol kOfImpasses[] = {words::kSuperstate, words::kType,       words::kImpasse, words::kChoices,
                                    words::kAttribute,  words::kQuiescence, words::kItem};
  std::vector<Child> made;
  context.SlotChildren(state, made);
  std::erase_if(children, [&](const Child& child) {
    const auto is_same = [&](const Child& other) {
      return other.attribute == child.attribute && other.value == child.value;
    };
    return std::ranges::find(kOfImpasses, child.attribute) != std::end(kOfImpasses) &&
           std::ranges::none_of(made, is_same);
  });
}

}  // namespace

/// Copies everything that is reachable. Structure that is shared in the original is shared in the copy. An element is
/// copied after everything below it.
Symbol DeepCopy(FunctionContext& context, Arguments arguments) {
  if (arguments.size() != 1 || !arguments[0].IsIdentifier()) {
    return context.symbols().String("*symbol not id*");
  }
  struct Open {
    Symbol original, copy;
    std::vector<Child> children;
    std::size_t next = 0;
    bool attribute_done = false, value_done = false;
  };
  std::vector<Open> open;
  std::unordered_map<std::uint32_t, Symbol> copies;
  const auto copy_of = [&](Symbol symbol) { return symbol.IsIdentifier() ? copies.at(symbol.bits()) : symbol; };
  const auto begin = [&](Symbol symbol) {
    if (!symbol.IsIdentifier() || copies.contains(symbol.bits())) return;
    const Symbol copy = context.NewIdentifier(copies.empty() ? 'D' : context.symbols().Letter(symbol));
    copies.emplace(symbol.bits(), copy);
    Open& object = open.emplace_back();
    object.original = symbol;
    object.copy = copy;
    context.AllChildren(symbol, object.children);
    if (context.IsGoal(symbol)) DropImpasse(context, symbol, object.children);
  };
  begin(arguments[0]);
  while (!open.empty()) {
    Open& object = open.back();
    if (object.next == object.children.size()) {
      open.pop_back();
      continue;
    }
    const Child child = object.children[object.next];
    if (!std::exchange(object.attribute_done, true)) {
      begin(child.attribute);
    } else if (!std::exchange(object.value_done, true)) {
      begin(child.value);
    } else {
      context.CopyElement(child, object.original, object.copy, copy_of(child.attribute), copy_of(child.value));
      ++object.next;
      object.attribute_done = object.value_done = false;
    }
  }
  return copies.at(arguments[0].bits());
}

}  // namespace soarbox::kernel::function_bodies
