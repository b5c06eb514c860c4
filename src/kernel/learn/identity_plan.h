// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// Which fields of a rule's positive conditions name the same thing: fields that are equal to one variable make a
/// class, each field without an equality test is a class of its own, and a constant belongs to none. Identifiers that
/// the actions make have the classes behind those that conditions bind.
struct IdentityPlan {
  static constexpr std::uint16_t kLiteral = 0xFFFF;

  std::vector<std::uint16_t> of_field;  ///< Three per positive condition: the classes of id, attribute and value.
  std::vector<std::uint16_t> first;     ///< Per class that a condition binds: 3 * condition + field of its first place.
  std::vector<Symbol> variables;        ///< Per such class: the variable, or none.
  std::vector<std::uint16_t> literal;   ///< Fields (3 * condition + field) that learning keeps literal: `$ <x>`.
  /// Four per action (id, attribute, value, referent), for firings that have no rule; otherwise empty.
  std::vector<std::uint16_t> of_action;

  /// A test, beside equality, that a condition made of one of its fields.
  struct KeptTest {
    std::uint16_t condition = 0;
    Field field = Field::kValue;
    TestKind kind = TestKind::kBlank;
    Symbol referent;  ///< A constant, or what the other class was.
    std::uint16_t referent_class = kLiteral;
    std::vector<Symbol> disjuncts;
    bool of_literal =
        false;  ///< The field has become a constant: the text tells of the test, nothing is learned from it.
  };

  std::uint16_t bound() const { return static_cast<std::uint16_t>(first.size()); }
  std::uint16_t ClassOf(std::size_t condition, Field field) const {
    return of_field[3 * condition + static_cast<std::size_t>(field)];
  }
  /// The class of a variable of the conditions; kLiteral if no positive condition binds it.
  std::uint16_t ClassOf(Symbol variable) const;

  static IdentityPlan Of(const Production& rule);
};

}  // namespace soarbox::kernel
