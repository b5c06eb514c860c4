// SPDX-License-Identifier: BSD-2-Clause
#include "kernel/decide/random_agents_test_support.h"

namespace soarbox::kernel {

std::string_view RandomAgents::Attribute() {
  constexpr std::string_view kAttributes[] = {"a", "b", "c"};
  return kAttributes[Below(std::size(kAttributes))];
}

std::string_view RandomAgents::Constant() {
  constexpr std::string_view kConstants[] = {"1", "2", "3", "x", "y"};
  return kConstants[Below(std::size(kConstants))];
}

std::string RandomAgents::NewVariable(std::string_view kind) {
  return "<" + std::string(kind) + std::to_string(variables_++) + ">";
}

/// A test of a value. If it binds a variable, `bound` is set to the variable.
std::string RandomAgents::ValueTest(Scope& scope, bool may_bind, std::string& bound) {
  switch (Below(may_bind ? 8 : 4)) {
    case 0:
    case 1:
      return std::string(Constant());
    case 2:
      return "<< " + std::string(Constant()) + " " + std::string(Constant()) + " >>";
    case 3:
      if (!scope.values.empty()) return (Chance(30) ? "<> " : "") + Pick(scope.values);
      return "<> " + std::string(Constant());
    default:
      break;
  }
  bound = NewVariable("v");
  scope.values.push_back(bound);
  switch (Below(4)) {
    case 0:
      return "{ " + bound + " <> " + std::string(Constant()) + " }";
    case 1:
      return "{ " + bound + " < 3 }";
    default:
      return bound;
  }
}

std::string RandomAgents::Tests(Scope& scope, const std::string& object, std::uint32_t count) {
  std::string text;
  for (std::uint32_t n = 0; n < count; ++n) {
    const std::string attribute(Attribute());
    std::string bound;
    if (Chance(25)) {
      text += " -^" + attribute + " " + ValueTest(scope, false, bound);
      continue;
    }
    text += " ^" + attribute + " " + ValueTest(scope, true, bound);
    if (!bound.empty()) scope.elements.push_back({object, attribute, bound});
  }
  return text;
}

/// Conditions that do not begin at a state. They match anywhere in working memory, and the rule fires only if one of
/// its elements belongs to a goal.
std::string RandomAgents::RootlessConditions(Scope& scope) {
  const std::string first = NewVariable("x");
  scope.objects.push_back(first);
  scope.may_make = false;
  std::string text = "(" + first + (Chance(40) ? " ^part <p>" : "") + Tests(scope, first, 1 + Below(2)) + ")";
  if (text.find("<p>") != std::string::npos) {
    scope.objects.push_back("<p>");
    text += " (<p>" + Tests(scope, "<p>", 1) + ")";
  }
  if (Chance(50)) {
    const std::string second = NewVariable("x");
    scope.objects.push_back(second);
    text += " (" + second + Tests(scope, second, 1 + Below(2)) + ")";
  }
  if (Chance(25)) {
    text += " -{ (" + Pick(scope.objects) + " ^part <q>) (<q> ^" + std::string(Attribute()) + " <w>) }";
  }
  return text;
}

std::string RandomAgents::Conditions(Scope& scope) {
  if (Chance(rootless_percent_)) return RootlessConditions(scope);
  scope.objects.push_back("<s>");
  std::string state = "(state <s>", others;
  if (Chance(45)) {
    state += " ^superstate nil";
  } else if (Chance(60)) {
    state += " ^superstate <ss>";
    scope.substate = true;
    others += " (<ss>" + Tests(scope, "<ss>", 1) + ")";
    scope.objects.push_back("<ss>");
    if (Chance(30)) state += " ^impasse << tie no-change >>";
    if (Chance(30)) {
      state += " ^item <item>";
      scope.may_make = false;
    }
  }
  state += Tests(scope, "<s>", Below(3));
  if (Chance(35)) {
    state += " ^operator <o>";
    others += " (<o> ^name " + std::string(Constant()) + ")";
    scope.objects.push_back("<o>");
  }
  if (Chance(25)) {
    state += " ^operator <proposed> +";
    scope.operators.push_back("<proposed>");
    scope.may_make = false;
    if (Chance(50)) others += " (<proposed> ^name " + std::string(Constant()) + ")";
    if (Chance(40)) {
      state += " ^operator { <other> <> <proposed> } +";
      scope.operators.push_back("<other>");
    }
  }
  if (Chance(35)) {
    state += " ^part <p>";
    others += " (<p>" + Tests(scope, "<p>", 1 + Below(2)) + ")";
    scope.objects.push_back("<p>");
    scope.may_make = false;
  }
  if (Chance(20)) {
    others += " -{ (<s> ^part <q>) (<q> ^" + std::string(Attribute()) + " <w>)";
    others += Chance(50) ? " -(<q> ^" + std::string(Attribute()) + " <w>) }" : " }";
  }
  return state + ")" + others;
}

/// A preference for a proposed operator.
std::string RandomAgents::Preference(Scope& scope) {
  const std::string begin = "(<s> ^operator " + Pick(scope.operators) + " ";
  switch (Below(9)) {
    case 0:
      return begin + "=)";
    case 1:
      return begin + "= " + std::string(Chance(50) ? "2" : "0.5") + ")";
    case 2:
      return begin + ">)";
    case 3:
      return begin + "<)";
    case 4:
      return begin + "-)";
    case 5:
      return begin + (Chance(30) ? "!)" : "+)");
    case 6:
      return begin + (Chance(30) ? "~)" : "=)");
    case 7:
      return begin + "> " + Pick(scope.operators) + ")";
    default:
      return begin + "= " + Pick(scope.operators) + ")";
  }
}

std::string RandomAgents::NextAction(Scope& scope) {
  const std::string object = Pick(scope.objects);
  switch (Below(10)) {
    case 0:
    case 1:
      if (scope.may_make) {
        const std::string made = NewVariable("o");
        return "(<s> ^operator " + made + " + " + (Chance(50) ? "=" : "") + ") (" + made + " ^name " +
               std::string(Constant()) + ")";
      }
      break;
    case 2:
      if (scope.may_make && scope.substate) {
        const std::string made = NewVariable("o");
        return "(<ss> ^operator " + made + " +) (" + made + " ^name " + std::string(Constant()) + ")";
      }
      break;
    case 3:
      if (scope.may_make) {
        const std::string made = NewVariable("p");
        return "(" + object + " ^part " + made + ") (" + made + " ^" + std::string(Attribute()) + " " +
               std::string(Constant()) + " ^" + std::string(Attribute()) + " " + std::string(Constant()) + ")";
      }
      break;
    case 4:
      if (!scope.elements.empty()) {
        const Scope::Element& element = Pick(scope.elements);
        const std::string same = "(" + element.id + " ^" + element.attribute + " " + element.value + " -)";
        return Chance(50) ? same
                          : same + " (" + element.id + " ^" + element.attribute + " (+ " + element.value + " 1))";
      }
      break;
    case 5:
    case 6:
      if (!scope.operators.empty()) return Preference(scope);
      break;
    case 7:
      if (!scope.values.empty()) return "(" + object + " ^" + std::string(Attribute()) + " " + Pick(scope.values) + ")";
      break;
    default:
      break;
  }
  return "(" + object + " ^" + std::string(Attribute()) + " " + std::string(Constant()) + ")";
}

std::string RandomAgents::NextRule() {
  Scope scope;
  variables_ = 0;
  std::string rule = "rule" + std::to_string(rules_++) + " " + Conditions(scope) + " -->";
  const std::uint32_t actions = 1 + Below(3);
  for (std::uint32_t n = 0; n < actions; ++n) rule += " " + NextAction(scope);
  return rule;
}

}  // namespace soarbox::kernel
