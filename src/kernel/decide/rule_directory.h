// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "kernel/base/ids.h"
#include "kernel/base/symbol.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {

/// An agent's live rules by name, by age and by type. Agents with equal rules share one copy (rule_sharing.h); an agent
/// that adds or removes a rule copies it first.
class RuleDirectory {
 public:
  /// Oldest first.
  const std::vector<ProductionId>& loading_order() const { return tables_->loading_order; }
  /// The rule whose name is this string, or kNone.
  ProductionId Named(Symbol name) const {
    const std::vector<ProductionId>& named = tables_->of_name;
    return name.index() < named.size() ? named[name.index()] : ProductionId::kNone;
  }
  std::uint32_t count(ProductionType type) const { return tables_->counts[static_cast<std::size_t>(type)]; }

  void Add(ProductionId rule, Symbol name, ProductionType type);
  void Remove(ProductionId rule, Symbol name, ProductionType type);
  /// Shares the tables of `other` if they equal its own. The symbols of the names must have the same indices in both.
  void Adopt(const RuleDirectory& other) {
    if (*tables_ == *other.tables_) tables_ = other.tables_;
  }

 private:
  struct Tables {
    std::vector<ProductionId> loading_order;
    std::vector<ProductionId> of_name;      ///< By the index of the name's string.
    std::array<std::uint32_t, 5> counts{};  ///< By ProductionType.

    friend bool operator==(const Tables&, const Tables&) = default;
  };
  Tables& Own();

  std::shared_ptr<Tables> tables_ = std::make_shared<Tables>();  ///< Changed only by a sole owner.
};

}  // namespace soarbox::kernel
