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

/// What a pattern of `chunk singleton` asks of an identifier or a value.
enum class SingletonType : std::uint8_t { kAny, kConstant, kIdentifier, kOperator, kState };

/// Elements that are the only ones of their kind: an object has one ^name, whatever rules test it. Conditions of
/// different rules that tested one such element of a higher state are about the same value of necessity, so that one
/// condition of the learned rule is enough.
///
/// An attribute has one pattern at most. With `chunk automatically-create-singletons` each string that has been the
/// attribute of an element gets the pattern that fits all of them.
class Singletons {
 public:
  struct Pattern {
    Symbol attribute;
    SingletonType id = SingletonType::kAny, value = SingletonType::kAny;
  };

  /// What it uses of the agent.
  struct Uses {
    const WorkingMemory& memory;
    const GoalStack& goals;
    const SymbolTable& symbols;
  };
  explicit Singletons(const Uses& uses) : uses_(uses) {}

  /// An element with this attribute has come into working memory.
  void Note(Symbol attribute) {
    if (attribute.IsString() && (attribute.index() >= codes_.size() || codes_[attribute.index()] == 0)) {
      Put({attribute, SingletonType::kAny, SingletonType::kAny});
    }
  }
  /// Notes the attributes of all elements that there are: while nothing is learned nobody tells of them.
  void NoteAll();

  /// True if the element is a singleton: by a pattern, or because the architecture makes only one of its kind.
  bool Fits(WmeId wme) const;
  /// Replaces the pattern of the same attribute; true if there was one.
  bool Set(const Pattern& pattern);
  /// Takes the pattern of an attribute away; false if it has none.
  bool Remove(Symbol attribute);
  /// Takes all of them away.
  void Clear() { codes_.assign(codes_.size(), 0); }
  /// True for attributes that the architecture gives to states.
  static bool IsArchitecture(Symbol attribute);
  /// All patterns, by age of the attribute's name.
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
