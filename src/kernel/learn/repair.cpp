// SPDX-License-Identifier: BSD-2-Clause
// Repairs learned rules with objects that are not connected to a state. In the substate, these objects were reached by
// the substate's own links.
#include <algorithm>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/learn/rule_builder.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/variable_index.h"

namespace soarbox::kernel {

namespace {

bool HasStateTest(const TestDraft& test) {
  if (test.kind == TestKind::kState) return true;
  for (const TestDraft& part : test.parts) {
    if (part.kind == TestKind::kState) return true;
  }
  return false;
}

}  // namespace

/// The first conditions are the positive ones in order of creation; the others are negated.
std::vector<Symbol> RuleBuilder::Unconnected(const DraftList<ConditionDraft>& conditions,
                                             const VariableIndex& variables) const {
  constexpr std::uint8_t kConnected = 1, kIsValue = 2, kHanging = 4;
  struct Fields {
    std::uint32_t id, attribute, value;
  };
  std::vector<std::uint8_t> what(variables.size(), 0);
  std::vector<Fields> made;
  made.reserve(made_.size());
  const auto add = [&](std::uint32_t variable, std::uint8_t flag) {
    if (variable == kNoVariable || (what[variable] & flag) != 0) return false;
    what[variable] |= flag;
    return true;
  };
  for (const ConditionDraft& condition : conditions) {
    if (made.size() == made_.size()) break;
    const Fields& fields = made.emplace_back(Fields{
        EqualityVariable(condition.id), EqualityVariable(condition.attribute), EqualityVariable(condition.value)});
    if (HasStateTest(condition.id)) add(fields.id, kConnected);
    add(fields.attribute, kIsValue);
    add(fields.value, kIsValue);
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (const Fields& fields : made) {
      if (fields.id == kNoVariable || (what[fields.id] & kConnected) == 0) continue;
      grew |= add(fields.attribute, kConnected);
      grew |= add(fields.value, kConnected);
    }
  }
  std::vector<Symbol> hanging;
  for (const bool roots_only : {true, false}) {
    for (const Fields& fields : made) {
      if (fields.id == kNoVariable || (what[fields.id] & kConnected) != 0) continue;
      if (roots_only && (what[fields.id] & kIsValue) != 0) continue;
      if (add(fields.id, kHanging)) hanging.push_back(variables.variable(fields.id));
    }
    if (!hanging.empty()) break;
  }
  return hanging;
}

bool RuleBuilder::ActionsAreGrounded() const {
  std::vector<Symbol> known;
  for (const Made& made : made_) {
    for (const TestDraft* test : {&made.draft->id, &made.draft->attribute, &made.draft->value}) {
      known.push_back(EqualitySymbol(*test));
    }
  }
  for (bool grew = true; grew;) {
    grew = false;
    for (const ActionDraft* action : actions_) {
      if (!Contains(known, action->id.symbol) || Contains(known, action->value.symbol)) continue;
      if (!action->value.symbol.IsVariable()) continue;
      known.push_back(action->value.symbol);
      grew = true;
    }
  }
  return std::ranges::all_of(actions_, [&](const ActionDraft* action) { return Contains(known, action->id.symbol); });
}

/// Depth-first search in the order in which elements are listed; visits each object once.
bool RuleBuilder::FindPath(Symbol from, Symbol to, std::vector<WmeId>& path) {
  struct Open {
    std::vector<WmeId> elements;
    std::size_t next = 0;
  };
  const WorkingMemory& memory = uses_.memory;
  visited_.assign(memory.identifier_limit(), 0);
  std::vector<Open> stack;
  path.clear();
  const auto open = [&](Symbol id) {
    visited_[id.index()] = 1;
    stack.push_back({memory.WmesOf(id), 0});
  };
  if (from == to) return true;
  open(from);
  while (!stack.empty()) {
    Open& top = stack.back();
    if (top.next == top.elements.size()) {
      stack.pop_back();
      if (!path.empty()) path.pop_back();
      continue;
    }
    const WmeId element = top.elements[top.next++];
    const Wme& wme = memory.wme(element);
    if (!wme.value.IsIdentifier() || !memory.record(element).in_match) continue;
    if (wme.value == to) {
      path.push_back(element);
      return true;
    }
    if (visited_[wme.value.index()] != 0 || memory.identifier(wme.value).is_goal) continue;
    path.push_back(element);
    open(wme.value);
  }
  return false;
}

void RuleBuilder::AddLink(WmeId element, Symbol target, Symbol target_variable) {
  const Wme& wme = uses_.memory.wme(element);
  const auto meaning = [&](Symbol symbol) {
    if (symbol == target) return target_variable;
    return symbol.IsIdentifier() ? VariableOfIdentifier(symbol) : symbol;
  };
  const Symbol id = meaning(wme.id), attribute = meaning(wme.attribute), value = meaning(wme.value);
  for (const Made& made : made_) {
    if (made.wme == element && EqualitySymbol(made.draft->id) == id && EqualitySymbol(made.draft->value) == value &&
        EqualitySymbol(made.draft->attribute) == attribute) {
      return;
    }
  }
  Made made;
  made.draft = arena_.New<ConditionDraft>();
  made.wme = element;
  made.draft->tests_acceptable = wme.acceptable;
  made.draft->id = MakeTest(TestKind::kEqual, id);
  made.draft->attribute = MakeTest(TestKind::kEqual, attribute);
  made.draft->value = MakeTest(TestKind::kEqual, value);
  made_.push_back(made);
}

Symbol RuleBuilder::IdentifierOf(Symbol variable) const {
  const auto found = std::ranges::find(identifier_of_variable_, variable, &std::pair<Symbol, Symbol>::first);
  return found == identifier_of_variable_.end() ? Symbol() : found->second;
}

bool RuleBuilder::Repair(GoalLevel results_level) {
  const WorkingMemory& memory = uses_.memory;
  std::vector<std::pair<Symbol, Symbol>> targets;  // Variable, identifier.
  const auto add = [&](Symbol variable) {
    const Symbol identifier = IdentifierOf(variable);
    if (identifier) targets.emplace_back(variable, identifier);
  };
  for (const Symbol variable : hanging_) add(variable);
  const std::size_t hanging = targets.size();
  if (!ActionsAreGrounded()) {
    for (const ActionDraft* action : actions_) {
      const Symbol variable = action->id.symbol;
      const Symbol identifier = IdentifierOf(variable);
      if (!identifier || memory.level(identifier) > results_level) continue;
      const bool tested = std::ranges::any_of(made_, [&](const Made& made) {
        return EqualitySymbol(made.draft->id) == variable || EqualitySymbol(made.draft->value) == variable;
      });
      if (!tested) add(variable);
    }
  }
  // Objects that only the result creates need no path, because the other objects lead to them.
  if (targets.empty()) return false;
  for (std::size_t n = 0; n < targets.size(); ++n) {
    const auto& [variable, identifier] = targets[n];
    const GoalLevel level = memory.level(identifier);
    if (level == 0 || level > results_level || level > uses_.goals.depth()) return false;
    std::vector<WmeId> links;
    const Symbol goal = uses_.goals.at(level).id;
    std::vector<WmeId> path;
    if (!FindPath(goal, identifier, path)) {
      if (n < hanging) return false;
      continue;
    }
    for (GoalLevel below = results_level; below > level; --below) {
      for (WmeId wme = memory.identifier(uses_.goals.at(below).id).architecture_wmes; wme != WmeId::kNone;
           wme = memory.record(wme).next) {
        if (memory.wme(wme).attribute == words::kSuperstate) links.push_back(wme);
      }
    }
    links.insert(links.end(), path.begin(), path.end());
    std::ranges::sort(links, [&](WmeId a, WmeId b) { return memory.wme(a).timetag < memory.wme(b).timetag; });
    for (const WmeId link : links) AddLink(link, identifier, variable);
  }
  if (std::ranges::none_of(made_, [](const Made& made) { return HasStateTest(made.draft->id); })) AddStateTests();
  return true;
}

}  // namespace soarbox::kernel
