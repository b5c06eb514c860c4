// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"

namespace soarbox::kernel {

class GoalStack;
class SymbolTable;
class WorkingMemory;

/// The requirement of a `chunk singleton` pattern for an identifier or a value.
enum class SingletonType : std::uint8_t { kAny, kConstant, kIdentifier, kOperator, kState };

/// Elements that are the only ones of their kind. For example, an object has only one ^name, no matter which rule tests
/// it. If conditions of different rules tested the same singleton of a higher state, their values must be equal. So one
/// condition in the learned rule is enough.
///
/// An attribute has at most one pattern. With `chunk automatically-create-singletons`, each string that has been the
/// attribute of an element gets the pattern that matches all elements.
class Singletons {
 public:
  struct Pattern {
    Symbol attribute;
    SingletonType id = SingletonType::kAny, value = SingletonType::kAny;
  };

  /// The parts of the agent that it uses.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    const SymbolTable& symbols;
  };
  explicit Singletons(const Uses& uses) : uses_(uses) {}

  /// An element with this attribute was added to working memory.
  void Note(Symbol attribute) {
    if (attribute.IsString() && (attribute.index() >= codes_.size() || codes_[attribute.index()] == 0)) {
      Put({attribute, SingletonType::kAny, SingletonType::kAny});
    }
  }
  /// Adds the attributes of all existing elements, because Note is not called while learning is off.
  void NoteAll();

  /// Returns true if the element is a singleton: by a pattern, or because the architecture creates only one of its
  /// kind.
  bool Fits(WmeId wme) const;
  /// Replaces the pattern of the same attribute. Returns true if there was one.
  bool Set(const Pattern& pattern);
  /// Removes the pattern of an attribute. Returns false if there is none.
  bool Remove(Symbol attribute);
  /// Removes all patterns.
  void Clear() { codes_.assign(codes_.size(), 0); }
  /// Returns true for attributes that the architecture gives to states.
  static bool IsArchitecture(Symbol attribute);
  /// All patterns, sorted by the age of the attribute's symbol.
  std::vector<Pattern> Patterns() const;

  template <typename Mark>
  void ForEachSymbol(Mark&& mark) const {
    for (std::uint32_t index = 0; index < codes_.size(); ++index) {
      if (codes_[index] != 0) mark(Symbol(Symbol::Tag::kString, index));
    }
  }

 private:
  void Put(const Pattern& pattern);
  bool HasType(Symbol symbol, SingletonType type) const;

  Uses uses_;
  std::vector<std::uint8_t> codes_;  ///< By the attribute's index: 0 for none, else 1 + 5 * type of id + type of value.
};

}  // namespace soarbox::kernel
