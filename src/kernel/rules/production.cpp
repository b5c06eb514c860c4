// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/rules/production.h"

#include <algorithm>
#include <new>

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

bool operator==(const Test& a, const Test& b) {
  if (a.kind != b.kind) {
    return false;
  }
  return a.IsList() ? std::ranges::equal(a.parts(), b.parts()) && std::ranges::equal(a.disjuncts(), b.disjuncts())
                    : a.data_ == b.data_;
}

bool operator==(const Condition& a, const Condition& b) {
  if (a.kind != b.kind || a.tests_acceptable != b.tests_acceptable) {
    return false;
  }
  return a.kind == ConditionKind::kConjunctiveNegation
             ? std::ranges::equal(a.conditions(), b.conditions())
             : a.id == b.id && a.attribute == b.attribute && a.value == b.value;
}

bool operator==(const RhsValue& a, const RhsValue& b) {
  if (a.kind != b.kind || a.index_ != b.index_ || a.field_ != b.field_) {
    return false;
  }
  return a.kind == RhsValueKind::kFunction ? std::ranges::equal(a.arguments(), b.arguments()) : a.data_ == b.data_;
}

bool operator==(const Action& a, const Action& b) {
  return a.is_function_call == b.is_function_call && a.preference == b.preference && a.id == b.id &&
         a.attribute == b.attribute && a.value == b.value && a.referent == b.referent;
}

/// Computes the size of a draft's tree in bytes.
class RuleSize {
 public:
  explicit RuleSize(const RuleDraft& draft) {
    Add(draft.conditions);
    for (const ActionDraft& action : draft.actions) {
      bytes_ += sizeof(Action);
      for (const ValueDraft* value : {&action.id, &action.attribute, &action.value, &action.referent}) {
        AddParts(*value);
      }
    }
    bytes_ += draft.new_identifiers.size() * sizeof(Symbol) + draft.name.size() + draft.documentation.size();
  }
  std::size_t bytes() const { return bytes_; }

 private:
  void Add(const DraftList<ConditionDraft>& conditions) {
    for (const ConditionDraft& condition : conditions) {
      bytes_ += sizeof(Condition);
      if (condition.kind == ConditionKind::kConjunctiveNegation) {
        Add(condition.conditions);
        continue;
      }
      AddParts(condition.id);
      AddParts(condition.attribute);
      AddParts(condition.value);
    }
  }
  void AddParts(const TestDraft& test) {
    if (test.kind == TestKind::kDisjunction) {
      bytes_ += test.disjunct_count * sizeof(Symbol);
    } else if (test.kind == TestKind::kConjunction) {
      for (const TestDraft& part : test.parts) {
        bytes_ += sizeof(Test);
        AddParts(part);
      }
    }
  }
  void AddParts(const ValueDraft& value) {
    if (value.kind != RhsValueKind::kFunction) {
      return;
    }
    bytes_ += sizeof(std::uint32_t);
    for (const ValueDraft& argument : value.arguments) {
      bytes_ += sizeof(RhsValue);
      AddParts(argument);
    }
  }

  std::size_t bytes_ = 0;
};

/// Writes the tree of a draft into a block of that size.
class RuleWriter {
 public:
  explicit RuleWriter(std::byte* block) : next_(block) {}

  std::span<const Condition> Write(const DraftList<ConditionDraft>& drafts) {
    const std::uint32_t count = drafts.Count();
    Condition* const conditions = Take<Condition>(count);
    Condition* out = conditions;
    for (const ConditionDraft& draft : drafts) {
      out->kind = draft.kind;
      out->tests_acceptable = draft.tests_acceptable;
      if (draft.kind == ConditionKind::kConjunctiveNegation) {
        const std::span<const Condition> inner = Write(draft.conditions);
        Point(out->id, inner.data(), inner.size());
      } else {
        Write(draft.id, out->id);
        Write(draft.attribute, out->attribute);
        Write(draft.value, out->value);
      }
      ++out;
    }
    return {conditions, count};
  }

  std::span<const Action> Write(const DraftList<ActionDraft>& drafts) {
    const std::uint32_t count = drafts.Count();
    Action* const actions = Take<Action>(count);
    Action* out = actions;
    for (const ActionDraft& draft : drafts) {
      out->is_function_call = draft.is_function_call;
      out->preference = draft.preference;
      Write(draft.id, out->id);
      Write(draft.attribute, out->attribute);
      Write(draft.value, out->value);
      Write(draft.referent, out->referent);
      ++out;
    }
    return {actions, count};
  }

  std::span<const Symbol> Write(std::span<const Symbol> symbols) {
    Symbol* const out = Take<Symbol>(symbols.size());
    std::ranges::copy(symbols, out);
    return {out, symbols.size()};
  }

  std::string_view Write(std::string_view text) {
    char* const out = Take<char>(text.size());
    text.copy(out, text.size());
    return {out, text.size()};
  }

 private:
  /// Allocates value-initialized objects. Everything except texts is aligned to four bytes; texts come last.
  template <typename T>
  T* Take(std::size_t count) {
    static_assert(alignof(T) <= 4);
    T* const made = reinterpret_cast<T*>(next_);
    next_ += sizeof(T) * count;
    for (std::size_t n = 0; n < count; ++n) {
      new (made + n) T;
    }
    return made;
  }

  template <typename T>
  static std::uint32_t Distance(const void* from, const T* to) {
    return static_cast<std::uint32_t>(reinterpret_cast<const std::byte*>(to) - static_cast<const std::byte*>(from));
  }

  template <typename T>
  static void Point(Test& test, const T* items, std::size_t count) {
    test.count_ = static_cast<std::uint32_t>(count) & 0xFFFFFFu;
    test.data_ = Distance(&test, items);
  }

  void Write(const TestDraft& draft, Test& out) {
    out.kind = draft.kind;
    out.data_ = draft.referent.bits();
    if (draft.kind == TestKind::kDisjunction || draft.kind == TestKind::kConjunction) {
      WriteParts(draft, out);
    }
  }
  void WriteParts(const TestDraft& draft, Test& out) {
    if (draft.kind == TestKind::kDisjunction) {
      const std::span<const Symbol> disjuncts = Write(std::span(draft.disjuncts, draft.disjunct_count));
      Point(out, disjuncts.data(), disjuncts.size());
      return;
    }
    const std::uint32_t count = draft.parts.Count();
    Test* const parts = Take<Test>(count);
    Point(out, parts, count);
    Test* next = parts;
    for (const TestDraft& part : draft.parts) {
      Write(part, *next++);
    }
  }

  void Write(const ValueDraft& draft, RhsValue& out) {
    out.kind = draft.kind;
    out.index_ = draft.kind == RhsValueKind::kBound ? draft.site.positive_condition : draft.index;
    out.field_ = draft.site.field;
    out.data_ = draft.symbol.bits();
    if (draft.kind != RhsValueKind::kFunction) {
      return;
    }
    const std::uint32_t count = draft.arguments.Count();
    std::uint32_t* const stored_count = Take<std::uint32_t>(1);
    *stored_count = count;
    out.data_ = Distance(&out, stored_count);
    RhsValue* next = Take<RhsValue>(count);
    for (const ValueDraft& argument : draft.arguments) {
      Write(argument, *next++);
    }
  }

  std::byte* next_;
};

std::shared_ptr<const Production> Production::Make(const RuleDraft& draft) {
  struct Made : Production {};
  const std::shared_ptr<Made> rule = std::make_shared<Made>();
  rule->type = draft.type;
  rule->declared_support = draft.declared_support;
  rule->has_documentation = draft.has_documentation;
  rule->interrupt = draft.interrupt;
  rule->explain = draft.explain;
  rule->is_rl = draft.is_rl;
  rule->file_ = draft.file;
  rule->line = draft.line;
  rule->column = draft.column;
  rule->block_bytes_ = RuleSize(draft).bytes();
  rule->block_ = std::make_unique_for_overwrite<std::byte[]>(rule->block_bytes_);
  RuleWriter writer(rule->block_.get());
  rule->conditions = writer.Write(draft.conditions);
  rule->actions = writer.Write(draft.actions);
  rule->new_identifiers = writer.Write(std::span(draft.new_identifiers));
  rule->name = writer.Write(draft.name);
  rule->documentation = writer.Write(draft.documentation);
  return rule;
}

}  // namespace soarbox::kernel
