// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/rule_directory.h"

#include "kernel/base/sole_owner.h"

namespace soarbox::kernel {

RuleDirectory::Tables& RuleDirectory::Own() {
  if (!IsSoleOwner(tables_)) tables_ = std::make_shared<Tables>(*tables_);
  return *tables_;
}

void RuleDirectory::Add(ProductionId rule, Symbol name, ProductionType type) {
  Tables& tables = Own();
  tables.loading_order.push_back(rule);
  if (name.index() >= tables.of_name.size()) tables.of_name.resize(name.index() + 1u, ProductionId::kNone);
  tables.of_name[name.index()] = rule;
  ++tables.counts[static_cast<std::size_t>(type)];
}

void RuleDirectory::Remove(ProductionId rule, Symbol name, ProductionType type) {
  Tables& tables = Own();
  std::erase(tables.loading_order, rule);
  tables.of_name[name.index()] = ProductionId::kNone;
  --tables.counts[static_cast<std::size_t>(type)];
}

}  // namespace soarbox::kernel
