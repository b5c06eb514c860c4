// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/identity_analysis.h"

#include <algorithm>

#include "kernel/base/known_symbols.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/learn/chunker.h"
#include "kernel/learn/singletons.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/functions/builtin_functions.h"

namespace soarbox::kernel {

namespace {

using Part = FiringReader::Part;
using Said = FiringReader::Term;
constexpr Field kFields[] = {Field::kId, Field::kAttribute, Field::kValue};

}  // namespace

IdentityGraph::Node IdentityAnalysis::OfClass(InstantiationId firing, std::uint16_t identity_class) {
  if (identity_class == IdentityPlan::kLiteral || !uses_.instantiations[firing].has_identities) {
    return IdentityGraph::kNone;
  }
  const std::uint32_t serial = uses_.instantiations[firing].serial;
  if (known_.empty()) known_.resize(std::size_t{1} << kKnownBits);
  KnownClass& known = known_[(serial * 0x9E3779B1u + identity_class * 0x85EBCA77u) >> (32u - kKnownBits)];
  if (known.analysis != analysis_ || known.serial != serial || known.identity_class != identity_class) {
    known = {analysis_, serial, identity_class, FindOrigin(firing, identity_class)};
  }
  return known.node;
}

IdentityGraph::Node IdentityAnalysis::FindOrigin(InstantiationId firing, std::uint16_t identity_class) {
  const IdentityGraph::Key key = reader_.Origin(firing, identity_class);
  if (log_) firing_of_serial_[key.firing] = firing;
  return graph_.Of(key);
}

IdentityGraph::Node IdentityAnalysis::OfField(InstantiationId firing, std::size_t condition, Field field) {
  if (!uses_.instantiations[firing].has_identities) return IdentityGraph::kNone;
  return OfClass(firing, reader_.Plan(firing).ClassOf(condition, field));
}

void IdentityAnalysis::OfCondition(const Explanation::Ground& ground, std::array<IdentityGraph::Node, 3>& out) {
  if (ground.firing == InstantiationId::kNone || !uses_.instantiations[ground.firing].has_identities) {
    for (const Field field : kFields) out[static_cast<std::size_t>(field)] = OfGround(ground, field);
    return;
  }
  const std::uint16_t* const classes = reader_.Plan(ground.firing).of_field.data() + 3u * ground.condition;
  for (std::size_t field = 0; field < 3; ++field) {
    out[field] =
        classes[field] == IdentityPlan::kLiteral ? IdentityGraph::kNone : OfClass(ground.firing, classes[field]);
  }
}

IdentityGraph::Node IdentityAnalysis::OfTerm(const Said& term, InstantiationId firing) {
  if (term.kind == Said::Kind::kClass) return OfClass(firing, term.identity_class);
  if (term.kind == Said::Kind::kSymbol) return graph_.Of(FiringReader::OfSymbol(term.symbol));
  return IdentityGraph::kNone;
}

IdentityGraph::Node IdentityAnalysis::OfGround(const Explanation::Ground& ground, Field field) {
  if (ground.firing != InstantiationId::kNone) return OfField(ground.firing, ground.condition, field);
  if (field == Field::kAttribute) return IdentityGraph::kNone;
  if (field == Field::kValue) return graph_.Of(FiringReader::Item(ground.item));
  const GoalLevel level = uses_.memory.level(uses_.memory.wme(ground.item).id);
  return graph_.Of(FiringReader::SuperstateLink(level, Part::kValue));
}

void IdentityAnalysis::Join(InstantiationId firing, IdentityGraph::Node a, IdentityGraph::Node b, JoinReason reason) {
  if (a == IdentityGraph::kNone || b == IdentityGraph::kNone || graph_.Root(a) == graph_.Root(b)) return;
  if (log_) events_.push_back({reason, firing, graph_.Root(a), graph_.Root(b)});
  graph_.Join(a, b);
}

void IdentityAnalysis::Literalize(InstantiationId firing, IdentityGraph::Node node, JoinReason reason) {
  if (node == IdentityGraph::kNone) return;
  if (log_) events_.push_back({reason, firing, graph_.Root(node), IdentityGraph::kNone});
  graph_.Literalize(node);
}

void IdentityAnalysis::LiteralizeMarked(InstantiationId firing, std::size_t condition) {
  if (firing == InstantiationId::kNone || !uses_.instantiations[firing].has_identities) return;
  const std::vector<std::uint16_t>& marked = reader_.Plan(firing).literal;
  if (marked.empty()) return;
  const Wme& wme = uses_.memory.wme(uses_.instantiations.Trace(firing)[condition].wme);
  for (const Field field : kFields) {
    const bool is_marked = std::ranges::find(marked, 3 * condition + static_cast<std::size_t>(field)) != marked.end();
    if (is_marked && !FieldOf(wme, field).IsIdentifier()) {
      Literalize(firing, OfField(firing, condition, field), JoinReason::kMarkedLiteral);
    }
  }
}

void IdentityAnalysis::LiteralizeArguments(const RhsValue& function, InstantiationId firing, InstantiationId tester) {
  // Arguments of functions that do not literalize, such as concat, stay variables. This is over-general, but equals
  // Soar.
  if (!BuiltinFunctions()[function.function_index()].literalizes) return;
  for (const RhsValue& argument : function.arguments()) {
    if (argument.kind == RhsValueKind::kFunction) {
      LiteralizeArguments(argument, firing, tester);
    } else if (argument.kind == RhsValueKind::kBound) {
      const ConditionTrace& trace = uses_.instantiations.Trace(firing)[argument.site().positive_condition];
      if (FieldOf(uses_.memory.wme(trace.wme), argument.site().field).IsIdentifier()) continue;
      Literalize(tester, OfClass(firing, reader_.ClassOf(argument, firing)), JoinReason::kFunctionArgument);
    }
  }
}

void IdentityAnalysis::FollowLink(const Explanation::Link& link) {
  if (!uses_.instantiations[link.firing].has_identities) return;
  const InstantiationId maker = uses_.memory.preference(link.maker).instantiation;
  const IdentityPlan& plan = reader_.Plan(link.firing);
  for (const Field field : kFields) {
    const Said made = reader_.TermOf(link.maker, static_cast<Part>(field));
    if (made.kind == Said::Kind::kUnknown) return;
    const std::uint16_t tested = plan.ClassOf(link.condition, field);
    const bool tests_constant = tested == IdentityPlan::kLiteral;
    switch (made.kind) {
      case Said::Kind::kClass:
      case Said::Kind::kSymbol:
        if (tests_constant) {
          Literalize(link.firing, OfTerm(made, maker), JoinReason::kConstantTested);
        } else {
          Join(link.firing, OfTerm(made, maker), OfClass(link.firing, tested), JoinReason::kRule);
        }
        break;
      case Said::Kind::kLiteral:
        if (!tests_constant) Literalize(link.firing, OfClass(link.firing, tested), JoinReason::kConstantMade);
        break;
      case Said::Kind::kFunction:
        LiteralizeArguments(*made.function, maker, link.firing);
        if (!tests_constant) Literalize(link.firing, OfClass(link.firing, tested), JoinReason::kFunctionResult);
        break;
      case Said::Kind::kUnknown:
        break;
    }
  }
}

void IdentityAnalysis::JoinSingletons(const Explanation& explanation) {
  first_ground_.clear();
  for (auto ground = explanation.grounds.rbegin(); ground != explanation.grounds.rend(); ++ground) {
    const auto [known, is_new] = first_ground_.try_emplace(Index(ground->wme), &*ground);
    if (is_new) continue;
    const Wme& wme = uses_.memory.wme(ground->wme);
    if (!uses_.singletons.Fits(ground->wme)) continue;
    const InstantiationId firing = ground->firing != InstantiationId::kNone ? ground->firing : explanation.base;
    const auto is_literal = [&](const Explanation::Ground& of) {
      return of.firing != InstantiationId::kNone && uses_.instantiations[of.firing].has_identities &&
             reader_.Plan(of.firing).ClassOf(of.condition, Field::kValue) == IdentityPlan::kLiteral;
    };
    const Explanation::Ground& other = *known->second;
    const IdentityGraph::Node a = OfGround(other, Field::kValue), b = OfGround(*ground, Field::kValue);
    if (!wme.value.IsIdentifier() && (is_literal(*ground) || is_literal(other))) {
      Literalize(firing, a, JoinReason::kSingletonLiteral);
      Literalize(firing, b, JoinReason::kSingletonLiteral);
    } else {
      Join(firing, b, a, JoinReason::kSingleton);
    }
  }
}

std::uint32_t IdentityAnalysis::CountLiteralized() const {
  return static_cast<std::uint32_t>(std::ranges::count_if(events_, [](const JoinEvent& event) {
    return event.to == IdentityGraph::kNone && event.reason != JoinReason::kSingletonLiteral;
  }));
}

std::uint32_t IdentityAnalysis::NumberOfOwn(IdentityGraph::Node node) {
  const IdentityGraph::Key key = graph_.key(node);
  if (FiringReader::IsSuperstateLink(key) || FiringReader::IsItem(key)) return uses_.chunker.NumberOfSpecial(key);
  const auto found = firing_of_serial_.find(key.firing);
  if (found == firing_of_serial_.end()) return 0;
  const InstantiationId firing = found->second;
  const IdentityPlan& plan = reader_.Plan(firing);
  std::uint32_t number = uses_.instantiations[firing].first_identity;
  for (std::uint16_t n = 0; n < plan.bound() && n < key.place; ++n) {
    number += reader_.SourceOf(firing, plan.first[n]) == FiringReader::Source::kOwn;
  }
  return key.place < plan.bound()
             ? number
             : number + reader_.RankOfNew(firing, static_cast<std::uint16_t>(key.place - plan.bound()));
}

void IdentityAnalysis::Analyze(const Explanation& explanation, bool log) {
  graph_.Clear();
  ++analysis_;
  events_.clear();
  firing_of_serial_.clear();
  log_ = log;
  for (const Explanation::Link& test : explanation.superstate_links) {
    const GoalLevel level = uses_.instantiations[test.firing].level;
    if (!uses_.goals.at(level).has_identities) continue;
    for (const Field field : {Field::kId, Field::kValue}) {
      const IdentityGraph::Node tested = OfField(test.firing, test.condition, field);
      if (tested == IdentityGraph::kNone) continue;
      Join(test.firing, tested, graph_.Of(FiringReader::SuperstateLink(level, static_cast<Part>(field))),
           JoinReason::kRule);
    }
  }
  for (const Explanation::ItemTest& test : explanation.item_tests) {
    const IdentityGraph::Node tested = OfField(test.firing, test.condition, Field::kValue);
    if (tested != IdentityGraph::kNone) {
      Join(test.firing, tested, graph_.Of(FiringReader::Item(test.item)), JoinReason::kRule);
    }
  }
  for (const Explanation::Link& link : explanation.links) {
    FollowLink(link);
    LiteralizeMarked(link.firing, link.condition);
  }
  for (const Explanation::Ground& ground : explanation.grounds) LiteralizeMarked(ground.firing, ground.condition);
  for (const Explanation::Child& child : explanation.children) {
    const Said id = reader_.TermOf(child.child, Part::kId);
    const Said of = reader_.TermOf(child.parent, child.by_referent ? Part::kReferent : Part::kValue);
    const InstantiationId parent = uses_.memory.preference(child.parent).instantiation;
    Join(parent, OfTerm(id, uses_.memory.preference(child.child).instantiation), OfTerm(of, parent),
         JoinReason::kChild);
  }
  JoinSingletons(explanation);
}

}  // namespace soarbox::kernel
