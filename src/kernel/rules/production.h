// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "kernel/base/symbol.h"
#include "kernel/rules/file_name.h"
#include "kernel/rules/rule_kinds.h"

/// A finished rule, after reading, checking and reordering. The match, firing and printers use it. Immutable, and
/// shared by agents with the same rules; its symbols are handles of their tables.
///
/// The tree of a rule is in one compact block of memory, because there are many rules. Its parts refer to each other by
/// offsets in the block, so they cannot be copied one by one. ToDraft (draft.h) returns a mutable copy.
namespace soarbox::kernel {

struct RuleDraft;

/// The test of one field of a condition.
struct Test {
  TestKind kind : 8 = TestKind::kBlank;

  /// The constant or variable of the relational kinds and @; else none.
  Symbol referent() const { return IsList() || kind == TestKind::kBlank ? Symbol() : Symbol::FromBits(data_); }
  /// The parts of a kConjunction. Never nested; at most one is kEqual.
  std::span<const Test> parts() const;
  /// The values of a kDisjunction.
  std::span<const Symbol> disjuncts() const;

  Test() = default;
  Test(const Test&) = delete;
  Test& operator=(const Test&) = delete;
  friend bool operator==(const Test& a, const Test& b);

 private:
  friend class RuleWriter;
  friend struct Condition;
  bool IsList() const { return kind == TestKind::kConjunction || kind == TestKind::kDisjunction; }
  const std::byte* Items() const { return reinterpret_cast<const std::byte*>(this) + data_; }

  std::uint32_t count_ : 24 = 0;  ///< Number of items, for lists.
  std::uint32_t data_ = 0;        ///< The referent's bits; for lists, the offset in bytes from this test to its items.
};
static_assert(sizeof(Test) == 8);

struct Condition {
  ConditionKind kind = ConditionKind::kPositive;
  bool tests_acceptable = false;  ///< ^operator <o> +
  Test id, attribute, value;      ///< kPositive, kNegative.

  /// The conditions of a kConjunctiveNegation.
  std::span<const Condition> conditions() const {
    if (kind != ConditionKind::kConjunctiveNegation) return {};
    return {reinterpret_cast<const Condition*>(id.Items()), id.count_};
  }

  friend bool operator==(const Condition& a, const Condition& b);
};
static_assert(sizeof(Condition) == 28);

inline std::span<const Test> Test::parts() const {
  if (kind != TestKind::kConjunction) return {};
  return {reinterpret_cast<const Test*>(Items()), count_};
}

inline std::span<const Symbol> Test::disjuncts() const {
  if (kind != TestKind::kDisjunction) return {};
  return {reinterpret_cast<const Symbol*>(Items()), count_};
}

/// A term of an action.
struct RhsValue {
  RhsValueKind kind = RhsValueKind::kConstant;

  /// The constant or the variable's name; none for functions.
  Symbol symbol() const { return kind == RhsValueKind::kFunction ? Symbol() : Symbol::FromBits(data_); }
  /// For kBound.
  BindingSite site() const { return {index_, field_}; }
  /// For kNew: an index into Production::new_identifiers.
  std::uint16_t new_index() const { return index_; }
  /// For kFunction: an index into the table of built-in functions.
  std::uint16_t function_index() const { return index_; }
  std::span<const RhsValue> arguments() const;

  static constexpr std::uint16_t kUserFunction = 0xFFFF;

  RhsValue() = default;
  RhsValue(const RhsValue&) = delete;
  RhsValue& operator=(const RhsValue&) = delete;
  friend bool operator==(const RhsValue& a, const RhsValue& b);

 private:
  friend class RuleWriter;
  Field field_ = Field::kId;
  std::uint16_t index_ = 0;
  std::uint32_t data_ = 0;  ///< The symbol's bits; for functions, the offset in bytes from this value to the number of
                            ///< arguments, which the arguments follow.
};
static_assert(sizeof(RhsValue) == 8);

inline std::span<const RhsValue> RhsValue::arguments() const {
  if (kind != RhsValueKind::kFunction) return {};
  const std::byte* const count = reinterpret_cast<const std::byte*>(this) + data_;
  return {reinterpret_cast<const RhsValue*>(count + sizeof(std::uint32_t)),
          *reinterpret_cast<const std::uint32_t*>(count)};
}

struct Action {
  bool is_function_call = false;  ///< (write ...): only `value` is used.
  PreferenceType preference = PreferenceType::kAcceptable;
  RhsValue id, attribute, value;
  RhsValue referent;  ///< For binary preferences and kNumericIndifferent.

  bool HasReferent() const { return kernel::HasReferent(preference); }
  friend bool operator==(const Action& a, const Action& b);
};
static_assert(sizeof(Action) == 36);

class Production {
 public:
  /// Builds a rule from a draft whose variables are bound.
  static std::shared_ptr<const Production> Make(const RuleDraft& draft);

  ProductionType type = ProductionType::kUser;
  DeclaredSupport declared_support = DeclaredSupport::kUndeclared;
  bool has_documentation = false;  ///< An empty documentation string differs from a missing one.
  bool interrupt = false;          ///< :interrupt
  bool explain = false;            ///< :explain
  bool is_rl = false;  ///< True if the only action is a numeric-indifferent preference for an operator. Always false
                       ///< for templates.
  int line = 0, column = 0;  ///< Of the rule's first character in `file`; 0 if unknown.
  std::string_view name;
  std::string_view documentation;
  std::span<const Condition> conditions;    ///< In match order.
  std::span<const Action> actions;          ///< In firing order.
  std::span<const Symbol> new_identifiers;  ///< The variables of RhsValueKind::kNew terms, by new_index.

  /// The file that the rule was read from; empty for typed rules.
  const std::string& file() const { return file_.text(); }
  const FileName& file_name() const { return file_; }
  std::size_t MemoryBytes() const { return sizeof(Production) + block_bytes_; }

  Production(const Production&) = delete;
  Production& operator=(const Production&) = delete;

 protected:
  Production() = default;

 private:
  FileName file_;
  std::unique_ptr<std::byte[]> block_;
  std::size_t block_bytes_ = 0;
};

using ProductionPtr = std::shared_ptr<const Production>;

}  // namespace soarbox::kernel
