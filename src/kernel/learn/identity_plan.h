// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Partitions the fields of a rule's positive conditions into classes. All fields that equal one variable form a class.
/// Each field without an equality test is a class of its own. A constant belongs to no class. Identifiers that actions
/// create have the classes after those of the conditions.
struct IdentityPlan {
  static constexpr std::uint16_t kLiteral = 0xFFFF;

  std::vector<std::uint16_t> of_field;  ///< Three per positive condition: the classes of id, attribute and value.
  std::vector<std::uint16_t> first;     ///< Per class of the conditions: 3 * condition + field of its first occurrence.
  std::vector<Symbol> variables;        ///< Per class of the conditions: its variable, or none.
  std::vector<std::uint16_t> literal;   ///< Fields (3 * condition + field) that learning must keep literal: `$ <x>`.
  /// Four per action (id, attribute, value, referent) for firings without a rule; else empty.
  std::vector<std::uint16_t> of_action;

  /// A test, other than equality, of one field of a condition.
  struct KeptTest {
    std::uint16_t condition = 0;
    Field field = Field::kValue;
    TestKind kind = TestKind::kBlank;
    Symbol referent;  ///< A constant, or the value of the other class.
    std::uint16_t referent_class = kLiteral;
    std::vector<Symbol> disjuncts;
    bool of_literal = false;  ///< The field has been literalized: the test is only shown, nothing is learned from it.
  };

  std::uint16_t bound() const { return static_cast<std::uint16_t>(first.size()); }
  std::uint16_t ClassOf(std::size_t condition, Field field) const {
    return of_field[3 * condition + static_cast<std::size_t>(field)];
  }
  /// The class of a variable of the conditions; kLiteral if no positive condition binds it.
  std::uint16_t ClassOf(Symbol variable) const;

  /// Adds a field with the class of a variable or an identifier. It is a new class if no field has the symbol, or if
  /// `symbol` is none.
  void AddField(Symbol symbol);

  static IdentityPlan Of(const Production& rule);
};

}  // namespace soarbox::kernel
