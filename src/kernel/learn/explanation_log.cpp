// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/learn/explanation_log.h"

#include <algorithm>
#include <set>
#include <utility>

#include "kernel/base/known_symbols.h"
#include "kernel/base/symbol_table.h"
#include "kernel/decide/agent_counters.h"
#include "kernel/decide/descriptions.h"
#include "kernel/decide/goal_stack.h"
#include "kernel/decide/instantiation_table.h"
#include "kernel/learn/chunker.h"
#include "kernel/learn/draft_tests.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/match/rete.h"
#include "kernel/memory/working_memory.h"
#include "kernel/rules/print_production.h"

namespace soarbox::kernel {

namespace {

constexpr Field kAllFields[] = {Field::kId, Field::kAttribute, Field::kValue};

const Test& TestOf(const Condition& condition, Field field) {
  return field == Field::kId ? condition.id : field == Field::kAttribute ? condition.attribute : condition.value;
}

/// Returns "{ part part }" if there are several parts.
std::string Joined(const std::vector<std::string>& parts) {
  if (parts.size() == 1) return parts.front();
  std::string text = "{";
  for (const std::string& part : parts) text += " " + part;
  return text + " }";
}

/// The shortest path from each firing to one that created a result, as "i 3 (rule)". Firings that were only relevant
/// for selections have no path.
class ShortestPaths {
 public:
  ShortestPaths(const InstantiationTable& instantiations, const WorkingMemory& memory, const Chunker& chunker,
                const Explanation& explanation)
      : instantiations_(instantiations), chunker_(chunker) {
    std::vector<InstantiationId> wave;
    const auto begin = [&](InstantiationId firing) {
      if (next_.try_emplace(SerialOf(firing), 0).second) wave.push_back(firing);
    };
    // Among paths of equal length, the one that backtracing found first is used.
    for (auto result = explanation.results.rbegin(); result != explanation.results.rend(); ++result) {
      begin(memory.preference(*result).instantiation);
    }
    begin(explanation.base);
    while (!wave.empty()) {
      std::vector<InstantiationId> following;
      for (const InstantiationId firing : wave) {
        for (const Explanation::Link& link : explanation.links) {
          if (link.firing != firing) continue;
          const InstantiationId maker = memory.preference(link.maker).instantiation;
          if (next_.try_emplace(SerialOf(maker), SerialOf(firing)).second) following.push_back(maker);
        }
        for (const Explanation::ItemTest& test : explanation.item_tests) {
          if (test.firing == firing) next_.try_emplace(SerialOf(test.item), SerialOf(firing));
        }
      }
      wave = std::move(following);
    }
  }
  /// The path from a firing, or from the firing for an item.
  template <typename Begin>
  std::vector<std::uint32_t> From(Begin begin) const {
    std::vector<std::uint32_t> path;
    for (auto found = next_.find(SerialOf(begin)); found != next_.end(); found = next_.find(found->second)) {
      path.push_back(found->first);
    }
    return path;
  }

 private:
  std::uint32_t SerialOf(InstantiationId firing) const { return instantiations_[firing].serial; }
  std::uint32_t SerialOf(WmeId item) const {
    const Chunker::ItemFiring* const firing = chunker_.FiringOfItem(item);
    return firing != nullptr ? firing->serial : 0;
  }
  const InstantiationTable& instantiations_;
  const Chunker& chunker_;
  std::map<std::uint32_t, std::uint32_t> next_;
};

}  // namespace

void ExplanationLog::Clear() {
  for (const ExplainedRule& rule : rules_) bytes_ -= rule.MemoryBytes();
  rules_.clear();
  explained_firings_.clear();
  watched_learned.clear();
  last_number_ = 0;
}

bool ExplanationLog::WantsChunkOf(InstantiationId base) const {
  if (all) return true;
  const Production* const rule = reader_.Rule(base);
  if (rule == nullptr) return false;
  return rule->explain || std::ranges::find(watched, rule->name) != watched.end() ||
         std::ranges::find(watched_learned, rule->name) != watched_learned.end();
}

std::string ExplanationLog::Name(Symbol symbol) const {
  return symbol ? ToString(uses_.symbols, symbol) : std::string("<?>");
}

/// Constants are returned as their own text.
std::string ExplanationLog::NumberOfVariable(Symbol symbol) const {
  const auto found = number_of_variable_.find(symbol.bits());
  return found == number_of_variable_.end() ? Name(symbol) : "[" + std::to_string(found->second) + "]";
}

std::string ExplanationLog::Number(IdentityGraph::Node node) {
  return "[" + std::to_string(analysis_.NumberOf(node)) + "]";
}

std::vector<std::string> ExplanationLog::Comparisons(const Test& test, bool with_state,
                                                     const std::function<std::string(const Test&)>& referent) const {
  std::vector<std::string> texts;
  ForEachTest(test, [&](const Test& part) {
    if (part.kind == TestKind::kState && with_state) texts.emplace_back("state");
    if (!IsCarried(part.kind)) return;
    if (part.kind == TestKind::kDisjunction) {
      AppendTest(texts.emplace_back(), uses_.symbols, part);
    } else {
      texts.push_back(std::string(ComparisonSign(part.kind)) + referent(part));
    }
  });
  return texts;
}

ExplainedRule::Field ExplanationLog::DescribeTest(const Test* test, Symbol value, InstantiationId firing,
                                                  std::size_t condition, Field field) {
  ExplainedRule::Field out;
  out.value = Name(value);
  const IdentityGraph::Node node = analysis_.OfField(firing, condition, field);
  const std::string own = node == IdentityGraph::kNone ? out.value : Number(node);
  if (node != IdentityGraph::kNone) out.number = analysis_.NumberOf(node);
  if (test == nullptr) {
    out.text = out.value;
    out.identity = own;
    return out;
  }
  const IdentityPlan& plan = reader_.Plan(firing);
  std::vector<std::string> texts = Comparisons(*test, true, [&](const Test& part) { return Name(part.referent()); });
  std::vector<std::string> identities = Comparisons(*test, false, [&](const Test& part) {
    const IdentityGraph::Node other =
        part.referent().IsVariable() ? analysis_.OfClass(firing, plan.ClassOf(part.referent())) : IdentityGraph::kNone;
    return other != IdentityGraph::kNone ? Number(other) : Name(part.referent());
  });
  std::vector<std::string> values = Comparisons(*test, false, [&](const Test& part) {
    const std::uint16_t bound =
        part.referent().IsVariable() ? plan.ClassOf(part.referent()) : std::uint16_t{IdentityPlan::kLiteral};
    return Name(bound == IdentityPlan::kLiteral
                    ? part.referent()
                    : ValueOfClass(plan, bound, uses_.instantiations.Trace(firing), uses_.memory));
  });
  const Symbol equal = EqualitySymbol(*test);
  texts.push_back(equal ? Name(equal) : std::string("<?>"));
  identities.push_back(own);
  values.push_back(out.value);
  out.text = Joined(texts);
  out.identity = Joined(identities);
  out.value = Joined(values);
  return out;
}

ExplainedRule::Action ExplanationLog::DescribeAction(PreferenceId id, bool own) {
  const Preference& preference = uses_.memory.preference(id);
  const Production* const rule = reader_.Rule(preference.instantiation);
  ExplainedRule::Action out;
  out.type = preference.type;
  const auto describe = [&](FiringReader::Part part, Symbol symbol, const RhsValue* term) {
    ExplainedRule::Field field;
    if (!symbol) return field;
    field.value = Name(symbol);
    const FiringReader::Term made = reader_.TermOf(id, part);
    const IdentityGraph::Node node = analysis_.OfTerm(made, preference.instantiation);
    if (node != IdentityGraph::kNone) field.number = analysis_.NumberOf(node);
    field.identity = node == IdentityGraph::kNone ? "[" + field.value + "]" : Number(node);
    if (made.kind == FiringReader::Term::Kind::kFunction && !symbol.IsIdentifier()) {
      field.identity = "[" + FunctionText(*made.function, preference.instantiation, own) + "]";
    }
    if (own && node != IdentityGraph::kNone) {
      const std::uint32_t before = analysis_.NumberOfOwn(node);
      if (before != field.number) field.identity.insert(1, std::to_string(before) + "->");
    }
    field.text = field.value;
    if (term != nullptr) {
      field.text.clear();
      AppendRhsValue(field.text, uses_.symbols, *term);
    }
    return field;
  };
  const Action* const action =
      rule != nullptr && preference.action < rule->actions.size() ? &rule->actions[preference.action] : nullptr;
  using Part = FiringReader::Part;
  out.id = describe(FiringReader::Part::kId, preference.id, action ? &action->id : nullptr);
  out.attribute = describe(Part::kAttribute, preference.attribute, action ? &action->attribute : nullptr);
  out.value = describe(Part::kValue, preference.value, action ? &action->value : nullptr);
  out.referent = describe(Part::kReferent, preference.referent, action ? &action->referent : nullptr);
  return out;
}

/// The text of a function with the identities of its arguments, or with their values.
std::string ExplanationLog::FunctionText(const RhsValue& function, InstantiationId firing, bool identities) {
  std::string text;
  AppendRhsValue(text, uses_.symbols, function);
  text.resize(text.find_first_of(" )"));
  for (const RhsValue& argument : function.arguments()) {
    text += ' ';
    if (argument.kind == RhsValueKind::kFunction) {
      text += FunctionText(argument, firing, identities);
      continue;
    }
    const std::uint16_t bound =
        argument.kind == RhsValueKind::kBound ? reader_.ClassOf(argument, firing) : IdentityPlan::kLiteral;
    const IdentityGraph::Node node = analysis_.OfClass(firing, bound);
    if (node == IdentityGraph::kNone) {
      AppendRhsValue(text, uses_.symbols, argument);
    } else if (identities) {
      const std::uint32_t before = analysis_.NumberOfOwn(node), after = analysis_.NumberOf(node);
      text += "[";
      if (before != after) text += std::to_string(before) + "->";
      text += "v" + std::to_string(after) + "c0]";
    } else {
      text += Name(ValueOfClass(reader_.Plan(firing), bound, uses_.instantiations.Trace(firing), uses_.memory));
    }
  }
  return text + ")";
}

ExplainedRule::Firing ExplanationLog::Describe(InstantiationId id, const Explanation& explanation) {
  const Instantiation& instantiation = uses_.instantiations[id];
  const Production* const rule = reader_.Rule(id);
  ExplainedRule::Firing out;
  out.serial = instantiation.serial;
  out.rule = uses_.descriptions.ProductionName(id);
  out.level = instantiation.level;
  const std::span<const ConditionTrace> traces = uses_.instantiations.Trace(id);
  const auto describe = [&](std::size_t n, const Condition* source) {
    const Wme& wme = uses_.memory.wme(traces[n].wme);
    ExplainedRule::Condition condition;
    condition.acceptable = wme.acceptable;
    condition.operational = uses_.memory.level(wme.id) < explanation.level;
    for (const Field field : kAllFields) {
      ExplainedRule::Field& part = field == Field::kId          ? condition.id
                                   : field == Field::kAttribute ? condition.attribute
                                                                : condition.value;
      part = DescribeTest(source != nullptr ? &TestOf(*source, field) : nullptr, FieldOf(wme, field), id, n, field);
    }
    if (source != nullptr) {
      ForEachTest(source->id, [&](const Test& part) { condition.tests_state |= part.kind == TestKind::kState; });
    }
    if (!condition.operational && traces[n].preference != PreferenceId::kNone) {
      const InstantiationId maker = uses_.memory.preference(traces[n].preference).instantiation;
      condition.creator = uses_.instantiations[maker].serial;
      condition.creator_rule = uses_.descriptions.ProductionName(maker);
    } else if (const Chunker::ItemFiring* const maker = uses_.chunker.FiringOfItem(traces[n].wme);
               maker != nullptr && !condition.operational) {
      condition.creator = maker->serial;
      condition.creator_rule = Descriptions::kNoRule;
    }
    out.conditions.push_back(std::move(condition));
  };
  if (rule == nullptr) {
    for (std::size_t n = 0; n < traces.size(); ++n) describe(n, nullptr);
  } else {
    std::size_t positive = 0;
    for (const Condition& source : rule->conditions) {
      if (source.kind == ConditionKind::kPositive) {
        if (positive < traces.size()) describe(positive, &source);
        ++positive;
      } else {
        const ProductionPtr literal = Instantiated(source, id);
        out.conditions.push_back(DescribeNegated(source, source, literal->conditions.front(), id, explanation.level));
      }
    }
    // The copied elements follow.
    for (; positive < traces.size(); ++positive) describe(positive, nullptr);
  }
  for (PreferenceId p = instantiation.preferences; p != PreferenceId::kNone;
       p = uses_.memory.preference(p).next_of_instantiation) {
    const bool is_result = std::ranges::find(explanation.results, p) != explanation.results.end();
    out.actions.push_back(DescribeAction(p, true));
    out.made_result |= is_result;
  }
  std::ranges::reverse(out.actions);
  return out;
}

/// The firing of an item tests the operator's proposal in the superstate and the substate's link to the superstate.
ExplainedRule::Firing ExplanationLog::Describe(WmeId item, std::uint32_t serial, const Explanation& explanation) {
  ExplainedRule::Firing out;
  out.serial = serial;
  out.rule = Descriptions::kNoRule;
  out.level = explanation.level;
  const Wme& wme = uses_.memory.wme(item);
  const Symbol superstate = uses_.goals.at(static_cast<GoalLevel>(explanation.level - 1)).id;
  const auto field = [&](Symbol value, IdentityGraph::Node node) {
    ExplainedRule::Field described;
    described.text = described.value = Name(value);
    described.identity = node == IdentityGraph::kNone ? described.value : Number(node);
    if (node != IdentityGraph::kNone) described.number = analysis_.NumberOf(node);
    return described;
  };
  const IdentityGraph::Node state =
      analysis_.graph().Of(FiringReader::SuperstateLink(explanation.level, FiringReader::Part::kId));
  const IdentityGraph::Node above =
      analysis_.graph().Of(FiringReader::SuperstateLink(explanation.level, FiringReader::Part::kValue));
  const IdentityGraph::Node op = analysis_.graph().Of(FiringReader::Item(item));
  ExplainedRule::Condition proposal, link;
  proposal.id = field(superstate, above);
  proposal.attribute = field(words::kOperator, IdentityGraph::kNone);
  proposal.value = field(wme.value, op);
  proposal.acceptable = proposal.operational = true;
  link.id = field(wme.id, state);
  link.attribute = field(words::kSuperstate, IdentityGraph::kNone);
  link.value = field(superstate, above);
  out.conditions = {std::move(proposal), std::move(link)};
  ExplainedRule::Action action;
  action.id = field(wme.id, state);
  action.attribute = field(words::kItem, IdentityGraph::kNone);  // Also for non-numeric items.
  action.value = field(wme.value, op);
  out.actions.push_back(std::move(action));
  return out;
}

ProductionPtr ExplanationLog::Instantiated(const Condition& negation, InstantiationId firing) {
  Arena arena;
  ConditionDraft literal =
      InstantiateNegation(negation, *uses_.rete.production(uses_.instantiations[firing].production),
                          uses_.instantiations.Trace(firing), uses_.memory, arena);
  RuleDraft rule;
  rule.conditions.Add(&literal);
  return Production::Make(rule);
}

std::string ExplanationLog::IdentityText(const Test& test, InstantiationId firing) {
  std::vector<std::string> parts;
  ForEachTest(test, [&](const Test& part) {
    if (part.kind == TestKind::kState || part.kind == TestKind::kImpasse) return;
    std::string text;
    if (part.kind == TestKind::kDisjunction || part.kind == TestKind::kBlank) {
      AppendTest(text, uses_.symbols, part);
    } else {
      text = ComparisonSign(part.kind);
      IdentityGraph::Node node = IdentityGraph::kNone;
      if (part.referent().IsVariable() && reader_.Rule(firing) != nullptr) {
        node = analysis_.OfClass(firing, reader_.Plan(firing).ClassOf(part.referent()));
      }
      text += node == IdentityGraph::kNone ? Name(part.referent()) : Number(node);
      if (node != IdentityGraph::kNone) negated_identities_.push_back(analysis_.NumberOf(node));
    }
    parts.push_back(std::move(text));
  });
  return parts.empty() ? std::string() : Joined(parts);
}

ExplainedRule::Condition ExplanationLog::DescribeNegated(const Condition& written, const Condition& source,
                                                         const Condition& literal, InstantiationId firing,
                                                         GoalLevel level) {
  ExplainedRule::Condition out;
  out.negated = true;
  out.conjunction = written.kind == ConditionKind::kConjunctiveNegation;
  AppendCondition(out.id.text, uses_.symbols, written);
  const auto add = [&](auto&& self, const Condition& as_written, const Condition& as_source,
                       const Condition& as_literal) -> void {
    if (as_written.kind == ConditionKind::kConjunctiveNegation) {
      const std::size_t count =
          std::min({as_written.conditions().size(), as_source.conditions().size(), as_literal.conditions().size()});
      for (std::size_t n = 0; n < count; ++n) {
        self(self, as_written.conditions()[n], as_source.conditions()[n], as_literal.conditions()[n]);
      }
      return;
    }
    const std::string_view sign = out.conjunction ? " ^" : " -^";
    const auto row = [&](const Condition& condition, auto&& text_of) {
      return "(" + text_of(condition.id) + std::string(sign) + text_of(condition.attribute) + " " +
             text_of(condition.value) + (condition.tests_acceptable ? " +" : "") + ")";
    };
    const auto plain = [&](const Test& test) {
      std::string text;
      AppendTest(text, uses_.symbols, test);
      return text;
    };
    ExplainedRule::Condition::Part& part = out.parts.emplace_back();
    part.text = row(as_written, plain);
    part.identity = row(as_source, [&](const Test& test) { return IdentityText(test, firing); });
    part.value = row(as_literal, plain);
    const Symbol object = EqualitySymbol(as_literal.id);
    part.operational = (object.IsIdentifier() ? uses_.memory.level(object) : 0) < level;
  };
  add(add, written, source, literal);
  return out;
}

/// Describes the conditions and actions of the learned rule, with the identities of their origins.
void ExplanationLog::DescribeLearned(ExplainedRule& out, const Explanation& explanation) {
  const ShortestPaths paths(uses_.instantiations, uses_.memory, uses_.chunker, explanation);
  negated_identities_.clear();
  const auto describe = [&](std::uint32_t index, const Condition* learned) {
    ExplainedRule::Condition condition;
    const bool known = index < explanation.grounds.size();
    const Explanation::Ground ground = known ? explanation.grounds[index] : Explanation::Ground{};
    if (known && ground.firing != InstantiationId::kNone) {
      const Production* const rule = reader_.Rule(ground.firing);
      const Condition* const source =
          rule != nullptr ? reader_.TestedBy(ground.firing, ground.condition).condition : nullptr;
      const Wme& wme = uses_.memory.wme(ground.wme);
      for (const Field field : kAllFields) {
        ExplainedRule::Field& part = field == Field::kId          ? condition.id
                                     : field == Field::kAttribute ? condition.attribute
                                                                  : condition.value;
        part = DescribeTest(source != nullptr ? &TestOf(*source, field) : nullptr, FieldOf(wme, field), ground.firing,
                            ground.condition, field);
        // Constants of the rule, and variables that learning literalized.
        if (learned != nullptr && !EqualitySymbol(TestOf(*learned, field)).IsVariable()) {
          part.identity = Name(FieldOf(wme, field));
          part.number = 0;
        }
        if (learned == nullptr) {
          std::vector<std::string> texts;
          if (source != nullptr) {
            ForEachTest(TestOf(*source, field), [&](const Test& test) {
              if (test.kind != TestKind::kDisjunction && IsCarried(test.kind) && !test.referent().IsVariable()) {
                texts.push_back(std::string(ComparisonSign(test.kind)) + Name(test.referent()));
              }
            });
          }
          texts.push_back(Name(FieldOf(wme, field)));
          part.text = Joined(texts);
        }
      }
      condition.path = paths.From(ground.firing);
      condition.acceptable = wme.acceptable;
      condition.operational = true;
    } else if (known) {
      condition.path = paths.From(ground.item);
      for (const Field field : {Field::kId, Field::kValue}) {
        const IdentityGraph::Node node = analysis_.OfGround(ground, field);
        (field == Field::kId ? condition.id : condition.value).number = analysis_.NumberOf(node);
      }
    }
    if (learned != nullptr) {
      // The tests of the learned rule. The equality test is first in the rule's text, but last in the text with
      // identities.
      const auto describe_test = [&](const Test& test, ExplainedRule::Field& into, bool& state) {
        const Symbol equal = EqualitySymbol(test);
        std::vector<std::string> texts =
            Comparisons(test, true, [&](const Test& part) { return Name(part.referent()); });
        std::vector<std::string> identities =
            Comparisons(test, true, [&](const Test& part) { return NumberOfVariable(part.referent()); });
        bool compares_with_itself = false;
        ForEachTest(test, [&](const Test& part) {
          state |= part.kind == TestKind::kState;
          compares_with_itself |=
              IsCarried(part.kind) && part.kind != TestKind::kDisjunction && part.referent() == equal;
        });
        texts.insert(compares_with_itself ? texts.end() : texts.begin(), Name(equal));
        identities.push_back(NumberOfVariable(equal));
        into.text = Joined(texts);
        into.identity = Joined(identities);
      };
      bool ignored = false;
      describe_test(learned->id, condition.id, condition.tests_state);
      describe_test(learned->attribute, condition.attribute, ignored);
      describe_test(learned->value, condition.value, ignored);
    }
    return condition;
  };
  number_of_variable_.clear();
  if (out.rule != nullptr) {
    // The identity and the value of each variable of the finished rule.
    std::map<std::uint32_t, Symbol> value_of_variable;
    const auto matched = [&](const Test& test, Symbol value) {
      std::vector<std::string> texts = Comparisons(test, false, [&](const Test& part) {
        const auto found = value_of_variable.find(part.referent().bits());
        return Name(found != value_of_variable.end() ? found->second : part.referent());
      });
      texts.push_back(Name(value));
      return Joined(texts);
    };
    std::size_t place = 0;
    for (const Condition& learned : out.rule->conditions) {
      if (learned.kind != ConditionKind::kPositive) continue;
      const Wme& wme = uses_.memory.wme(builder_.elements()[place]);
      for (const Field field : kAllFields) {
        const Symbol variable = EqualitySymbol(TestOf(learned, field));
        if (variable.IsVariable()) value_of_variable.try_emplace(variable.bits(), FieldOf(wme, field));
      }
      const std::uint32_t index = builder_.ground_of_condition()[place++];
      if (index >= explanation.grounds.size()) continue;
      for (const Field field : kAllFields) {
        const Symbol variable = EqualitySymbol(TestOf(learned, field));
        const IdentityGraph::Node node = analysis_.OfGround(explanation.grounds[index], field);
        if (!variable.IsVariable() || node == IdentityGraph::kNone) continue;
        number_of_variable_.try_emplace(variable.bits(), analysis_.NumberOf(node));
      }
    }
    std::size_t positive = 0, negated = 0;
    for (const Condition& learned : out.rule->conditions) {
      if (learned.kind == ConditionKind::kPositive) {
        const Wme& wme = uses_.memory.wme(builder_.elements()[positive]);
        out.conditions.push_back(describe(builder_.ground_of_condition()[positive++], &learned));
        ExplainedRule::Condition& described = out.conditions.back();
        described.id.value = matched(learned.id, wme.id);
        described.attribute.value = matched(learned.attribute, wme.attribute);
        described.value.value = matched(learned.value, wme.value);
        described.acceptable = wme.acceptable;
        described.above_own = uses_.memory.level(wme.id) < out.instance_level;
        const WmeRecord& record = uses_.memory.record(builder_.elements()[positive - 1]);
        if (out.instance_level > 1 && !described.above_own && !record.removing &&
            record.preference != PreferenceId::kNone) {
          const InstantiationId maker = uses_.memory.preference(record.preference).instantiation;
          described.creator = uses_.instantiations[maker].serial;
          described.creator_rule = uses_.descriptions.ProductionName(maker);
        }
        continue;
      }
      const Explanation::Negation& negation = explanation.negations[builder_.negation_of_condition()[negated++]];
      ConditionDraft copy = negation.literal;
      RuleDraft literal;
      literal.conditions.Add(&copy);
      const ProductionPtr was = Production::Make(literal);
      const Condition& source = negation.source != nullptr ? *negation.source : was->conditions.front();
      out.conditions.push_back(
          DescribeNegated(learned, source, was->conditions.front(), negation.firing, out.instance_level));
      ExplainedRule::Condition& described = out.conditions.back();
      described.path = described.conjunction ? std::vector<std::uint32_t>{out.instance} : paths.From(negation.firing);
    }
  } else {
    std::set<std::uint32_t> states;
    for (std::uint32_t n = 0; n < explanation.grounds.size(); ++n) {
      out.conditions.push_back(describe(n, nullptr));
      const Symbol id = uses_.memory.wme(explanation.grounds[n].wme).id;
      out.conditions.back().tests_state = uses_.memory.identifier(id).is_goal && states.insert(id.bits()).second;
    }
  }
  // As in Soar 9.6.3, the rule's actions are in its own order, but their identities are in the order of the results.
  for (std::size_t n = explanation.results.size(); n-- > 0;) {
    ExplainedRule::Action action = DescribeAction(explanation.results[n], false);
    const Action* const learned =
        out.rule != nullptr ? &out.rule->actions[explanation.results.size() - n - 1] : nullptr;
    const auto text = [&](ExplainedRule::Field& field, const RhsValue* term) {
      field.text = field.value;
      if (term == nullptr) return;
      field.text.clear();
      AppendRhsValue(field.text, uses_.symbols, *term);
      if (field.number == 0 && !field.identity.starts_with("[(")) field.identity = "[" + field.text + "]";
    };
    text(action.id, learned ? &learned->id : nullptr);
    text(action.attribute, learned ? &learned->attribute : nullptr);
    text(action.value, learned ? &learned->value : nullptr);
    if (!action.referent.value.empty()) {
      text(action.referent, learned != nullptr && learned->HasReferent() ? &learned->referent : nullptr);
    }
    out.actions.push_back(std::move(action));
  }
  std::set<std::uint32_t> identities(negated_identities_.begin(), negated_identities_.end());
  for (const ExplainedRule::Condition& condition : out.conditions) {
    for (const ExplainedRule::Field* field : {&condition.id, &condition.attribute, &condition.value}) {
      if (field->number != 0) identities.insert(field->number);
    }
  }
  out.identities.assign(identities.begin(), identities.end());
}

void ExplanationLog::Add(const Explanation& explanation, std::uint32_t number, const Made& made) {
  ExplainedRule& out = rules_.emplace_back();
  out.number = number;
  Describe(out, explanation, made);
  // As in Soar 9.6.3, paths are shown only from firings that are in no earlier explanation.
  const auto drop_known = [&](std::vector<std::uint32_t>& path) {
    if (!path.empty() && explained_firings_.contains(path.front())) path.clear();
  };
  for (ExplainedRule::Condition& condition : out.conditions) drop_known(condition.path);
  for (ExplainedRule::Firing& firing : out.firings) drop_known(firing.path);
  for (const ExplainedRule::Firing& firing : out.firings) explained_firings_.insert(firing.serial);
  bytes_ += out.MemoryBytes();
  // These counters of `chunk stats` include only recorded rules.
  uses_.statistics.identities_in_rules += out.identities.size();
}

void ExplanationLog::Note(const Explanation& explanation, const Made& made) {
  Describe(noted_.emplace_back(), explanation, made);
  bytes_ += noted_.back().MemoryBytes();
  if (noted_.size() <= kMostNoted) return;
  bytes_ -= noted_.front().MemoryBytes();
  noted_.pop_front();
}

void ExplanationLog::Describe(ExplainedRule& out, const Explanation& explanation, const Made& made) {
  out.name = made.name;
  out.rule = made.rule;
  out.justification = made.rule == nullptr;
  if (made.instance != InstantiationId::kNone) out.instance = uses_.instantiations[made.instance].serial;
  out.instance_level = made.level;
  out.decision = uses_.counters.decision_phases;
  out.level = explanation.level;
  if (explanation.level > 1) {
    const Goal& goal = uses_.goals.at(explanation.level);
    const Goal& above = uses_.goals.at(static_cast<GoalLevel>(explanation.level - 1));
    out.state = Name(goal.id);
    out.superstate = Name(above.id);
    out.impasse = goal.impasse;
    out.on_operator = goal.impasse_on_operator;
    const Symbol selected = uses_.descriptions.OperatorOf(above), attribute = uses_.symbols.FindString("name");
    const Symbol name_of_it = selected && attribute ? uses_.memory.ValueOf(selected, attribute) : Symbol();
    if (name_of_it) out.op = Name(name_of_it);
  }
  out.base = uses_.instantiations[explanation.base].serial;
  out.local_negation = explanation.local_negation;
  out.quiescence = explanation.quiescence;
  out.long_term_memory = explanation.long_term_memory;
  out.repaired = made.repaired;
  DescribeLearned(out, explanation);
  for (const PreferenceId result : explanation.results) {
    const std::uint32_t serial = uses_.instantiations[uses_.memory.preference(result).instantiation].serial;
    if (serial != out.base && std::ranges::find(out.other_results, serial) == out.other_results.end()) {
      out.other_results.push_back(serial);
    }
  }
  const ShortestPaths paths(uses_.instantiations, uses_.memory, uses_.chunker, explanation);
  for (const InstantiationId firing : explanation.firings) {
    ExplainedRule::Firing described = Describe(firing, explanation);
    described.path = paths.From(firing);
    described.made_result |= firing == explanation.base;
    out.firings.push_back(std::move(described));
  }
  for (const WmeId item : explanation.items) {
    const Chunker::ItemFiring* const made = uses_.chunker.FiringOfItem(item);
    if (made == nullptr) continue;
    out.firings.push_back(Describe(item, made->serial, explanation));
    out.firings.back().path = paths.From(item);
  }
  std::ranges::sort(out.firings, {}, &ExplainedRule::Firing::serial);
  for (const JoinEvent& event : analysis_.events()) {
    ExplainedRule::Event described;
    described.reason = event.reason;
    described.firing = uses_.instantiations[event.firing].serial;
    described.from = analysis_.NumberOfOwn(event.from);
    if (event.to != IdentityGraph::kNone) {
      described.to = analysis_.NumberOfOwn(event.to);
      described.variable = builder_.VariableNameOf(event.to);
      ++out.joined;
    } else if (event.reason != JoinReason::kSingletonLiteral) {
      ++out.literalized;
    }
    out.events.push_back(std::move(described));
  }
  std::ranges::stable_sort(out.events, {}, &ExplainedRule::Event::firing);
  if (made.rule != nullptr) {
    for (const CarriedTest& test : builder_.constraints()) {
      ExplainedRule::Constraint constraint;
      constraint.firing = uses_.instantiations[test.firing].serial;
      constraint.text = Name(test.value) + " " + std::string(ComparisonSign(test.kind)) + Name(test.referent);
      constraint.placed = test.placed;
      out.constraints.push_back(std::move(constraint));
    }
    out.merged_conditions = builder_.merged_conditions();
    out.merged_disjunctions = builder_.merged_disjunctions();
    out.operational_constraints = builder_.operational_constraints();
  }
}

void ExplanationLog::CountDuplicate(std::string_view name) {
  for (ExplainedRule& rule : rules_) {
    if (rule.name == name) ++rule.duplicates;
  }
}

}  // namespace soarbox::kernel
