// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/rl_values.h"

#include <cstdio>
#include <cstdlib>
#include <optional>

#include "kernel/base/bump_arena.h"
#include "kernel/rules/draft.h"

namespace soarbox::kernel {
namespace {

constexpr std::string_view kUpdates = "rl-updates=";
constexpr std::string_view kH = "delta-bar-delta-h=";

/// The number after a key, up to the semicolon.
std::optional<double> NumberAfter(std::string_view text, std::string_view key) {
  const std::size_t begin = text.find(key);
  if (begin == std::string_view::npos) return {};
  const std::string rest(text.substr(begin + key.size()));
  if (rest.find(';') == std::string::npos) return {};
  char* end = nullptr;
  const double number = std::strtod(rest.c_str(), &end);
  if (end == rest.c_str()) return {};
  return number;
}

}  // namespace

RlValue& RlValues::Of(ProductionId rule, const Production& production) {
  if (RlValue* const known = Find(rule)) return *known;
  if (row_of_.size() <= Index(rule)) row_of_.resize(Index(rule) + 1u, 0);
  if (free_.empty()) {
    free_.push_back(static_cast<std::uint32_t>(rows_.size()));
    rows_.emplace_back();
  }
  RlValue& value = rows_[free_.back()];
  row_of_[Index(rule)] = free_.back() + 1;
  free_.pop_back();
  value = RlValue();
  value.rule = rule;
  value.value = production.actions.front().referent.symbol();
  if (value.value.IsNumber()) value.future = symbols_.NumberValue(value.value);
  return value;
}

void RlValues::Forget(ProductionId rule) {
  documentation_.erase(rule);
  RlValue* const value = Find(rule);
  if (value == nullptr) return;
  value->rule = ProductionId::kNone;
  value->value = Symbol();
  free_.push_back(row_of_[Index(rule)] - 1);
  row_of_[Index(rule)] = 0;
}

const std::string* RlValues::DocumentationOf(ProductionId rule) const {
  const auto found = documentation_.find(rule);
  return found == documentation_.end() ? nullptr : &found->second;
}

void RlValues::Document(const RlValue& value) {
  char text[96];
  std::snprintf(text, sizeof text, "%s%g;%s%g;", kUpdates.data(), value.updates, kH.data(), value.h);
  documentation_[value.rule] = text;
}

void RlValues::ReadDocumentation(ProductionId rule, const Production& production) {
  const std::optional<double> updates = NumberAfter(production.documentation, kUpdates);
  const std::optional<double> h = NumberAfter(production.documentation, kH);
  if (!updates && !h) return;
  RlValue& value = Of(rule, production);
  value.updates = updates.value_or(0);
  value.h = h.value_or(0);
}

ProductionPtr RlValues::AsLearned(ProductionId rule, const ProductionPtr& production) const {
  const RlValue* const learned = Find(rule);
  const std::string* const documentation = DocumentationOf(rule);
  if (learned == nullptr || production == nullptr ||
      (learned->value == production->actions.front().referent.symbol() && documentation == nullptr)) {
    return production;
  }
  Arena arena;
  RuleDraft draft = ToDraft(*production, arena);
  draft.actions.first->referent.symbol = learned->value;
  if (documentation != nullptr) {
    draft.documentation = *documentation;
    draft.has_documentation = true;
  }
  return Production::Make(draft);
}

}  // namespace soarbox::kernel
