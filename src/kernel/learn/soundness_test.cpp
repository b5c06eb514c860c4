// SPDX-License-Identifier: BSD-2-Clause
// Checks, without a reference kernel, that learned rules are right. Rules learned in one world are loaded alone in
// other worlds, where they may create only what the substate creates there. The other worlds are random, or contain
// only what one learned rule requires.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "kernel/agent.h"
#include "kernel/learn/learn_settings.h"
#include "kernel/rules/draft.h"
#include "kernel/rules/print_production.h"

namespace soarbox::kernel {
namespace {

#ifdef SOARBOX_CHECK_INVARIANTS
constexpr std::uint32_t kMethods = 400;  // Each phase of each agent is checked, with sanitizers.
#else
constexpr std::uint32_t kMethods = 4000;
#endif

/// Generates worlds, and methods that solve a task in a substate: chains of local copies that meet in one rule,
/// constants, comparisons, disjunctions, sums, tests of absent elements of higher states. Excludes constructs that make
/// learned rules over-general in Soar 9.6.3, too: tests of absent elements in the substate, comparisons with computed
/// values, and results that rise two levels within one phase.
class MethodMaker {
 public:
  explicit MethodMaker(std::uint32_t seed) : random_(seed) {}

  std::string World() {
    std::string rule = "world (state <s> ^superstate nil) --> (<s> ^item <i0> <i1> <i2>)";
    for (int item = 0; item < 3; ++item) {
      const std::string id = "<i" + std::to_string(item) + ">";
      rule += " (" + id + " ^size " + Number() + " ^weight " + Number() + " ^color " + Color() + " ^next <i" +
              std::to_string(Below(3)) + ">)";
      if (Below(3) == 0) rule += " (" + id + " ^mark yes)";
    }
    return rule;
  }

  std::vector<std::string> Method() {
    std::vector<std::string> rules;
    sums_ = Below(3) == 0;
    const int copies = 2 + static_cast<int>(Below(2));
    for (int n = 0; n < copies; ++n) rules.push_back(Copy(n));
    const int steps = static_cast<int>(Below(3));
    for (int n = 0; n < steps; ++n) rules.push_back(Step(n, copies));
    rules.push_back(Result(copies, steps));
    return rules;
  }

 private:
  std::uint32_t Below(std::uint32_t limit) { return random_() % limit; }
  std::string Number() { return std::to_string(Below(5)); }
  std::string Color() { return Below(2) == 0 ? "red" : "blue"; }
  std::string Compare() {
    constexpr const char* kSigns[] = {"<", ">", "<=", ">=", "<>"};
    return kSigns[Below(5)];
  }
  std::string Copy(int n) {
    std::string rule = "copy" + std::to_string(n) + " (state <s> ^superstate <t>) (<t> ^operator.name go ^item <i>)";
    switch (sums_ ? 1 + Below(4) : Below(5)) {
      case 0:
        rule += " (<i> ^size <v> ^weight " + Compare() + " <v>)";
        break;
      case 1:
        rule += " (<i> ^size { <v> << 0 1 2 3 >> } ^color " + Color() + ")";
        break;
      case 2:
        rule += " (<i> ^weight <v> -^mark yes)";
        break;
      case 3:
        rule += " (<i> ^next.size <v>) -{(<i> ^color <c>) (<i> ^next.color <c>)}";
        break;
      default:
        rule += " (<i> ^weight { <v> " + Compare() + " " + Number() + " })";
    }
    // A value, or the object with the value.
    const std::string name = " ^a" + std::to_string(n);
    return rule + " --> (<s>" + name + " <x>) (<x> ^value <v> ^of <i>)";
  }

  /// A value or object that was found so far.
  std::string Known(int copies, int steps) {
    const auto which = static_cast<int>(Below(static_cast<std::uint32_t>(copies + steps)));
    return which < copies ? "a" + std::to_string(which) : "b" + std::to_string(which - copies);
  }

  std::string Step(int n, int copies) {
    std::string rule =
        "step" + std::to_string(n) + " (state <s> ^" + Known(copies, n) + " <x> ^a" + Number2(copies) + " <y>)";
    const std::string make = " --> (<s> ^b" + std::to_string(n) + " <z>) (<z> ^of <i> ^value ";
    const std::uint32_t kind = Below(5);
    // Comparisons with a variable that becomes a constant because of arithmetic are lost.
    switch (sums_ && kind == 0 ? 3 : !sums_ && kind == 3 ? 1 : kind) {
      case 0:
        return rule + " (<x> ^value <v> ^of <i>) (<y> ^value " + Compare() + " <v>)" + make + "<v>)";
      case 1:
        return rule + " (<x> ^value <v> ^of <i>) (<y> ^of <i>)" + make + "<v>)";
      case 2:
        return rule + " (<x> ^value <v> ^of <i>) (<y> ^value <v>)" + make + "<v>)";
      case 3:
        return rule + " (<x> ^value <v> ^of <i>) (<y> ^value <w>)" + make + "(+ <v> <w>))";
      default:
        return rule + " (<x> ^value <v> ^of <i>) (<y> ^of <> <i>)" + make + "<v>)";
    }
  }
  std::string Number2(int copies) { return std::to_string(Below(static_cast<std::uint32_t>(copies))); }

  std::string Result(int copies, int steps) {
    const std::string rule = "fin (state <s> ^" + (steps > 0 ? "b" + std::to_string(steps - 1) : Known(copies, 0)) +
                             " <x> ^superstate <u>) (<x> ^value <v> ^of <i>)";
    switch (Below(4)) {
      case 0:
        return rule + " --> (<u> ^done <i>)";
      case 1:
        return rule + " --> (<u> ^done <r>) (<r> ^of <i> ^value <v>)";
      case 2:
        return rule + " (<i> ^color <c>) --> (<u> ^done <c>)";
      default:
        return rule + " --> (<u> ^done <v>)";
    }
  }

  std::mt19937 random_;
  bool sums_ = false;
};

constexpr const char* kPropose = "go (state <s> ^superstate nil) --> (<s> ^operator.name go)";

/// The structure below an object, in words that do not depend on its name.
std::string Portrait(const Agent& agent, Symbol symbol, int depth) {
  if (!symbol.IsIdentifier() || depth == 0) return symbol.IsIdentifier() ? "..." : ToString(agent.symbols(), symbol);
  std::multiset<std::string> parts;
  for (const WmeId wme : agent.memory().WmesOf(symbol)) {
    const Wme& content = agent.memory().wme(wme);
    parts.insert("^" + ToString(agent.symbols(), content.attribute) + " " + Portrait(agent, content.value, depth - 1));
  }
  std::string text = "(";
  for (const std::string& part : parts) text += part + " ";
  return text + ")";
}

std::set<std::string> Results(const Agent& agent) {
  std::set<std::string> found;
  for (const WmeId wme : agent.memory().WmesOf(agent.goals().top().id)) {
    const Wme& content = agent.memory().wme(wme);
    if (!content.acceptable && ToString(agent.symbols(), content.attribute) == "done") {
      found.insert(Portrait(agent, content.value, 3));
    }
  }
  return found;
}

/// The text between the braces of a rule.
std::string Body(const Agent& agent, ProductionId id) {
  const std::string text = PrintProduction(agent.symbols(), agent.production(id));
  const std::size_t open = text.find('{'), close = text.rfind('}');
  return text.substr(open + 1, close - open - 1);
}

std::vector<std::string> LearnedRules(const Agent& agent) {
  std::vector<std::string> bodies;
  for (const ProductionId id : agent.Productions()) {
    if (agent.production(id).type == ProductionType::kChunk) bodies.push_back(Body(agent, id));
  }
  return bodies;
}

/// Generates worlds that contain only what a learned rule requires: an object for each of its identifiers, a value for
/// each of its other variables. Whether the values satisfy the rule's comparisons is random.
class WorldOfRule {
 public:
  WorldOfRule(const SymbolTable& symbols, const Production& rule, std::mt19937& random)
      : symbols_(symbols), rule_(rule), random_(random) {
    for (const Condition& condition : rule.conditions) {
      if (condition.kind != ConditionKind::kPositive) continue;
      objects_.insert(Name(condition.id));
      if (Name(condition.attribute) == "operator") operators_.insert(Name(condition.value));
    }
  }

  std::string Draw() {
    std::map<std::string, std::string> drawn;
    const std::string state = Name(rule_.conditions.front().id);
    const auto shown = [&](const std::string& name, const std::string& attribute) -> std::string {
      if (name == state) return "<s>";
      if (name.front() != '<') return name;
      if (objects_.contains(name)) return "<of-" + name.substr(1);
      std::string& value = drawn[name];
      if (value.empty())
        value = attribute != "color" ? std::to_string(random_() % 6) : random_() % 2 == 0 ? "red" : "blue";
      return value;
    };
    std::string text = "world (state <s> ^superstate nil) --> (<s> ^drawn yes)";
    for (const Condition& condition : rule_.conditions) {
      if (condition.kind != ConditionKind::kPositive) continue;
      const std::string id = Name(condition.id), attribute = Name(condition.attribute);
      if (attribute == "operator" || operators_.contains(id)) continue;  // The operator is proposed in each world.
      text += " (" + shown(id, {}) + " ^" + attribute + " " + shown(Name(condition.value), attribute) + ")";
    }
    return text;
  }

 private:
  std::string Name(const Test& test) const {
    const Symbol symbol = EqualitySymbol(test);
    // A field without an equality test is named after its position.
    return symbol ? ToString(symbols_, symbol) : "<free" + std::to_string(&test - &rule_.conditions.front().id) + ">";
  }

  const SymbolTable& symbols_;
  const Production& rule_;
  std::mt19937& random_;
  std::set<std::string> objects_, operators_;
};

std::string Listed(const std::set<std::string>& all) {
  std::string text;
  for (const std::string& one : all) text += one + "\n";
  return text;
}

std::string Shown(const std::vector<std::string>& rules) {
  std::string text;
  for (const std::string& rule : rules) text += "sp {" + rule + "}\n";
  return text;
}

void LearnAlways(Agent& agent) {
  agent.ChangeLearning([](LearnSettings& settings) {
    settings.mode = LearnMode::kAlways;
    settings.max_duplicates = 100;
  });
}

void RunIn(Agent& agent, const std::string& world, const std::vector<std::string>& rules) {
  constexpr int kDecisions = 5;
  ASSERT_TRUE(agent.LoadProduction(world).loaded) << world;
  ASSERT_TRUE(agent.LoadProduction(kPropose).loaded);
  for (const std::string& rule : rules) ASSERT_TRUE(agent.LoadProduction(rule).loaded) << rule;
  agent.Run(RunUnit::kDecision, kDecisions);
  ASSERT_EQ(agent.CheckInvariants(), "") << Shown(rules);
}

TEST(LearnedRules, GiveInOtherWorldsOnlyWhatTheSubstateGivesThere) {
  std::size_t learned = 0, given = 0, missing = 0;
  for (std::uint32_t seed = 1; seed <= kMethods; ++seed) {
    MethodMaker maker(seed);
    const std::string world = maker.World();
    const std::vector<std::string> method = maker.Method();
    const std::string all = Shown(method);
    Agent teacher("teacher");
    LearnAlways(teacher);
    RunIn(teacher, world, method);
    if (testing::Test::HasFatalFailure()) return;
    const std::vector<std::string> rules = LearnedRules(teacher);
    learned += rules.size();
    for (int round = 0; round < 3; ++round) {
      const std::string other = round == 0 ? world : maker.World();
      Agent slow("slow"), fast("fast");
      RunIn(slow, other, method);
      RunIn(fast, other, rules);
      if (testing::Test::HasFatalFailure()) return;
      const std::set<std::string> right = Results(slow), found = Results(fast);
      given += found.size();
      for (const std::string& result : found) {
        ASSERT_TRUE(right.contains(result)) << "seed " << seed << ", round " << round << ": " << result << "\nright:\n"
                                            << Listed(right) << other << "\n"
                                            << all << "learned:\n"
                                            << rules.front();
      }
      // In its own world, nothing may be missing.
      if (round == 0) {
        EXPECT_EQ(right, found) << "seed " << seed << "\n" << other << "\n" << all;
        missing += right.size() - found.size();
      }
    }
  }
  // A generator that produces nothing interesting would test nothing.
  EXPECT_GT(learned, kMethods / 2);
  EXPECT_GT(given, kMethods);
  EXPECT_EQ(missing, 0u);
}

TEST(LearnedRules, GiveWhatTheSubstateGivesWhereNothingIsThereButTheirConditions) {
  constexpr int kDraws = 12;
  std::size_t learned = 0, tried = 0;
  for (std::uint32_t seed = 1; seed <= kMethods; ++seed) {
    MethodMaker maker(seed);
    std::mt19937 random(seed);
    const std::string world = maker.World();
    const std::vector<std::string> method = maker.Method();
    Agent teacher("teacher");
    LearnAlways(teacher);
    RunIn(teacher, world, method);
    if (testing::Test::HasFatalFailure()) return;
    for (const ProductionId id : teacher.Productions()) {
      const Production& rule = teacher.production(id);
      if (rule.type != ProductionType::kChunk) continue;
      ++learned;
      const std::vector<std::string> alone = {Body(teacher, id)};
      WorldOfRule conditions(teacher.symbols(), rule, random);
      std::set<std::string> found;
      std::string drawn;
      for (int draw = 0; draw < kDraws && found.empty(); ++draw) {
        drawn = conditions.Draw();
        Agent fast("fast");
        RunIn(fast, drawn, alone);
        if (testing::Test::HasFatalFailure()) return;
        found = Results(fast);
      }
      if (found.empty()) continue;  // The values never satisfied its comparisons.
      ++tried;
      Agent slow("slow");
      RunIn(slow, drawn, method);
      if (testing::Test::HasFatalFailure()) return;
      const std::set<std::string> right = Results(slow);
      for (const std::string& result : found) {
        ASSERT_TRUE(right.contains(result)) << "seed " << seed << ": " << result << "\nright:\n"
                                            << Listed(right) << drawn << "\n"
                                            << Shown(method) << "learned:\n"
                                            << alone.front();
      }
    }
  }
  EXPECT_GT(learned, kMethods / 2);
  EXPECT_GT(tried, learned / 10 * 9);
}

}  // namespace
}  // namespace soarbox::kernel
