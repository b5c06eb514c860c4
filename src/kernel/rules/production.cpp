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

/// Lays the tree of a draft out in one block: first measured without memory, then written.
class RuleWriter {
 public:
  /// Measures only.
  RuleWriter() = default;
  explicit RuleWriter(std::byte* block) : block_(block) {}
  std::size_t bytes() const { return used_; }

  std::span<const Condition> Write(const DraftList<ConditionDraft>& drafts) {
    const std::uint32_t count = drafts.Count();
    Condition* const conditions = Take<Condition>(count);
    std::size_t n = 0;
    for (const ConditionDraft& draft : drafts) {
      Condition* const out = block_ == nullptr ? nullptr : &conditions[n++];
      if (out != nullptr) {
        out->kind = draft.kind;
        out->tests_acceptable = draft.tests_acceptable;
      }
      if (draft.kind == ConditionKind::kConjunctiveNegation) {
        const std::span<const Condition> inner = Write(draft.conditions);
        if (out != nullptr) {
          Point(out->id, inner.data(), inner.size());
        }
        continue;
      }
      Write(draft.id, out != nullptr ? &out->id : nullptr);
      Write(draft.attribute, out != nullptr ? &out->attribute : nullptr);
      Write(draft.value, out != nullptr ? &out->value : nullptr);
    }
    return {conditions, count};
  }

  std::span<const Action> Write(const DraftList<ActionDraft>& drafts) {
    const std::uint32_t count = drafts.Count();
    Action* const actions = Take<Action>(count);
    std::size_t n = 0;
    for (const ActionDraft& draft : drafts) {
      Action* const out = block_ == nullptr ? nullptr : &actions[n++];
      if (out != nullptr) {
        out->is_function_call = draft.is_function_call;
        out->preference = draft.preference;
      }
      Write(draft.id, out != nullptr ? &out->id : nullptr);
      Write(draft.attribute, out != nullptr ? &out->attribute : nullptr);
      Write(draft.value, out != nullptr ? &out->value : nullptr);
      Write(draft.referent, out != nullptr ? &out->referent : nullptr);
    }
    return {actions, count};
  }

  std::span<const Symbol> Write(std::span<const Symbol> symbols) {
    Symbol* const out = Take<Symbol>(symbols.size());
    if (out != nullptr) {
      std::ranges::copy(symbols, out);
    }
    return {out, symbols.size()};
  }

  std::string_view Write(std::string_view text) {
    char* const out = Take<char>(text.size());
    if (out != nullptr) {
      text.copy(out, text.size());
    }
    return {out, text.size()};
  }

 private:
  /// Room for some values, made by default; null while measuring. Everything but texts is aligned to four bytes, and
  /// texts come last.
  template <typename T>
  T* Take(std::size_t count) {
    static_assert(alignof(T) <= 4);
    const std::size_t at = used_;
    used_ += sizeof(T) * count;
    if (block_ == nullptr) {
      return nullptr;
    }
    T* const made = reinterpret_cast<T*>(block_ + at);
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

  void Write(const TestDraft& draft, Test* out) {
    if (out != nullptr) {
      out->kind = draft.kind;
      out->data_ = draft.referent.bits();
    }
    if (draft.kind == TestKind::kDisjunction) {
      const std::span<const Symbol> disjuncts = Write(std::span(draft.disjuncts, draft.disjunct_count));
      if (out != nullptr) {
        Point(*out, disjuncts.data(), disjuncts.size());
      }
    } else if (draft.kind == TestKind::kConjunction) {
      const std::uint32_t count = draft.parts.Count();
      Test* const parts = Take<Test>(count);
      std::size_t n = 0;
      for (const TestDraft& part : draft.parts) {
        Write(part, out != nullptr ? &parts[n++] : nullptr);
      }
      if (out != nullptr) {
        Point(*out, parts, count);
      }
    }
  }

  void Write(const ValueDraft& draft, RhsValue* out) {
    if (out != nullptr) {
      out->kind = draft.kind;
      out->index_ = draft.kind == RhsValueKind::kBound ? draft.site.positive_condition : draft.index;
      out->field_ = draft.site.field;
      out->data_ = draft.symbol.bits();
    }
    if (draft.kind != RhsValueKind::kFunction) {
      return;
    }
    const std::uint32_t count = draft.arguments.Count();
    std::uint32_t* const stored_count = Take<std::uint32_t>(1);
    RhsValue* const arguments = Take<RhsValue>(count);
    if (out != nullptr) {
      *stored_count = count;
      out->data_ = Distance(out, stored_count);
    }
    std::size_t n = 0;
    for (const ValueDraft& argument : draft.arguments) {
      Write(argument, out != nullptr ? &arguments[n++] : nullptr);
    }
  }

  std::byte* block_ = nullptr;
  std::size_t used_ = 0;
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
  const auto write = [&](RuleWriter& writer) {
    rule->conditions = writer.Write(draft.conditions);
    rule->actions = writer.Write(draft.actions);
    rule->new_identifiers = writer.Write(std::span(draft.new_identifiers));
    rule->name = writer.Write(draft.name);
    rule->documentation = writer.Write(draft.documentation);
  };
  RuleWriter measure;
  write(measure);
  rule->block_bytes_ = measure.bytes();
  rule->block_ = std::make_unique_for_overwrite<std::byte[]>(measure.bytes());
  RuleWriter writer(rule->block_.get());
  write(writer);
  return rule;
}

}  // namespace soarbox::kernel
