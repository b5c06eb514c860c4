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

/// A rule after reading, checking and reordering: the input of the match, the firing and the printers. It is immutable
/// once made, and shared by agents that run the same rules; symbols are handles of their table.
///
/// The tree of a rule is in one block of memory and is small, because there are many rules. Its parts refer to each
/// other by their distance in the block, so you cannot copy them one by one; ToDraft (draft.h) gives a copy that you
/// can change.
namespace soarbox::kernel {

struct RuleDraft;

/// What a field of a condition must be.
struct Test {
  TestKind kind : 8 = TestKind::kBlank;

  /// Constant or variable, for the relational kinds and @; else none.
  Symbol referent() const { return IsList() || kind == TestKind::kBlank ? Symbol() : Symbol::FromBits(data_); }
  /// Of kConjunction; never nested, at most one is kEqual.
  std::span<const Test> parts() const;
  /// Of kDisjunction.
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

  std::uint32_t count_ : 24 = 0;  ///< Of the items, for lists.
  std::uint32_t data_ = 0;        ///< The referent's bits, or how many bytes after this test its items begin.
};
static_assert(sizeof(Test) == 8);

struct Condition {
  ConditionKind kind = ConditionKind::kPositive;
  bool tests_acceptable = false;  ///< ^operator <o> +
  Test id, attribute, value;      ///< kPositive, kNegative.

  /// Of kConjunctiveNegation.
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
  /// Of kBound.
  BindingSite site() const { return {index_, field_}; }
  /// Of kNew: which of the rule's new identifiers.
  std::uint16_t new_index() const { return index_; }
  /// Of kFunction: index in the table of built-in functions.
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
  std::uint32_t data_ = 0;  ///< The symbol's bits, or how many bytes after this value the number of arguments is;
                            ///< the arguments follow it.
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
  RhsValue referent;  ///< The binary preferences and kNumericIndifferent.

  bool HasReferent() const { return kernel::HasReferent(preference); }
  friend bool operator==(const Action& a, const Action& b);
};
static_assert(sizeof(Action) == 36);

class Production {
 public:
  /// Makes a rule from a draft whose variables are bound.
  static std::shared_ptr<const Production> Make(const RuleDraft& draft);

  ProductionType type = ProductionType::kUser;
  DeclaredSupport declared_support = DeclaredSupport::kUndeclared;
  bool has_documentation = false;  ///< An empty documentation string differs from a missing one.
  bool interrupt = false;          ///< :interrupt
  bool explain = false;            ///< :explain
  bool is_rl = false;              ///< Exactly one action, a numeric-indifferent preference for an operator.
                                   ///< Never for templates.
  int line = 0, column = 0;        ///< Of the rule's first character in `file`; 0 if unknown.
  std::string_view name;
  std::string_view documentation;
  std::span<const Condition> conditions;    ///< In match order.
  std::span<const Action> actions;          ///< In firing order.
  std::span<const Symbol> new_identifiers;  ///< The variables behind RhsValueKind::kNew, by new_index.

  /// Where it was read from; empty for typed rules.
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
