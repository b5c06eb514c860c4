// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

#include "kernel/rules/draft.h"

namespace soarbox::kernel {

/// Numbers the variables of one rule from 0, in order of first occurrence, so that sets of them can be bit sets.
class VariableIndex {
 public:
  VariableIndex() : slots_(first_slots_) {}
  VariableIndex(const VariableIndex&) = delete;
  VariableIndex& operator=(const VariableIndex&) = delete;

  /// Returns the number of a variable; adds the variable if it is new. Returns kNoVariable for other symbols.
  std::uint32_t Add(Symbol variable) {
    const std::uint32_t slot = Slot(variable);
    if (slots_[slot] != 0) {
      return slots_[slot] - 1u;
    }
    return AddNew(variable, slot);
  }
  /// Numbers all variables of a draft and stores the numbers in it.
  void NumberAll(const DraftList<ConditionDraft>& conditions);
  void NumberAll(const DraftList<ActionDraft>& actions);

  std::uint32_t size() const { return size_; }
  Symbol variable(std::uint32_t number) const { return number < kFirst ? first_[number] : more_[number - kFirst]; }

 private:
  static constexpr std::uint32_t kFirst = 32, kFirstSlots = 64;

  std::uint32_t Slot(Symbol variable) const {
    const std::uint32_t hash = variable.index() * 0x9E3779B1u;
    std::uint32_t slot = (hash ^ hash >> 15) & mask_;
    while (slots_[slot] != 0 && this->variable(slots_[slot] - 1u) != variable) {
      slot = (slot + 1) & mask_;
    }
    return slot;
  }
  std::uint32_t AddNew(Symbol variable, std::uint32_t slot);
  void Number(TestDraft& test);
  void Number(ValueDraft& value);

  std::uint32_t size_ = 0;
  std::uint32_t mask_ = kFirstSlots - 1;
  std::uint32_t* slots_;  ///< By hash: a number plus one, or 0 if empty. At most half full.
  std::uint32_t first_slots_[kFirstSlots] = {};
  Symbol first_[kFirst];
  std::vector<Symbol> more_;
  std::vector<std::uint32_t> more_slots_;
};

/// A set of variables for rules with few variables, the usual case.
class FewVariables {
 public:
  static constexpr std::uint32_t kMost = 63;

  FewVariables(const VariableIndex&, Arena&) {}

  /// kNoVariable is the last bit, which is set only in sets of bound variables.
  bool Has(std::uint32_t variable) const { return (bits_ >> (variable % 64) & 1u) != 0; }
  void Add(std::uint32_t variable) { bits_ |= std::uint64_t{1} << (variable % 64); }
  void Remove(std::uint32_t variable) { bits_ &= ~(std::uint64_t{1} << (variable % 64)); }
  bool Covers(const FewVariables& other) const { return (other.bits_ & ~bits_) == 0; }
  bool Meets(const FewVariables& other) const { return (other.bits_ & bits_) != 0; }
  void Clear() { bits_ = 0; }
  void KeepOnly(const FewVariables& other) { bits_ &= other.bits_; }
  void Assign(const FewVariables& other) { bits_ = other.bits_; }
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    for (std::uint64_t rest = bits_; rest != 0; rest &= rest - 1) {
      visit(static_cast<std::uint32_t>(std::countr_zero(rest)));
    }
  }

 private:
  std::uint64_t bits_ = 0;
};

/// Like FewVariables, for any number of variables. Copies share their members: use Assign.
class ManyVariables {
 public:
  ManyVariables(const VariableIndex& index, Arena& arena)
      : last_(index.size()), count_(index.size() / 64 + 1), words_(arena.NewArray<std::uint64_t>(count_)) {}

  bool Has(std::uint32_t variable) const {
    const std::uint32_t bit = Bit(variable);
    return (words_[bit / 64] >> (bit % 64) & 1u) != 0;
  }
  void Add(std::uint32_t variable) { words_[Bit(variable) / 64] |= std::uint64_t{1} << (Bit(variable) % 64); }
  void Remove(std::uint32_t variable) { words_[Bit(variable) / 64] &= ~(std::uint64_t{1} << (Bit(variable) % 64)); }
  bool Covers(const ManyVariables& other) const {
    for (std::size_t n = 0; n < count_; ++n) {
      if ((other.words_[n] & ~words_[n]) != 0) {
        return false;
      }
    }
    return true;
  }
  bool Meets(const ManyVariables& other) const {
    for (std::size_t n = 0; n < count_; ++n) {
      if ((other.words_[n] & words_[n]) != 0) {
        return true;
      }
    }
    return false;
  }
  void Clear() { std::fill_n(words_, count_, 0); }
  void KeepOnly(const ManyVariables& other) {
    for (std::size_t n = 0; n < count_; ++n) {
      words_[n] &= other.words_[n];
    }
  }
  void Assign(const ManyVariables& other) { std::copy_n(other.words_, count_, words_); }
  template <typename Visit>
  void ForEach(Visit&& visit) const {
    for (std::size_t n = 0; n < count_; ++n) {
      for (std::uint64_t rest = words_[n]; rest != 0; rest &= rest - 1) {
        visit(static_cast<std::uint32_t>(64 * n + static_cast<std::size_t>(std::countr_zero(rest))));
      }
    }
  }

 private:
  std::uint32_t Bit(std::uint32_t variable) const { return std::min(variable, last_); }

  std::uint32_t last_;
  std::size_t count_;
  std::uint64_t* words_;
};

}  // namespace soarbox::kernel
