// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <memory>

#include "kernel/match/alpha_memories.h"
#include "kernel/match/goal_view.h"
#include "kernel/match/network.h"
#include "kernel/match/token_pool.h"
#include "kernel/match/wme.h"

namespace soarbox::kernel {

class SymbolTable;

inline bool AreSmallIntegers(std::uint32_t left, std::uint32_t right) {
  constexpr std::uint32_t kSmall = static_cast<std::uint32_t>(Symbol::Tag::kSmallInteger);
  return (left >> Symbol::kIndexBits) == kSmall && (right >> Symbol::kIndexBits) == kSmall;
}

/// A comparison with a constant or a binding. Sets `decided` to false if it is not one of the common ones.
[[gnu::always_inline]] inline bool Compare(const TokenPool& tokens, const WmeTable& wmes, const NodeTest& test,
                                           std::uint32_t parent, std::uint32_t left, const Wme& element,
                                           bool& decided) {
  decided = true;
  const std::uint32_t value = BitsOf(element, test.field);
  std::uint32_t referent = test.referent;
  if (test.against_binding) {
    referent = test.levels == 0 ? BitsOf(element, test.referent_field)
                                : BitsOf(wmes.data()[ElementAt(tokens.records(), parent, left, test.levels - 1u)],
                                         test.referent_field);
  }
  if (test.op <= TestOp::kNotEqual) {
    return (value == referent) == (test.op == TestOp::kEqual);
  }
  if (test.op <= TestOp::kGreaterOrEqual && AreSmallIntegers(value, referent)) {
    const auto a = static_cast<std::int32_t>(value << 3);
    const auto b = static_cast<std::int32_t>(referent << 3);
    // kLess, kGreater, kLessOrEqual, kGreaterOrEqual, in this order.
    const bool upwards = test.op == TestOp::kLess || test.op == TestOp::kLessOrEqual;
    const bool strict = test.op <= TestOp::kGreater;
    return upwards ? (a < b || (!strict && a == b)) : (a > b || (!strict && a == b));
  }
  decided = false;
  return false;
}

/// The key of an element for a node.
inline std::uint32_t KeyOfElement(const Node& node, const Wme& wme) {
  switch (node.key) {
    case KeyKind::kNone:
      return 0;
    case KeyKind::kId:
      return wme.id.bits();
    case KeyKind::kIdValue:
      return PairKey(wme.id.bits(), wme.value.bits());
  }
  return 0;
}

/// Whether a pair has the identifier and value of an element; call it when kIdValue keys are equal.
inline bool HasKey(const TokenPool& pool, const WmeTable& table, const Node& node, std::uint32_t parent,
                   std::uint32_t left, const Wme& wme) {
  if (node.key != KeyKind::kIdValue) {
    return true;
  }
  const Records<const Token> tokens = pool.read();
  const Wme* wmes = table.data();
  return wme.id.bits() == BitsOf(wmes[ElementAt(tokens, parent, left, node.key_id_levels)], node.key_id_field) &&
         wme.value.bits() == BitsOf(wmes[ElementAt(tokens, parent, left, node.key_value_levels)], node.key_value_field);
}
inline bool HasKey(const TokenPool& pool, const WmeTable& table, const Node& node, std::uint32_t token,
                   const Wme& wme) {
  return HasKey(pool, table, node, pool[token].parent, pool[token].wme, wme);
}

/// The tests of a join on a pair: a token's (parent, left), and an element.
class [[gnu::visibility("hidden")]] PairTests {
 public:
  PairTests(const std::shared_ptr<Network>& network, const TokenPool& tokens, const WmeTable& wmes,
            const SymbolTable& symbols, const GoalView& goals)
      : network_(network), tokens_(tokens), wmes_(wmes), symbols_(symbols), goals_(goals) {}

  bool PassesOne(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const;
  /// All tests of a node.
  [[gnu::noinline]] bool Passes(const Node& node, std::uint32_t parent, std::uint32_t left, const Wme& wme) const;
  bool Passes(const Node& node, std::uint32_t token, const Wme& wme) const {
    return Passes(node, tokens_[token].parent, tokens_[token].wme, wme);
  }

 private:
  bool PassesTest(const NodeTest& test, std::uint32_t parent, std::uint32_t left, const Wme& wme) const;

  const std::shared_ptr<Network>& network_;
  const TokenPool& tokens_;
  const WmeTable& wmes_;
  const SymbolTable& symbols_;
  const GoalView& goals_;
};

}  // namespace soarbox::kernel
