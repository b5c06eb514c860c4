// SPDX-License-Identifier: BSD-2-Clause
#include "cli/explain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <vector>

#include "diagnostics/name_table.h"
#include "kernel/rules/print_production.h"

namespace soarbox::cli {
namespace {

using kernel::ExplainedRule;
using kernel::JoinReason;
using Field = ExplainedRule::Field;
using Part = ExplainedRule::Condition::Part;

std::string Padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + (text.size() < width ? 0 : 1)), ' ');
  return text;
}

/// Pads a text to a column. Unlike Padded, it adds no blank to a longer text.
std::string AtColumn(std::string text, std::size_t column) {
  text.resize(std::max(column, text.size()), ' ');
  return text;
}

enum class Column { kText, kIdentity, kValue };

const std::string& In(const Field& field, Column column) {
  return column == Column::kText ? field.text : column == Column::kIdentity ? field.identity : field.value;
}

std::string ConditionText(const ExplainedRule::Condition& condition, Column column, bool shows_state) {
  if (condition.negated) return condition.id.text;
  std::string id = In(condition.id, column);
  if (shows_state && condition.tests_state && id.find("state") == std::string::npos) id = "{ state " + id + " }";
  return "(" + id + " ^" + In(condition.attribute, column) + " " + In(condition.value, column) +
         (condition.acceptable ? " +" : "") + ")";
}

std::string ActionText(const ExplainedRule::Action& action, Column column, bool sign_inside) {
  std::string text = "(" + In(action.id, column) + " ^" + In(action.attribute, column) + " " + In(action.value, column);
  const std::string sign(kernel::PreferenceSign(action.type));
  std::string rest = " " + sign;
  if (!action.referent.value.empty()) rest += (sign_inside ? "" : " ") + In(action.referent, column);
  return sign_inside ? text + rest + ")" : text + ")" + rest;
}

/// Numbered rows of conditions. A negated conjunction is in braces; with `joins`, consecutive ones share a pair. `rest`
/// gets the beginning of a row, its condition and, for a negated one, the part of it in this row; it returns the
/// complete row.
template <typename Rest>
std::string ConditionRows(const std::vector<ExplainedRule::Condition>& conditions, Column column, bool shows_state,
                          bool joins, Rest&& rest) {
  std::string text;
  int number = 0;
  const auto row = [&](const std::string& condition) {
    return fmt::format("{:<6}{}", fmt::format("{}:", ++number), condition);
  };
  for (std::size_t n = 0; n < conditions.size(); ++n) {
    const ExplainedRule::Condition& condition = conditions[n];
    if (!condition.negated) {
      text += rest(row(ConditionText(condition, column, shows_state)), condition, nullptr) + "\n";
      continue;
    }
    const bool joins_last = joins && n > 0 && conditions[n - 1].conjunction;
    const bool joins_next = joins && n + 1 < conditions.size() && conditions[n + 1].conjunction;
    if (condition.conjunction && !joins_last) text += "     -{\n";
    for (const ExplainedRule::Condition::Part& part : condition.parts) {
      text += rest(row(column == Column::kValue ? part.value : part.text), condition, &part) + "\n";
    }
    if (condition.conjunction && !joins_next) text += "     }\n";
  }
  return text;
}

std::string PathText(const std::vector<std::uint32_t>& path) {
  std::string text;
  for (const std::uint32_t serial : path) text += fmt::format("{}i {}", text.empty() ? "" : " -> ", serial);
  return text;
}

std::string_view ReasonText(JoinReason reason) {
  static constexpr const char* kNames[] = {"Two identities propagated into the same variable",
                                           "Tested a super-state singleton WME previously tested by another rule",
                                           "Identities joined to connected child result to parent result",
                                           "Literal value in another rule compared against RHS variable",
                                           "Variable in another rule compared against literal RHS value",
                                           "Variable in another rule tested result of RHS function",
                                           "Variable was used as argument in a RHS function",
                                           "Tested a super-state singleton WME previously tested by another rule",
                                           "Variable was marked literal by $"};
  return NameIn(kNames, reason);
}

std::string EventText(const ExplainedRule::Event& event) {
  const std::string what = event.to == 0 ? fmt::format("{} literalized", event.from)
                                         : fmt::format("{} merged with {} {}", event.from, event.to, event.variable);
  return fmt::format("  {:<30}| {}", what, ReasonText(event.reason));
}

std::string CreatorText(const ExplainedRule::Condition& condition) {
  if (condition.operational) return "Higher-level Problem Space";
  if (condition.creator == 0) return "Soar Architecture";
  return fmt::format("i {} ({})", condition.creator, condition.creator_rule);
}

/// The identities that a firing joined or literalized, or a note that there were none.
std::string EventsIn(const ExplainedRule& rule, std::uint32_t firing) {
  std::string events;
  for (const bool literal : {false, true}) {
    for (const ExplainedRule::Event& event : rule.events) {
      if (event.firing == firing && (event.to == 0) == literal) events += EventText(event) + "\n";
    }
  }
  return events.empty() ? fmt::format("No identity set unifications for instantiation {}.\n", firing)
                        : "Identity operations:\n\n" + events;
}

/// The text about a firing whose rule was excised: the elements that it matched, with their identities.
std::string WithoutRule(const ExplainedRule& rule, const ExplainedRule::Firing& firing) {
  const bool learned = firing.serial == rule.instance;
  const std::string title = fmt::format("Explanation trace of instantiation # {}", firing.serial);
  const std::string match = fmt::format("(match of rule {} at level {})\n", firing.rule, firing.level);
  std::string text = Padded(title, 69) + match +
                     "\nWarning:  Cannot print explanation trace for this instantiation because no underlying\n"
                     "            rule found in RETE.  Printing working memory trace instead.\n\n" +
                     Padded(title, 56) + match;
  if (firing.made_result || !firing.path.empty()) {
    text += firing.made_result ? " (produced chunk result)\n"
                               : "- Shortest path to a result: " + PathText(firing.path) + "\n";
    text += Padded("", 74) + "Identities instead of variables Operational Creator\n\n";
  } else {
    text += "\n" + Padded("", 55) + "Identities instead of variables            Operational    Creator\n\n";
  }
  text += ConditionRows(firing.conditions, Column::kValue, learned, true,
                        [&](const std::string& row, const ExplainedRule::Condition& condition, const Part* part) {
                          const std::string identity =
                              part != nullptr ? part->identity : ConditionText(condition, Column::kIdentity, learned);
                          const bool operational = part != nullptr ? part->operational : condition.operational;
                          return AtColumn(Padded(Padded(row, 56) + identity, 103) + (operational ? "Yes" : "No"), 114) +
                                 (part != nullptr ? "N/A" : CreatorText(condition));
                        });
  text += "   -->\n";
  int number = 0;
  for (const ExplainedRule::Action& action : firing.actions) {
    text += fmt::format("{:<6}{}\n", fmt::format("{}:", ++number), ActionText(action, Column::kValue, false));
  }
  return text + "\n" + EventsIn(rule, firing.serial);
}

std::string TitleOf(const ExplainedRule& rule) {
  return fmt::format("{} (c {})", rule.name, rule.number);
}

}  // namespace

ExplainedRule::Firing LearnedInstance(const ExplainedRule& rule) {
  ExplainedRule::Firing firing;
  firing.serial = rule.instance;
  firing.rule = rule.name;
  firing.level = rule.instance_level;
  firing.made_result = true;
  firing.conditions = rule.conditions;
  for (ExplainedRule::Condition& condition : firing.conditions) {
    condition.operational = condition.above_own;
  }
  firing.actions = rule.actions;
  return firing;
}

std::string ExplainedRuleText(const ExplainedRule& rule, bool elements, const LoadedRules& loaded) {
  if (elements || !loaded(rule.name)) return ExplainedFiringText(rule, LearnedInstance(rule), elements, loaded);
  std::string text = Padded(Padded("", 59) + "Using variable identity IDs", 109) +
                     "Shortest Path to Result Instantiation\n\nsp {" + rule.name + "\n";
  text += ConditionRows(rule.conditions, Column::kText, true, false,
                        [](const std::string& row, const ExplainedRule::Condition& condition, const Part* part) {
                          std::string whole =
                              Padded(row, 59) +
                              (part != nullptr ? part->identity : ConditionText(condition, Column::kIdentity, true));
                          return condition.path.empty() ? whole : Padded(whole, 109) + PathText(condition.path);
                        });
  text += "   -->\n";
  int number = 0;
  for (const ExplainedRule::Action& action : rule.actions) {
    text += Padded(fmt::format("{:<6}{}", fmt::format("{}:", ++number), ActionText(action, Column::kText, true)), 59) +
            ActionText(action, Column::kIdentity, true) + "\n";
  }
  return text + "\nThis instantiation produced results in a superstate.\n";
}

std::string ExplainedFiringText(const ExplainedRule& rule, const ExplainedRule::Firing& firing, bool elements,
                                const LoadedRules& loaded) {
  if (!elements && !loaded(firing.rule)) return WithoutRule(rule, firing);
  const bool learned = firing.serial == rule.instance;
  const std::string kind = elements ? "Working memory trace" : "Explanation trace";
  std::string text = Padded(fmt::format("{} of instantiation # {}", kind, firing.serial), 56) +
                     fmt::format("(match of rule {} at level {})\n", firing.rule, firing.level);
  if (!elements) {
    text += "\n" + Padded("", 56) + "Identities instead of variables            Operational    Creator\n\n";
  } else {
    text += Padded("", 56) + "Operational    Creator\n\n";
  }
  text += ConditionRows(
      firing.conditions, elements ? Column::kValue : Column::kText, !elements, elements,
      [&](const std::string& row, const ExplainedRule::Condition& condition, const Part* part) {
        std::string whole = Padded(row, elements ? 60 : 56);
        if (!elements) {
          whole = Padded(
              whole + (part != nullptr ? part->identity : ConditionText(condition, Column::kIdentity, learned)), 103);
        }
        const bool operational = part != nullptr ? part->operational : condition.operational;
        return AtColumn(whole + (operational ? "Yes" : "No"), elements ? 71 : 114) +
               (part != nullptr ? "N/A" : CreatorText(condition));
      });
  int number = 0;
  text += "   -->\n";
  for (const ExplainedRule::Action& action : firing.actions) {
    std::string row = fmt::format("{:<6}{}", fmt::format("{}:", ++number),
                                  ActionText(action, elements ? Column::kValue : Column::kText, !elements));
    if (!elements) row = Padded(row, 56) + ActionText(action, Column::kIdentity, true);
    text += row + "\n";
  }
  if (elements) return text;
  text += "\n";
  const bool is_other = std::ranges::find(rule.other_results, firing.serial) != rule.other_results.end();
  if ((firing.made_result && !is_other) || firing.path.size() == 1) {
    text += "This instantiation produced results in a superstate.\n";
  } else if (!firing.path.empty()) {
    text +=
        "Shortest path from this instantiation to an instantiation that produced a result: " + PathText(firing.path) +
        "\n";
  }
  return text + EventsIn(rule, firing.serial);
}

std::string FormationText(const ExplainedRule& rule, bool elements, const LoadedRules& loaded) {
  const std::string line(84, '-');
  const ExplainedRule::Firing* const base = rule.FindFiring(rule.base);
  std::string text =
      line + fmt::format("\nThe formation of chunk '{}' (c {}) \n", rule.name, rule.number) + line + "\n\n";
  if (!rule.other_results.empty()) {
    text += fmt::format("The following {} instantiations fired to produce results...\n\n------\n\n",
                        rule.other_results.size() + 1);
  }
  if (base != nullptr) {
    text += fmt::format("Initial base instantiation (i {}) that fired when {} matched at level {} at time {}:\n\n",
                        base->serial, base->rule, base->level, rule.decision);
    text += ExplainedFiringText(rule, *base, elements, loaded);
  }
  if (!rule.other_results.empty()) {
    text += fmt::format(
        "\n{} instantiation(s) that created extra results indirectly because they were connected to the results of the "
        "base instantiation:\n\n",
        rule.other_results.size() - 1);
    for (const std::uint32_t serial : rule.other_results) {
      const ExplainedRule::Firing* const other = rule.FindFiring(serial);
      if (other != nullptr) text += ExplainedFiringText(rule, *other, elements, loaded);
    }
  }
  text += "\n";
  text += fmt::format("This chunk summarizes the problem-solving involved in the following {} rule firings:\n\n",
                      rule.firings.size());
  for (const ExplainedRule::Firing& firing : rule.firings) {
    text += fmt::format("   i {} ({})\n", firing.serial, firing.rule);
  }
  return text + "\n" + ExplainMenu(elements);
}

std::string IdentityText(const ExplainedRule& rule) {
  std::string text = fmt::format("\nIdentity analysis of problem-solving behind rule {}:\n\n\n", TitleOf(rule));
  text += fmt::format("Learned rule contained {} identities: ", rule.identities.size());
  for (const std::uint32_t identity : rule.identities) text += fmt::format("{} ", identity);
  text += "\n";
  if (rule.events.empty()) return text + "No identity unifications occurred during backtracing.\n";
  text += "Identity set unifications:\n\n";
  for (const bool literal : {false, true}) {
    for (const ExplainedRule::Event& event : rule.events) {
      if ((event.to == 0) == literal) text += EventText(event) + fmt::format(" in instantiation {}\n", event.firing);
    }
  }
  return text;
}

std::string ConstraintsText(const ExplainedRule& rule) {
  return fmt::format("\nConstraint analysis of problem-solving behind rule {}:\n\n", TitleOf(rule));
}

std::string ExplainedStatisticsText(const ExplainedRule& rule) {
  std::string text = fmt::format("\nStatistics for learned rule {}:\n\n", TitleOf(rule));
  const auto row = [&](std::string_view name, const std::string& value) {
    text += fmt::format("{:<71}{}\n", std::string(name) + ":", value);
  };
  const auto number = [&](std::string_view name, std::size_t value) { row(name, std::to_string(value)); };
  const auto answer = [&](std::string_view name, bool yes) { row(name, yes ? "Yes" : "No"); };
  const auto title = [&](std::string_view name) {
    const std::string line(75, '-');
    text += "\n" + line + "\n" + std::string(name) + "\n" + line + "\n";
  };
  const auto placed = std::ranges::count_if(rule.constraints, [](const auto& test) { return test.placed; });
  number("Number of conditions", rule.CountConditions());
  number("- Operational constraints", rule.operational_constraints);
  number("- Non-operational constraints detected", rule.constraints.size());
  number("- Non-operational constraints enforced", static_cast<std::size_t>(placed));
  text += "\n";
  number("Number of actions", rule.actions.size());
  const ExplainedRule::Firing* const base = rule.FindFiring(rule.base);
  row("Base instantiation", fmt::format("i {} ({})", rule.base, base != nullptr ? base->rule : std::string("?")));
  if (!rule.other_results.empty()) {
    number("Number of child result instantiations", rule.other_results.size());
    std::string name = "Child result instantiations:";
    for (const std::uint32_t serial : rule.other_results) {
      const ExplainedRule::Firing* const other = rule.FindFiring(serial);
      text += fmt::format("{:<71}i {} ({})\n", name, serial, other != nullptr ? other->rule : std::string("?"));
      name.clear();
    }
  }
  title("                            Work Performed");
  number("Number of rule firings analyzed during backtracing", rule.firings.size());
  number("Duplicates chunks later created", rule.duplicates);
  text += "\n";
  number("Conditions merged", rule.merged_conditions);
  number("Disjunction tests merged", rule.merged_disjunctions);
  title("                           Identity Analysis");
  number("Distinct identities in learned rules", rule.identities.size());
  number("Identities joined", rule.joined);
  number("Identities literalized", rule.literalized);
  title("                    Problem-Solving Characteristics");
  answer("Used negated reasoning about sub-state", rule.local_negation);
  answer("Tested ^quiescence true", rule.quiescence);
  answer("Tested knowledge retrieved from long-term memory", rule.long_term_memory);
  answer("Added conditions to repair unconnected conditions or actions", rule.repaired);
  return text;
}

std::string ExplainMenu(bool elements) {
  const std::string line(117, '-');
  return line + "\n- explain f    Explain initial formation of chunk                    explain " +
         (elements ? "e    Switch to explanation trace       -\n" : "w    Switch to working memory trace    -\n") +
         "- explain c    Explain constraints required by problem-solving       explain i    Explain identity analysis "
         "        -\n"
         "- explain s    Print chunk statistics                                chunk stats  Print overall chunk "
         "statistics    -\n" +
         line + "\n";
}

}  // namespace soarbox::cli
