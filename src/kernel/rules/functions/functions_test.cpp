// SPDX-License-Identifier: BSD-2-Clause
#include <gtest/gtest.h>

#include <map>

#include "kernel/rules/functions/builtin_functions.h"
#include "kernel/rules/production.h"

namespace soarbox::kernel {
namespace {

/// A context without an agent: records messages and contains a few objects.
class FakeContext : public FunctionContext {
 public:
  SymbolTable& symbols() override { return symbols_; }
  RandomStream& random() override { return random_; }
  void PrintError(std::string_view text) override { errors += text; }
  void Write(std::string_view text) override { written += text; }
  void Log(int channel, std::string_view text) override {
    written += std::to_string(channel) + ":" + std::string(text);
  }
  void Trace(int level, std::string_view text) override { written += std::to_string(level) + "!" + std::string(text); }
  void RequestHalt() override { halted = true; }
  void RequestInterrupt() override {}
  void WaitMilliseconds(std::int64_t) override {}
  std::string Timestamp() override { return "2000-01-01 00:00:00.000"; }
  std::uint64_t DecisionCycle() const override { return 7; }
  std::uint64_t NextConstantNumber() override { return ++constants_; }
  std::string RunCommand(std::string_view line) override { return "ran " + std::string(line) + "\n"; }
  bool CallUserFunction(std::string_view name, std::string_view argument, std::string& result) override {
    result = "[" + std::string(argument) + "]";
    return name == "wrap";
  }
  void SlotChildren(Symbol identifier, std::vector<Child>& out) const override { AllChildren(identifier, out); }
  void AllChildren(Symbol identifier, std::vector<Child>& out) const override {
    const auto found = objects.find(identifier.bits());
    if (found != objects.end()) out.insert(out.end(), found->second.begin(), found->second.end());
  }
  Symbol NewIdentifier(char letter) override { return symbols_.NewIdentifier(letter); }
  void MakePreference(Symbol identifier, Symbol attribute, Symbol value) override {
    objects[identifier.bits()].push_back({attribute, value});
  }
  bool IsGoal(Symbol) const override { return false; }
  std::uint64_t LongTermIdentifier(Symbol) const override { return 0; }
  void LinkToLongTerm(Symbol, std::uint64_t) override {}
  void SetLearning(Symbol, bool) override {}

  std::string errors, written;
  bool halted = false;
  std::map<std::uint32_t, std::vector<Child>> objects;

 private:
  SymbolTable symbols_;
  RandomStream random_{1};
  std::uint64_t constants_ = 0;
};

class FunctionsTest : public testing::Test {
 protected:
  Symbol S(const char* text) { return context_.symbols().String(text); }
  Symbol I(std::int64_t value) { return context_.symbols().Integer(value); }
  Symbol F(double value) { return context_.symbols().Float(value); }

  /// The value as text, or the error message of the function.
  std::string Call(const char* name, std::vector<Symbol> arguments) {
    context_.errors.clear();
    const std::uint16_t index = FindBuiltinFunction(name);
    if (index == RhsValue::kUserFunction) return "unknown";
    const Symbol value = Evaluate(context_, index, arguments);
    return value ? ToString(context_.symbols(), value) : context_.errors;
  }

  FakeContext context_;
};

TEST_F(FunctionsTest, FunctionsForNavigationTakeNumbersOfAnyKind) {
  EXPECT_EQ(Call("haversine", {F(52.5), F(13.4), F(52.5), F(13.4)}), "0.000000");
  // A quarter of the way around the earth, along the equator and to the pole.
  EXPECT_EQ(Call("haversine", {I(0), I(0), I(0), I(90)}), Call("haversine", {I(0), I(20), I(90), I(0)}));
  EXPECT_EQ(Call("haversine", {I(0), I(0), I(0), I(90)}).substr(0, 8), "10007557");
  EXPECT_EQ(Call("extrapolate-x-position", {I(1), I(2), I(90), I(10)}), "11.000000");
  EXPECT_EQ(Call("extrapolate-y-position", {I(1), I(2), I(180), F(2.5)}), "-0.500000");
  EXPECT_EQ(Call("extrapolate-y-position", {F(1.5), F(2.5), I(0), I(10)}), "12.500000");
  const Symbol points = context_.NewIdentifier('P'), near = context_.NewIdentifier('A'),
               far = context_.NewIdentifier('B');
  context_.objects[points.bits()] = {{S("point"), near}, {S("point"), far}};
  context_.objects[near.bits()] = {{S("x"), F(0.5)}, {S("y"), F(9)}};
  context_.objects[far.bits()] = {{S("x"), I(9)}, {S("y"), F(0.25)}, {S("id"), S("east")}};
  EXPECT_EQ(Call("select-point-closest-to-vector", {F(0), F(0), F(90), points}), "east");
  EXPECT_EQ(Call("select-point-closest-to-vector", {I(0), I(0), I(0), points}), "A1");
  EXPECT_EQ(Call("haversine", {S("here"), I(0), I(0), I(0)}), "Error: non-number (here) passed to - haversine\n");
}

TEST_F(FunctionsTest, ArithmeticKeepsIntegersAndDividesToFloats) {
  EXPECT_EQ(Call("+", {}), "0");
  EXPECT_EQ(Call("*", {}), "1");
  EXPECT_EQ(Call("+", {I(7), I(-3), F(2.5)}), "6.500000");
  EXPECT_EQ(Call("-", {I(5), I(2), I(1)}), "2");
  EXPECT_EQ(Call("-", {F(2.5)}), "-2.500000");
  EXPECT_EQ(Call("/", {I(6), I(3)}), "2.000000");
  EXPECT_EQ(Call("/", {I(4)}), "0.250000");
  EXPECT_EQ(Call("div", {I(-7), I(2)}), "-3");
  EXPECT_EQ(Call("mod", {I(-7), I(3)}), "-1");
  EXPECT_EQ(Call("min", {I(3), F(2.5)}), "2.500000");
  EXPECT_EQ(Call("max", {I(3), I(1)}), "3");
  EXPECT_EQ(Call("abs", {F(-4.5)}), "4.500000");
  EXPECT_EQ(Call("atan2", {I(1), I(1)}), "0.785398");
  EXPECT_EQ(Call("int", {F(-2.9)}), "-2");
  EXPECT_EQ(Call("int", {S("3.7")}), "3");
  EXPECT_EQ(Call("int", {S("abc")}), "0");
  EXPECT_EQ(Call("float", {S("1.5e3x")}), "1500.000000");
}

TEST_F(FunctionsTest, WhatOverflowsWrapsRoundAndWhatCrashesInSoarIsAnswered) {
  EXPECT_EQ(Call("+", {I(INT64_MAX), I(1)}), "-9223372036854775808");
  EXPECT_EQ(Call("-", {I(INT64_MIN)}), "-9223372036854775808");
  EXPECT_EQ(Call("div", {I(INT64_MIN), I(-1)}), "-9223372036854775808");
  EXPECT_EQ(Call("mod", {I(INT64_MIN), I(-1)}), "0");
  EXPECT_EQ(Call("round-off", {I(5), I(0)}), "Error: attempt to divide ('round-off') by zero.\n");
  EXPECT_EQ(Call("round-off", {F(5), F(0.01)}), "Error: attempt to divide ('round-off') by zero.\n");
  EXPECT_EQ(Call("round-off", {I(INT64_MAX), I(10)}), "9223372036854775800");
  EXPECT_EQ(Call("round-off", {I(INT64_MIN), I(-1)}), "-9223372036854775808");
  EXPECT_EQ(Call("round-off", {S("a"), S("b")}), "Error: non-number (b) passed to - round-off\n");
  EXPECT_EQ(Call("abs", {I(INT64_MIN)}), "-9223372036854775808");
  EXPECT_EQ(Call("*", {I(INT64_MAX), I(2)}), "-2");
  EXPECT_EQ(Call("int", {F(1e30)}), "-9223372036854775808");
  EXPECT_EQ(Call("compute-range", {I(0), I(0), I(INT64_MAX), I(1)}), "-9223372036854775808");
  EXPECT_EQ(Call("compute-dice-probability", {I(1000), I(6), I(2000), S("le")}), "1.000000");
}

TEST_F(FunctionsTest, ErrorsHaveSoarsTexts) {
  EXPECT_EQ(Call("+", {I(1), S("ten")}), "Error: non-number (ten) passed to + function\n");
  EXPECT_EQ(Call("div", {I(7), I(0)}), "Error: attempt to divide ('div') by zero.\n");
  EXPECT_EQ(Call("/", {I(7), I(0)}), "Error: attempt to divide ('/') by zero.\n");
  EXPECT_EQ(Call("mod", {I(7), F(2)}), "Error: non-integer (2.000000) passed to mod function\n");
  EXPECT_EQ(Call("-", {}), "Error: '-' function called with no arguments\n");
  EXPECT_EQ(Call("sin", {S("ten")}), "Error: 'sin' function called with non-numeric argument ten\n");
  EXPECT_EQ(Call("size", {S("three")}), "Error: non-symbol (three) passed to size function\n");
  EXPECT_EQ(Call("capitalize-symbol", {I(5)}), "\nError: non-symbol (5) passed to capitalize-symbol function.\n");
  EXPECT_EQ(Call("int", {S("99999999999999999999")}),
            "Error: bad integer (|99999999999999999999|) given to 'int' RHS function\n");
  EXPECT_EQ(Call("float", {S("1e999")}), "Error: bad float (1e999) given to 'float' RHS function\n");
  EXPECT_EQ(Call("compute-dice-probability", {I(5), I(6), I(2), I(7)}),
            "Error: non-string (7) passed as 'pred' to - compute-dice-probability\n");
  EXPECT_EQ(Call("compute-closest-intercept", {I(1), I(2), F(3.5), I(4)}),
            "Error: non int (3.500000) passed to compute-closest-intercept function.\n");
  EXPECT_EQ(
      Call("log", {S("x")}),
      "Error: First argument of agent's (log) rhs-function must be an integer channel number between 1 and 100.  x is "
      "invalid.\n");
  EXPECT_EQ(Call("@", {S("abc")}), "\nError: abc is not linked to a semantic identifier.\n");
  EXPECT_EQ(Call("link-stm-to-ltm", {S("x"), I(5)}),
            "Error: '@' rhs function cannot accept x because it is not a Soar identifier\n");
  EXPECT_EQ(Call("dont-learn", {I(5)}), "Error: non-identifier (5) passed to dont-learn function.\n");
  EXPECT_EQ(Call("cmd", {}), "error_expected_rhs_function_to_return_value_but_it_did_NOT");
  EXPECT_EQ(context_.errors, "cmd should be followed by a command name \n");
  EXPECT_EQ(Call("exec", {S("nobody"), I(1)}), "|Error: Nobody was registered to implement rhs function nobody|");
}

TEST_F(FunctionsTest, RoundingAndSpaceGiveSoarsNumbers) {
  EXPECT_EQ(Call("round-off", {F(7.26), F(0.1)}), "7.200000");
  EXPECT_EQ(Call("round-off", {I(35), I(10)}), "40");
  EXPECT_EQ(Call("round-off", {I(-7), I(2)}), "-8");
  EXPECT_EQ(Call("round-off", {F(7.77), I(2)}), "8");
  EXPECT_EQ(Call("round-off", {F(-7.25), F(0.5)}), "-7.000000");
  EXPECT_EQ(Call("round-off-heading", {F(355.6), F(2.0)}), "-4.000000");
  EXPECT_EQ(Call("round-off-heading", {I(190), I(10)}), "-170");
  EXPECT_EQ(Call("round-off-heading", {I(-180), I(1)}), "180");
  EXPECT_EQ(Call("round-off-heading", {F(5.5), I(2)}), "6");
  EXPECT_EQ(Call("round-off-heading", {F(185.4), F(0.5)}), "-174.500000");
  EXPECT_EQ(Call("round-off", {I(37), I(-10)}), "30");
  EXPECT_EQ(Call("round-off", {F(7.99), F(0.3)}), "7.800000");
  EXPECT_EQ(Call("round-off", {S("a"), I(3)}), "0");
  EXPECT_EQ(Call("compute-heading", {F(0.9), I(0), F(1.1), I(1)}), "44");
  EXPECT_EQ(Call("compute-range", {F(0.9), F(0.9), F(2.1), F(2.1)}), "1");
  EXPECT_EQ(Call("compute-heading", {I(0), I(0), I(1), I(1)}), "44");
  EXPECT_EQ(Call("compute-heading", {I(0), I(0), I(0), I(-5)}), "-179");
  EXPECT_EQ(Call("compute-heading", {I(0), I(0), I(1), I(-1)}), "135");
  EXPECT_EQ(Call("compute-heading", {I(2), I(2), I(2), I(2)}), "90");
  EXPECT_EQ(Call("compute-heading", {I(5), I(5), I(1), I(1)}), "-134");
  EXPECT_EQ(Call("compute-range", {F(1.5), F(1), F(4.5), F(5)}), "5");
  EXPECT_EQ(Call("predict-x", {I(10), I(20), I(90), I(5)}), "164");
  EXPECT_EQ(Call("predict-y", {I(10), I(20), I(90), I(5)}), "-413");
  EXPECT_EQ(Call("compute-dice-probability", {I(5), I(6), I(2), S("eq")}), "0.160751");
  EXPECT_EQ(Call("compute-dice-probability", {I(5), I(6), I(2), S("ge")}), "0.196245");
  EXPECT_EQ(Call("compute-dice-probability", {I(20), I(6), I(10), S("ge")}), "0.000599");
  EXPECT_EQ(Call("compute-dice-probability", {I(5), I(1), I(5), S("eq")}), "1.000000");
  EXPECT_EQ(Call("compute-dice-probability", {I(5), I(0), I(2), S("eq")}), "0.000000");
}

TEST_F(FunctionsTest, TheClosestPointLiesNearestToTheHeading) {
  const Symbol points = context_.NewIdentifier('P'), ahead = context_.NewIdentifier('A'),
               aside = context_.NewIdentifier('B');
  context_.MakePreference(points, S("p"), ahead);
  context_.MakePreference(points, S("p"), aside);
  context_.MakePreference(ahead, S("x"), I(1));
  context_.MakePreference(ahead, S("y"), F(20));
  context_.MakePreference(aside, S("x"), I(15));
  context_.MakePreference(aside, S("y"), I(0));
  EXPECT_EQ(Call("compute-closest-intercept", {I(0), I(0), I(0), points}), "A1");
  EXPECT_EQ(Call("compute-closest-intercept", {I(0), I(0), I(90), points}), "B1");
}

TEST_F(FunctionsTest, RandomFunctionsFollowTheStream) {
  EXPECT_EQ(Call("rand-float", {}), "0.417022");
  EXPECT_EQ(Call("rand-float", {I(10)}), "9.971848");
  EXPECT_EQ(Call("rand-int", {I(0)}), "3093770124");
  EXPECT_EQ(Call("rand-int", {I(1)}), "0");
  EXPECT_EQ(Call("rand-int", {I(10)}), "9");
  EXPECT_EQ(Call("rand-int", {I(100)}), "75");
  EXPECT_EQ(Call("rand-int", {}), "4290846341");
  context_.random().Seed(1);
  EXPECT_EQ(Call("rand-int", {I(9999999999)}), "946286476");
  context_.random().Seed(1);
  EXPECT_EQ(Call("rand-int", {F(2.9)}), "1");
}

TEST_F(FunctionsTest, TextFunctionsGiveStrings) {
  EXPECT_EQ(Call("concat", {S("owl"), S("-"), I(12), S("/"), F(2.5)}), "|owl-12/2.500000|");
  EXPECT_EQ(Call("concat", {I(1), I(2)}), "|12|");
  EXPECT_EQ(Call("string", {F(2.5)}), "|2.50000000000000000|");
  EXPECT_EQ(Call("trim", {S("  two words  ")}), "|two words|");
  EXPECT_EQ(Call("strlen", {I(1234)}), "4");
  EXPECT_EQ(Call("make-constant-symbol", {S("owl"), I(12)}), "owl121");
  EXPECT_EQ(Call("make-constant-symbol", {S("owl"), I(12)}), "owl122");
  EXPECT_EQ(Call("make-constant-symbol", {}), "constant3");
  EXPECT_EQ(Call("ifeq", {I(3), F(3), S("yes"), S("no")}), "no");
}

TEST_F(FunctionsTest, SetFunctionsFollowPathsAndSkipWhatIsNoNumber) {
  const Symbol bag = context_.NewIdentifier('B'), box = context_.NewIdentifier('K');
  for (const Symbol value : {I(1), I(2), F(3.5), S("word")}) context_.MakePreference(bag, S("n"), value);
  context_.MakePreference(bag, S("k"), box);
  context_.MakePreference(box, S("v"), I(1));
  context_.MakePreference(box, S("v"), I(2));
  EXPECT_EQ(Call("set-count", {bag, S("n")}), "4");
  EXPECT_EQ(Call("set-sum", {bag, S("n")}), "6.500000");
  EXPECT_EQ(Call("set-mean", {bag, S("n")}), "2.166667");
  EXPECT_EQ(Call("set-stdev", {bag, S("n")}), "1.027402");
  EXPECT_EQ(Call("set-range", {bag, S("n")}), "2.500000");
  EXPECT_EQ(Call("set-sum", {bag, S("k"), S("v")}), "3.000000");
  EXPECT_EQ(Call("set-sum", {bag, S("n"), S("n"), S("n"), S("n")}), "NaN");
  EXPECT_EQ(Call("set-count", {I(5), S("n")}), "|\\|ERROR: First parameter needs to be an identifier.\\||");
  EXPECT_EQ(Call("set-max", {bag, S("none")}), "NaN");
  EXPECT_EQ(Call("sum", {box}), "3");
  EXPECT_EQ(Call("sum", {bag}), "3");  // Soar's sum and product use only integers.
  EXPECT_EQ(Call("product", {bag}), "0");
  EXPECT_EQ(Call("size", {bag}), "5");
}

TEST_F(FunctionsTest, DeepCopyKeepsSharingAndLoops) {
  const Symbol plan = context_.NewIdentifier('O'), leaf = context_.NewIdentifier('A');
  context_.MakePreference(plan, S("left"), leaf);
  context_.MakePreference(plan, S("right"), leaf);
  context_.MakePreference(leaf, S("up"), plan);
  EXPECT_EQ(Call("deep-copy", {plan}), "D1");
  const Symbol copy = context_.symbols().FindIdentifier('D', 1),
               copied_leaf = context_.symbols().FindIdentifier('A', 2);
  ASSERT_EQ(context_.objects[copy.bits()].size(), 2u);
  EXPECT_EQ(context_.objects[copy.bits()][0].value, copied_leaf);
  EXPECT_EQ(context_.objects[copy.bits()][1].value, copied_leaf);
  EXPECT_EQ(context_.objects[copied_leaf.bits()][0].value, copy);
  EXPECT_EQ(Call("deep-copy", {I(5)}), "|*symbol not id*|");
}

TEST_F(FunctionsTest, XmlBecomesElementsNamedByItsTags) {
  const std::string told =
      Call("from-st-xml", {S("<?xml version=\"1.0\"?><top a='1'><kid>text</kid><!-- no --><kid value=\"7\"/>"
                             "<box><z>x &amp; y</z></box></top>")});
  EXPECT_EQ(told, "T1");
  const auto& parts = context_.objects[context_.symbols().FindIdentifier('T', 1).bits()];
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_EQ(parts[0].attribute, S("box"));
  EXPECT_EQ(parts[1].value, S("7"));
  EXPECT_EQ(parts[2].value, S("text"));
  EXPECT_EQ(context_.objects[parts[0].value.bits()].at(0).value, S("x & y"));
  EXPECT_EQ(Call("from-st-xml", {S("<state/>")}), "I1");
  for (const char* text :
       {"", "text", "<a>", "<a></b>", "<a>&no;</a>", "<a b></a>", "<a b=\"1></a>", "<a/><b/>", "<!-- "}) {
    EXPECT_EQ(Call("from-st-xml", {S(text)}), "Error: the text passed to from-st-xml is not one XML element\n") << text;
  }
}

TEST_F(FunctionsTest, NoFunctionMindsAnyNumberOrKindOfArguments) {
  const std::vector<Symbol> kinds = {S("a"), I(0), I(INT64_MIN), F(0.0), F(-1e300), context_.NewIdentifier('X'), S("")};
  for (std::uint16_t index = 0; index < BuiltinFunctions().size(); ++index) {
    for (std::size_t count = 0; count <= 5; ++count) {
      for (std::size_t first = 0; first < kinds.size(); ++first) {
        std::vector<Symbol> arguments;
        for (std::size_t i = 0; i < count; ++i) arguments.push_back(kinds[(first + i * 3) % kinds.size()]);
        Evaluate(context_, index, arguments);
      }
    }
  }
  EXPECT_TRUE(context_.halted);
}

}  // namespace
}  // namespace soarbox::kernel
